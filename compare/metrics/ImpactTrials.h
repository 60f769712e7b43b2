// SPDX-License-Identifier: MIT
// Restart per contact: the exact reference plays a scene; at each of its impacts every engine is started anew
// from the exact state at the beginning of that step, and what it does is held against the exact impact.
// Whole trajectories would measure chaos. docs/accuracy.md defines every figure.
#pragma once

#include "scene/Trial.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace Shapes::Compare {

enum class eOutcome {
  Correct,   ///< responded in the step of the impact, to the right side
  Late,      ///< responded to the same shape and to the right side, but one or two steps later
  WrongSide, ///< responded, but pushed to the far side
  Missed     ///< no response
};

/// The kind and part of the shape that was hit.
enum class ePair { Point, Segment, SegmentEnd, Circle, Arc, ArcEnd, Ball };
inline constexpr std::size_t g_nPairs = 7;
/// "point", "segment", "segment end", "circle", "arc", "arc end", "ball".
const char* GetName(ePair pair);
const char* GetName(eOutcome outcome);

/// An approach, or a ball, that is no faster than what gravity gives in so many steps is slow: an engine may
/// respond to a slow approach with a bounce, or let the ball rest or slide, and need not report the latter.
inline constexpr double g_fSlow = 2.0;
double GetSlowSpeed(const CScene& scene);
/// A slow impact is not judged where that makes a difference: if the ball leaves slowly, or if the bounce is
/// more than this share of the speed with which it leaves (radians).
inline constexpr double g_fRestingTurn = 0.01;

/// A ball that did not tunnel and is deeper in the shape than this share of its radius, at the end of the
/// step, overlaps.
inline constexpr float g_fOverlap = 0.01f;

/// Outcome and errors of one engine at one impact. Lengths are in radii of the ball.
struct CEngineContact {
  eOutcome m_eOutcome = eOutcome::Missed;

  // By its CollisionDetected at the end of the free flight; only if it detected the pair.
  bool m_bDetected = false;
  float m_fSetback = 0.0f;            ///< along its normal
  float m_fSetbackError = 0.0f;       ///< claimed centre at the impact against the exact one
  float m_fSetbackErrorNormal = 0.0f; ///< the part of it along the exact normal; above 0 is too far out
  float m_fTimeError = 0.0f;          ///< the part of it along the way of the ball, in steps; above 0 is late

  // By its world; only if the outcome is Correct or Late, and it reported the response.
  bool m_bReported = true;     ///< false if the ball rests or slides unreported after a slow approach
  float m_fPOIError = 0.0f;    ///< distance of the points of impact
  float m_fNormalError = 0.0f; ///< radians between the normals

  // By its world at the end of the step of the response, against the exact state then; only if m_bCompared:
  // the outcome is Correct or Late, and the exact ball had no other impact until then.
  bool m_bCompared = false;
  float m_fDirectionError = 0.0f; ///< radians between the velocities
  float m_fSpeedError = 0.0f;     ///< relative, signed
  float m_fEnergyError = 0.0f;    ///< of the kinetic energy of the ball, or of both, relative, signed
  float m_fPositionError = 0.0f;  ///< distance of the centres

  float m_fPenetration = 0.0f; ///< how deep the ball is in the shape at the end of the step, at least 0

  /// A response to the right side: Correct or Late. Otherwise the ball tunneled.
  bool HasTurnedBack() const { return m_eOutcome == eOutcome::Correct || m_eOutcome == eOutcome::Late; }
  bool HasTunneled() const { return !HasTurnedBack(); }

  bool operator==(const CEngineContact&) const = default;
};

/// One impact of the exact reference.
struct CContact {
  std::uint64_t m_nTrial;
  std::uint32_t m_nStep;
  std::uint32_t m_nBall;
  ePair m_ePair;
  float m_fTime;                 ///< of the impact, as a share of the step
  float m_fTravel;               ///< way of the ball in the step, in radii
  float m_fApproach;             ///< approach speed, user units per second
  float m_fIncidence;            ///< radians between the velocity and the normal, 0 head-on
  float m_fElasticity;           ///< product of both
  bool m_bHasDifference = false; ///< The first engine and FindOther detected the pair.
  float m_fDifference = 0.0f;    ///< between the centres that they claim, in radii
  std::vector<CEngineContact> m_stdEngines;
};

/// Steps and impacts that were seen and not judged, and why.
struct CExcluded {
  std::size_t m_nResting = 0;      ///< slow impacts after which a ball may rest or bounce
  std::size_t m_nAmbiguous = 0;    ///< grazes that are decided by rounding, and overlaps
  std::size_t m_nSimultaneous = 0; ///< where the order of two impacts at once decides
  std::size_t m_nUndecided = 0;    ///< trials that the reference gave up, or whose state an engine refused
  std::string m_sUndecided;        ///< the first of them: trial, step and what was said
};

/// The random trials of a measurement.
struct CTrials {
  std::uint64_t m_nSeed = 1;
  std::size_t m_nContacts = 0;     ///< impacts to judge
  std::uint64_t m_nMostTrials = 0; ///< gives up after so many
  /// Called now and then with the share that is done; what it throws ends the measurement.
  std::function<void(double)> m_stdProgress;
};

struct CImpactTrialOptions : CTrials {
  bool m_bAsk = true;    ///< also put each pair to CollisionDetected
  bool m_bGhosts = true; ///< also judge quiet steps
};

struct CImpactTrialResult {
  std::vector<CContact> m_stdContacts;
  /// Of each engine: quiet steps with a response to a shape that the exact ball does not touch in this step
  /// or the next two.
  std::vector<std::size_t> m_stdGhosts;
  /// Steps that were judged in which nothing happened and a ball passed a shape within a radius without
  /// touching it, counted for each such ball.
  std::size_t m_nQuietSteps = 0;
  std::uint64_t m_nTrials = 0;
  CExcluded m_cExcluded;
};

/// Plays random trials of the scene until there are enough impacts or trials.
CImpactTrialResult RunImpactTrials(const CScene& scene, const std::vector<CEngine>& engines,
                                   const CImpactTrialOptions& options);

} // namespace Shapes::Compare
