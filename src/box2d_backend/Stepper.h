// SPDX-License-Identifier: MIT
#pragma once

#include "../shapes/WorldState.h"

#include <box2d/box2d.h>

#include <utility>
#include <vector>

#include "Bodies.h"
#include "ContactGatherer.h"
#include "Convert.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// The shapes of a world as bodies of a b2World, and what is to be done before and after each of its steps,
/// whoever makes them.
class CStepper {
public:
  /// What a world with that description can hold.
  static CWorldLimits GetLimits(const CWorldDesc& desc, const CTuning& tuning);

  /// Makes a body for all that is in the state, in the order of ids. The state, the statistics and the ties
  /// have to outlive it.
  CStepper(b2World& world, CWorldState& state, CWorldStats& stats, const CWorldDesc& desc,
           const CTuning& tuning, CTies* pTies = nullptr);

  /// To be told of what happens in the b2World.
  CContactGatherer& GetListener() { return m_cGatherer; }
  /// In metres; 0 if it does not run.
  b2Vec2 GetGravity() const {
    return m_cRunning.Has(eEffect::Gravity) ? m_cScale.ToMetres(m_cState.m_vGravity) : b2Vec2_zero;
  }

  /// @return whether it was another one before
  bool SetGravity(const b2Vec2& g) {
    const Vector2 before = std::exchange(m_cState.m_vGravity, m_cScale.FromMetres(g));
    return before != m_cState.m_vGravity;
  }

  // As a world is told of its changes.
  void OnAdded(CShapeId id);
  void OnRemoved(CShapeId id);
  void OnChanged(CShapeId id, CWorld::eChange what);
  void RemoveAll() { m_cBodies.RemoveAll(); }
  /// A fixture of that shape was destroyed by somebody else: what is left of its body is no concern of ours.
  /// @return false if that was known
  bool OnLost(CShapeId id);

  /// To be told before the first substep, and whenever the content has changed.
  /// @param running  the effects that run
  void Plan(CEffects running);
  /// Makes Box2D's own mixing of restitutions give what the listener gives.
  /// @return false where there is no way to do so, or where the listener is needed anyway
  bool NeedsNoListener();

  void BeginSubstep();
  /// Parts into which dt seconds have to be cut so that Box2D slows nothing down.
  unsigned CountCuts(float dt) const;
  /// Before each b2World::Step of h seconds, and after it.
  void BeforeStep(float h);
  void AfterStep();
  /// Where balls were answered on their way through the last step.
  struct CBend {
    std::size_t m_nBall;
    Vector2 m_vPos;
    float m_fPart; ///< of the step, 0 .. 1
  };
  std::vector<CBend> GetBends() const;
  /// Takes over into the state what has become of the balls in dt seconds, and turns the other shapes.
  void EndSubstep(float dt);
  void TakeBalls();
  std::vector<CContactEvent> TakeContacts() { return m_cGatherer.TakeContacts(); }

private:
  bool HasParabolas() const;
  void NoteJoints(CShapeId id);
  void JoinShapes();
  void CountClamped(float h);
  void TurnShapes(float dt);

  CWorldState& m_cState;
  CWorldStats& m_cStats;
  CTuning m_cTuning;
  CScale m_cScale;
  CBodies m_cBodies;
  CContactGatherer m_cGatherer;
  CEffects m_cRunning;
  bool m_bJointsChanged = false;
};

} // namespace Shapes::Box2D
