// SPDX-License-Identifier: MIT
// An engine behind a world: what it has to do, and in which order it is called.
#pragma once

#include <Shapes/Backend.h>
#include <Shapes/Limits.h>
#include <Shapes/World.h>

#include <memory>
#include <string_view>

namespace Shapes {

/// The world as its engine sees it: WorldCore.h.
using CWorldCore = CWorld::CImpl;

/// The lengths, speeds and masses that an engine can hold, in user units; the world refuses anything beyond.
struct CWorldLimits {
  float m_fMaxLength = g_fMaxLength;
  float m_fMaxSpeed = g_fMaxSpeed;
  float m_fMinMass = g_fMinMass;
  float m_fMaxMass = g_fMaxMass;
  friend bool operator==(const CWorldLimits&, const CWorldLimits&) = default;
};

/// The kind of a change of a shape or a ball.
enum class eChange {
  Pose,      ///< where it is, its rotation centre with it
  RotCenter, ///< it stays where it is
  Reset,     ///< both
  Motion,    ///< velocity or rotation speed
  Sensor,    ///< it became a sensor, or ceases to be one
  Filter,    ///< it meets others
  CanCollide,
  Properties ///< elasticity, user pointer
};

/// The kind of the call that the user is about to make.
enum class eAccess { Read, Change, SetGravity, Step, SaveLoad };

/// All that the next step of an engine depends on beyond the state.
struct CEngineMemory {
  virtual ~CEngineMemory() = default;
};

/// Steps the shapes and balls in the state of its world. It is made with the world, when the state is empty,
/// and called in this order (tests/world/EngineTest.cpp keeps it):
///
///   Access           before everything that the user does
///   Added, Removed, Changed
///                    once after each change of the state
///   Plan             before the first Substep, and before the next one where the set of running effects is
///                    another one; what depends on anything else follows from Added, Removed and Changed
///   Substep          m_nSubsteps times for each Step; it leaves in the state where everything is then
///   Save             after the state was copied
///   Loaded           after the state was replaced; instead of Added and Removed for what is in it
class CEngine {
public:
  virtual ~CEngine() = default;

  /// May refuse by an exception; brings the state up to date if something else than this world moves it.
  virtual void Access(eAccess) {}
  virtual void Added(CShapeId id) = 0;
  /// @param pShape  none if it was a ball; an engine may keep it
  virtual void Removed(CShapeId id, std::unique_ptr<CShape> pShape) = 0;
  virtual void Changed(CShapeId id, eChange change) = 0;
  /// @param running  the effects that run
  virtual void Plan(CEffects running) = 0;
  /// Moves kinematic shapes and balls, within the limits of places and speeds, and sets where each ball was
  /// before (m_stdPrevPos, which sensors read); reports contacts and counts (Stats.h) in the world. An engine
  /// whose balls do not sleep sets CDisturbed::m_bIsEverywhere.
  /// @param dt  seconds
  virtual void Substep(float dt) = 0;
  /// @returns what is kept with the copy of the state, for Loaded; none if nothing has to be. A world that
  ///          goes on and one that loads the copy take the same steps.
  virtual std::shared_ptr<const CEngineMemory> Save() { return nullptr; }
  /// @param pMemory  what Save has returned, perhaps that of an engine of another kind; null if nothing
  virtual void Loaded(const CEngineMemory* pMemory) = 0;

  /// How far apart it holds what lies on each other, user units.
  virtual float GetTouchReach() const { return 0.0f; }
};

/// One row of the table of engines.
struct CBackend::CEntry {
  std::string_view m_sName;
  /// CBackend::CollisionDetected for two shapes that can collide: fills in all but the approach speed.
  bool (*m_pCollide)(CContactDesc& c);
  /// CBackend::MakeWorld.
  std::unique_ptr<CWorld> (*m_pMakeWorld)(const CWorldDesc& desc);
};

} // namespace Shapes
