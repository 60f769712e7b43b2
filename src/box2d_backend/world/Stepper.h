// SPDX-License-Identifier: MIT
#pragma once

#include "../../world/WorldCore.h"

#include <box2d/box2d.h>

#include <utility>

#include "../Convert.h"
#include "../contact/ContactGatherer.h"
#include "Bodies.h"
#include "Tuning.h"

namespace Shapes::Box2D {

/// The shapes of a world as bodies of a b2World, and the work before and after each of its steps, by the
/// library or by a game.
class CStepper {
public:
  /// The limits of a world with that description.
  static CWorldLimits GetLimits(const CWorldDesc& desc, const CTuning& tuning);

  /// Makes a body for each shape and ball in the state of the world, in the order of ids. The world and the
  /// watch have to outlive it.
  CStepper(b2World& b2, CWorldCore& world, const CTuning& tuning, CDestructionWatch* pWatch = nullptr);

  /// The listener to install in the b2World.
  CContactGatherer& GetListener() { return m_cGatherer; }
  /// The skin of edges, above which balls hover, and what Box2D leaves of an overlap; user units.
  float GetTouchReach() const { return m_cScale.FromMetres(b2_polygonRadius + b2_linearSlop); }
  /// In metres; 0 if it does not run.
  b2Vec2 GetGravity() const {
    return m_cRunning.Has(eEffect::Gravity) ? m_cScale.ToMetres(m_cState.m_vGravity) : b2Vec2_zero;
  }

  /// @return whether it was another one before
  bool SetGravity(const b2Vec2& g) {
    const Vector2 before = std::exchange(m_cState.m_vGravity, m_cScale.FromMetres(g));
    return before != m_cState.m_vGravity;
  }

  // As of CEngine.
  void Added(CShapeId id);
  void Removed(CShapeId id);
  void Changed(CShapeId id, eChange change);
  void RemoveAll() { m_cBodies.RemoveAll(); }
  bool IsEmpty() const { return m_cBodies.IsEmpty(); }
  /// The game has destroyed a fixture of that shape: the rest of its body is the game's.
  /// @return false if that was known
  bool OnLost(CShapeId id);

  /// To be called before the first substep, and whenever the content has changed.
  /// @param running  the effects that run
  void Plan(CEffects running);
  /// Makes Box2D's own mixing of restitutions give what the listener gives.
  /// @return false where there is no way to do so, or where the listener is needed anyway
  bool NeedsNoListener();

  void BeginSubstep();
  /// Parts into which dt seconds have to be cut so that Box2D slows nothing down.
  unsigned CountSubsteps(float dt);
  /// Before each b2World::Step of h seconds, and after it.
  void BeforeStep(float h);
  void AfterStep();
  /// Tells the world where balls bounced on their paths through the last step, and at which part of the
  /// substep: partOf(part of the step).
  template <class F>
  void AddPathVertices(const F& partOf) {
    for (const CContactGatherer::CPathVertex& vertex : m_cGatherer.GetPathVertices())
      if (const std::size_t i = m_cState.FindBall(vertex.m_cBall); i != CWorldState::npos)
        m_cWorld.AddPathVertex(i, m_cScale.FromMetres(vertex.m_vPos),
                               partOf(static_cast<float>(vertex.m_fPart)));
  }
  /// Copies the balls into the state after dt seconds, turns the other shapes, and reports the contacts.
  void EndSubstep(float dt);
  void TakeBalls();
  void KeepMasses() { m_cBodies.KeepMasses(m_cState.m_cBalls); }

private:
  bool HasParabolas() const;
  void NoteSharedEnds(CShapeId id);
  void UpdateSharedEnds();
  void CountClamped(float h);
  void MoveShapes(float dt);

  CWorldCore& m_cWorld;
  CWorldState& m_cState;
  CWorldStats& m_cStats;
  CTuning m_cTuning;
  CScale m_cScale;
  CBodies m_cBodies;
  CContactGatherer m_cGatherer;
  CEffects m_cRunning;
  bool m_bSharedEndsChanged = false;
};

} // namespace Shapes::Box2D
