// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "../world/Bodies.h"
#include "PreSolveOverride.h"

namespace Shapes::Box2D {

/// Listens to a b2World: makes the elasticity the product of both, puts contacts right where the tuning says
/// so, and collects them in the library's terms.
class CContactGatherer : public b2ContactListener {
public:
  CContactGatherer(CBodies& bodies, const CScale& scale, const CTuning& tuning)
      : m_cBodies(bodies), m_cScale(scale), m_cTuning(tuning) {}

  /// Collects contacts for Events and Sensors, and the vertices of the paths of balls for Sensors, if they
  /// run.
  void Collect(CEffects running) {
    m_bPathVertices = running.Has(eEffect::Sensors);
    m_bContacts = m_bPathVertices || running.Has(eEffect::Events);
  }
  bool Collects() const { return m_bContacts; }

  /// To be called before each b2World::Step.
  /// @param g  gravity in metres; of worlds that follow parabolas, else 0
  /// @param h  length of the step, seconds
  /// @param weight  of all balls in lasting contact, newtons
  void BeginStep(const b2Vec2& g, float h, float weight);

  void PreSolve(b2Contact* pContact, const b2Manifold* pOld) override;
  /// In a game's b2World, before PreSolve; and after it, if the game's listener has disabled that contact, so
  /// that the ball passes.
  void Remember(const b2Contact& contact);
  void Pass();
  /// After PreSolve, in a game's b2World: one of our balls hits a body of the game. Box2D, or the game,
  /// resolves it.
  void CollideWithOther(b2Contact& contact);
  void PostSolve(b2Contact* pContact, const b2ContactImpulse* pImpulse) override;

  /// The contacts since the last call, one for each ball and shape that met, the fastest of several, by
  /// ball and then by shape.
  std::vector<CContactEvent> TakeContacts();

  /// How often Box2D has asked since the last call.
  std::uint64_t TakeAsked() { return std::exchange(m_nAsked, 0); }

  /// Where a ball bounced on its path through the last step.
  struct CPathVertex {
    CShapeId m_cBall;
    b2Vec2 m_vPos;
    double m_fPart; ///< of the step, in [0, 1]
  };
  const std::vector<CPathVertex>& GetPathVertices() const { return m_stdPathVertices; }

private:
  bool CanWait(const CBody& shape, const CBody& ball);
  /// Whether it follows balls on their way through a step.
  bool Follows() const { return m_bPathVertices || m_cTuning.m_bExactContacts || m_cTuning.m_bParabolas; }
  float RestitutionOf(const CBody& shape, const CBody& ball) const;
  void ReportAsIs(b2Contact& contact, const CBody& shape, const CBody& ball);
  void Report(const CBody& shape, const CBody& ball, const CPreSolveOverride::CResolution& resolution);
  void AddImpulse(const CBody* pA, const CBody* pB, const b2ContactImpulse& impulse);

  CBodies& m_cBodies;
  CScale m_cScale;
  CTuning m_cTuning;
  CPreSolveOverride m_cOverride;
  struct CBefore {
    CBody* m_pBody = nullptr;
    CParabolicCorrection m_cCorrection;
    const CBody* m_pBouncedOff = nullptr;
    bool m_bIsSupported = false, m_bLiesOnOwn = false;
  };
  CBefore m_cBefore[2]; // the last call of PreSolve: of both bodies
  CPreSolveOverride::CMark m_cMark;
  bool m_bContacts = true, m_bPathVertices = true;
  std::uint64_t m_nAsked = 0;
  /// The impulse with which the solver has pushed a ball and another one apart.
  struct CSolved {
    CTouchingPair m_cPair;
    float m_fImpulse; ///< newton seconds
  };
  std::vector<CContactEvent> m_stdEvents;
  std::vector<CSolved> m_stdSolved;
  std::vector<CPathVertex> m_stdPathVertices;
};

} // namespace Shapes::Box2D
