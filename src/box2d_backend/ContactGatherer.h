// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/World.h>

#include <box2d/box2d.h>

#include <vector>

#include "Bodies.h"
#include "TrueAnswers.h"

namespace Shapes::Box2D {

/// Listens to a b2World: makes the elasticity the product of both, puts contacts right where the tuning says
/// so, and collects them in the library's terms.
class CContactGatherer : public b2ContactListener {
public:
  CContactGatherer(CBodies& bodies, const CScale& scale, const CTuning& tuning)
      : m_cBodies(bodies), m_cScale(scale), m_cTuning(tuning) {}

  /// Collects contacts for Events and Sensors, and where balls bend their ways for Sensors, if they run.
  void Collect(CEffects running) {
    m_bBends = running.Has(eEffect::Sensors);
    m_bContacts = m_bBends || running.Has(eEffect::Events);
  }
  bool Collects() const { return m_bContacts; }

  /// To be called before each b2World::Step.
  /// @param g  gravity in metres; of worlds that follow parabolas, else 0
  /// @param h  length of the step, seconds
  void BeginStep(const b2Vec2& g, float h);

  void PreSolve(b2Contact* pContact, const b2Manifold* pOld) override;
  /// After PreSolve, in a game's b2World: one of our balls meets what is not ours. Box2D, or the game,
  /// answers it.
  void MeetOther(b2Contact& contact);
  void PostSolve(b2Contact* pContact, const b2ContactImpulse* pImpulse) override;

  /// The contacts since the last call, one for each ball and shape that met, the fastest of several, by ball
  /// and then by shape.
  std::vector<CContactEvent> TakeContacts();

  /// Where a ball was answered on its way through the last step.
  struct CBend {
    CShapeId m_cBall;
    b2Vec2 m_vPos;
    double m_fPart; ///< of the step, in [0, 1]
  };
  const std::vector<CBend>& GetBends() const { return m_stdBends; }

private:
  bool CanWait(const CBody& shape, const CBody& ball);
  /// Whether it follows balls on their way through a step.
  bool Follows() const { return m_bBends || m_cTuning.m_bTrueContacts || m_cTuning.m_bParabolas; }
  float RestitutionOf(const CBody& shape, const CBody& ball) const;
  void ReportAsIs(b2Contact& contact, const CBody& shape, const CBody& ball);
  void Report(const CBody& shape, const CBody& ball, const CTrueAnswers::CAnswer& answer);

  CBodies& m_cBodies;
  CScale m_cScale;
  CTuning m_cTuning;
  b2Vec2 m_vGravity{0.0f, 0.0f};
  float m_fStep = 0.0f;
  CTrueAnswers m_cAnswers;
  bool m_bContacts = true, m_bBends = true;
  std::vector<CContactEvent> m_stdEvents;
  std::vector<CBend> m_stdBends;
};

} // namespace Shapes::Box2D
