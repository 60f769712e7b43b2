// SPDX-License-Identifier: MIT
// Worlds: descriptors go in, ids come out, Step moves everything, contacts come out as an array.
#pragma once

#include <Shapes/Arc.h>
#include <Shapes/Backend.h>
#include <Shapes/Circle.h>
#include <Shapes/DynamicCircle.h>
#include <Shapes/Effects.h>
#include <Shapes/LineSeg.h>
#include <Shapes/Point.h>
#include <Shapes/Tolerances.h>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace Shapes {

class CFastMoves;
class CSensors;
class CWorldState;
struct CContent;

/// How Box2D is used; the native engine reads none of it. docs/box2d_differences.md has the figures.
enum class eProfile {
  Shipped, ///< As Box2D ships: only elasticity (the product of both), friction (none), spin of balls (none)
           ///< and sleep (never) are the library's; and what no effect calls for is off.
  Tuned    ///< As accurate as Box2D can be made, for more time.
};

/// What a world is made from. Everything but the last group means the same on every engine.
class CWorldDesc {
public:
  Vector2 m_vGravity = Vector2::Zero(); ///< User units per second squared.
  float m_fTimeStep = 1.0f / 60.0f;     ///< Seconds per Step, above 0.
  unsigned m_nSubsteps = 1;             ///< Equal parts into which a Step is cut, 1 .. g_nMaxSubsteps.
  CEffectChoice m_cEffects;             ///< No effect may be both forced and forbidden.

  // Read by Box2D only, whose tolerances are in metres.
  eProfile m_eProfile = eProfile::Shipped;
  float m_fLengthUnit = 1.0f; ///< User units per metre (100 for 100 pixels per metre), from g_fMinLengthUnit.
  float m_fSagittaTolerance = g_fSagittaTolerance; ///< Height of arcs above their chords, in metres, above 0.
  unsigned m_nVelocityIterations = 8;              ///< Per substep, 1 .. 1000.
  unsigned m_nPositionIterations = 3;              ///< Per substep, 1 .. 1000.
};

/// Names a shape in its world. Never used again after the shape is removed. The default names none.
struct CShapeId {
  std::uint32_t m_nValue = 0;
  friend auto operator<=>(const CShapeId&, const CShapeId&) = default;
};

/// A contact of a ball during the last Step. A sensor gives one for each ball that touched it at any time of
/// a substep, with POI and normal at the end if they touch then, and else where they were closest.
struct CContactEvent {
  /// The shape that was met; of two balls the one that was added later. None (the default) for what is in a
  /// game's b2World and not of Shapes.
  CShapeId m_cShape;
  CShapeId m_cBall; ///< The ball; of two balls the one that was added first.
  Vector2 m_vPOI;   ///< Point of impact, user units.
  Vector2 m_vNorm;  ///< Unit normal from the shape to the ball.
  /// Native: how far along the normal the ball was set back. Box2D worlds do not, sensors do not: 0.
  float m_fSetback = 0.0f;
  /// Approach speed before the response, units per second, at least 0. Of sensors by the way of the ball,
  /// whose places are rounded.
  float m_fSpeed = 0.0f;
  bool m_bIsSensor = false; ///< Either of them is a sensor: there was no response.
};

/// A ball and a sensor (a shape, or a ball that is one) begin or cease to touch. Every begin has its end: it
/// comes when they part, and in the next Step where one of the two was removed, or is no sensor any more.
struct CSensorEvent {
  CShapeId m_cShape; ///< As in CContactEvent.
  CShapeId m_cBall;
  bool m_bBegin = false;
  friend bool operator==(const CSensorEvent&, const CSensorEvent&) = default;
};

/// Counters since the world was made.
struct CWorldStats {
  std::uint64_t m_nSteps = 0;
  std::uint64_t m_nSubsteps = 0;
  /// Substeps in which an effect ran, by eEffect.
  std::array<std::uint64_t, static_cast<std::size_t>(eEffect::Size)> m_stdSubstepsWith{};
  std::uint64_t GetSubstepsWith(eEffect e) const { return m_stdSubstepsWith[static_cast<std::size_t>(e)]; }
  std::uint64_t m_nBallsAccelerated = 0; ///< Times that gravity was added to the velocity of a ball.
  std::uint64_t m_nShapesTurned = 0;     ///< Times that a shape was turned by its rotation speed.
  std::uint64_t m_nShapeTests = 0; ///< Native: pair kernels called for a ball and a shape that is not a ball.
  std::uint64_t m_nBallTests = 0;  ///< Native: pair kernels called for two balls.
  std::uint64_t m_nSweeps = 0;     ///< Native: times of impact looked for, of a ball with a shape or a ball.
  std::uint64_t m_nBallsSwept = 0; ///< Native: balls that had something on their way, once for each substep.
  std::uint64_t m_nBallsHalted =
      0; ///< Native: balls that had more than g_nMaxImpacts in a substep, and stayed where they were then.
  std::uint64_t m_nSensorTests = 0; ///< Ways of balls that were looked at for a sensor.
  /// Contacts that were responded to. Box2D: only where Events or Sensors runs; else nobody hears of them.
  std::uint64_t m_nContacts = 0;
  std::uint64_t m_nSensorHits = 0;   ///< Contacts of sensors.
  std::uint64_t m_nReported = 0;     ///< Contacts of both kinds that GetContacts told.
  std::uint64_t m_nSpeedsCapped = 0; ///< Responses after which a ball had to be cut to g_fMaxSpeed.
  std::uint64_t m_nMovesClamped =
      0; ///< Box2D: ball steps longer than its 2 metres; Box2D slows such a ball down.
  std::uint64_t m_nTurnsClamped =
      0; ///< Box2D: shape steps of more than its pi/2 radians; Box2D turns it by less.
  std::uint64_t m_nEngineSteps =
      0;                          ///< Box2D: calls of b2World::Step; tuned worlds cut substeps of fast ones.
  std::uint64_t m_nArcPieces = 0; ///< Box2D: chords that stand for the arcs that are in the world now.
  /// In a game's b2World: shapes whose bodies the game has destroyed.
  std::uint64_t m_nBodiesLost = 0;
  /// In a game's b2World: how often the game had put another contact listener in the place of ours.
  std::uint64_t m_nListenersReplaced = 0;
};

using CAnyShapeDesc = std::variant<CPointDesc, CLineSegDesc, CCircleDesc, CArcDesc, CDynamicCircleDesc>;

/// What an engine can hold, in user units; anything beyond is refused before it is told of it.
struct CWorldLimits {
  float m_fMaxLength = g_fMaxLength;
  float m_fMaxSpeed = g_fMaxSpeed;
  float m_fMinMass = g_fMinMass;
  float m_fMaxMass = g_fMaxMass;
  friend bool operator==(const CWorldLimits&, const CWorldLimits&) = default;
};

/// A copy of all that a world holds, made by SaveState. Cheap to copy.
class CSavedState {
private:
  friend class CWorld;
  std::shared_ptr<const CWorldState> m_pState;
};

/// Owns its shapes and steps them. Functions that take an id throw std::invalid_argument if no shape has it,
/// or if the shape is not of the kind that the function is for; nothing has changed then. Worlds are made by
/// CBackend::MakeWorld or MakeWorld below.
class CWorld {
public:
  /// For engines only: what has changed of a shape.
  enum class eChange { Pose, Motion, Sensor, Properties };

  virtual ~CWorld();
  CWorld(const CWorld&) = delete;
  CWorld& operator=(const CWorld&) = delete;

  const CWorldDesc& GetDesc() const { return m_cDesc; }
  /// @throws std::invalid_argument if g is not finite or too large
  void SetGravity(const Vector2& g);

  /// Adds a shape; m_eMotionType says whether it is static or kinematic.
  /// @throws std::invalid_argument naming the field and the value that is not valid; nothing is added then
  CShapeId Add(const CPointDesc& desc);
  CShapeId Add(const CLineSegDesc& desc);
  CShapeId Add(const CCircleDesc& desc);
  CShapeId Add(const CArcDesc& desc);
  CShapeId Add(const CDynamicCircleDesc& desc);
  CShapeId Add(const CAnyShapeDesc& desc);
  /// Adds a compound: kinematic shapes about one rotation centre with one rotation speed. All or none is
  /// added.
  std::vector<CShapeId> AddCompound(std::span<const CAnyShapeDesc> descs, const Vector2& rotCenter,
                                    float revsPerSecond = 0.0f);
  void Remove(CShapeId id);
  bool Contains(CShapeId id) const;

  /// Moves everything by the time step of the description.
  void Step();
  /// The contacts of the last Step, in the order in which they were responded to; after those of each substep
  /// what sensors saw in it, by ball and then by shape. Valid until the next change.
  std::span<const CContactEvent> GetContacts() const { return m_stdContacts; }
  /// What sensors saw in the last Step, in the order in which it happened, substep by substep; within one by
  /// ball and then by shape. A ball that crosses a sensor within a step is seen too: it begins and ends.
  std::span<const CSensorEvent> GetSensorEvents() const { return m_stdSensorEvents; }
  const CWorldStats& GetStats() const;

  /// What the next substep will simulate, from what is in the world now.
  CEffects GetEffects() const;
  /// The same in words: a line for each effect with its name, whether it runs, and why. "Kinematics: runs; 2
  /// shapes rotate".
  std::string ExplainEffects() const;

  // Of any shape.
  eShape GetShapeType(CShapeId id) const;
  eMotion GetMotionType(CShapeId id) const;
  const Vector2& GetPos(CShapeId id) const;
  /// @throws std::invalid_argument if the shape would be beyond the limits of the engine there
  void SetPos(CShapeId id, const Vector2& p);
  float GetElasticity(CShapeId id) const;
  void SetElasticity(CShapeId id, float e);
  bool GetSensor(CShapeId id) const;
  void SetSensor(CShapeId id, bool b);
  bool GetCanCollide(CShapeId id) const;
  void SetCanCollide(CShapeId id, bool b = true);
  void* GetUserPtr(CShapeId id) const;
  void SetUserPtr(CShapeId id, void* p);

  // Of shapes that are not balls.
  /// All of them, in the order of their ids.
  std::vector<CShapeId> GetShapeIds() const;
  /// The shape as it is now, to draw it or ask it. Valid until it is removed or a state is loaded.
  const CShape& GetShape(CShapeId id) const;
  float GetOrientation(CShapeId id) const;
  void SetOrientation(CShapeId id, float angle);
  float GetRotSpeed(CShapeId id) const;
  void SetRotSpeed(CShapeId id, float revsPerSecond);
  const Vector2& GetRotCenter(CShapeId id) const;
  void SetRotCenter(CShapeId id, const Vector2& center);
  /// Puts a kinematic shape back to its pose when it was added.
  void Reset(CShapeId id);

  // Of balls.
  const Vector2& GetVel(CShapeId id) const;
  void SetVel(CShapeId id, const Vector2& v);
  float GetRadius(CShapeId id) const;
  float GetMass(CShapeId id) const;
  /// All balls in the order of their ids, one array for each property. Valid until a ball is added or
  /// removed, or a state is loaded.
  std::span<const CShapeId> GetBallIds() const;
  std::span<const Vector2> GetBallPositions() const;
  std::span<const Vector2> GetBallVelocities() const;

  /// All shapes, their poses and properties, and the gravity; not the statistics or the contacts. A world
  /// that goes on after SaveState, and one that goes on after LoadState of it, have the same bits on the same
  /// engine.
  CSavedState SaveState();
  /// @throws std::invalid_argument if the state was made by nobody (default constructed), or if this
  /// world cannot hold what another one saved; nothing has changed then
  void LoadState(const CSavedState& state);

protected:
  /// @param needs  effects that the engine runs wherever they are not forbidden
  CWorld(const CWorldDesc& desc, const CWorldLimits& limits, CEffects needs = {});

  CWorldState& State() { return *m_pState; }
  const CWorldState& State() const { return *m_pState; }
  /// Whether Continuous is to be decided in each substep, by MovesFast.
  bool IsContinuousOpen() const { return m_bIsContinuousOpen; }
  /// Changes whenever what runs, or anything else that an engine's plan of a substep may depend on, might
  /// have: whatever is not a velocity.
  std::uint64_t GetContentVersion() const { return m_nContentVersion; }
  /// @param kick  what is still to be added to the velocities in the substep that begins
  bool MovesFast(const Vector2& kick) const;
  const CFastMoves& GetFastMoves() const { return *m_pFastMoves; }
  /// What gravity adds to the velocities in a substep, if it runs.
  Vector2 GetKick() const;
  /// Continuous runs in this substep; to be called where it was decided.
  void CountContinuous() { ++m_nContinuous; }
  /// Whether Continuous runs is for somebody else to say, who says so.
  void ContinuousIsGiven(bool runs);
  /// What Sensors, GetContacts and the like have to be told of is different from what it was.
  void ContentChanged() { m_bContentChanged = true; }

  /// Whether it runs in this substep; of Continuous only if it runs in any case.
  bool Runs(eEffect e) const { return m_cRunning.Has(e); }
  /// All that run.
  CEffects GetRunning() const { return m_cRunning; }
  /// For GetContacts, if Events runs; whoever responds to a contact counts it, too.
  void Report(const CContactEvent& event);
  /// For Substep of an engine that answers contacts on the way: ball (its index) was at p when the share t of
  /// the substep was over, 0 .. 1, told in the order of time. Sensors see a way that is straight in between.
  void Bend(std::size_t ball, const Vector2& p, float t);
  CWorldStats& Stats() { return m_cStats; }

  /// What Step does around the substeps, for an engine that is stepped by somebody else.
  void BeginStep();
  void EndSubstep(float dt);
  void EndStep();
  /// Takes a shape out of the state, of which the engine knows that it is gone.
  /// @return false if there is none of that id
  bool Forget(CShapeId id);

  /// What is about to be done with the world.
  enum class eAccess { Read, Change, SetGravity, Step, SaveLoad };

private:
  // What an engine does. It may refuse an access by an exception, and bring the state up to date before it.
  virtual void OnAccess(eAccess) {}
  // It is told of every change after it was made.
  virtual void Substep(float dt) = 0;
  virtual void OnAdded(CShapeId id) = 0;
  virtual void OnRemoved(CShapeId id) = 0;
  virtual void OnChanged(CShapeId id, eChange what) = 0;
  virtual void OnSaved() = 0;
  virtual void OnLoaded() = 0;

  const CWorldState& Look() const;
  CShape& FindShape(CShapeId id) const;
  CShape& FindKinematic(CShapeId id, const char* what) const;
  CEffects FindRunning() const;
  void CountEffects();
  void Sense(float dt);
  void PlanSubsteps();
  CShapeId AddShape(std::unique_ptr<CShape> pShape);
  void RequireExtent(const CAabb2D& box) const;
  template <class F>
  void ChangePose(CShape& shape, const F& change);
  void RequireHeld(const CWorldState& state) const;

  CWorldDesc m_cDesc;
  CWorldLimits m_cLimits;
  CEffects m_cNeeds;
  CEffects m_cGiven; // those that somebody else decides: they run if they are among the needs
  CEffects m_cRunning;
  bool m_bIsContinuousOpen = false;
  bool m_bContentChanged = true;
  std::uint64_t m_nContentVersion = 0;
  std::uint64_t m_nCounted = 0;    // substeps whose effects are in the statistics
  std::uint64_t m_nContinuous = 0; // substeps since the last plan in which Continuous was decided
  std::unique_ptr<CContent> m_pContent;
  std::unique_ptr<CFastMoves> m_pFastMoves;
  std::unique_ptr<CWorldState> m_pState;
  std::unique_ptr<CSensors> m_pSensors;
  std::vector<CContactEvent> m_stdContacts;
  std::vector<CSensorEvent> m_stdSensorEvents;
  CWorldStats m_cStats;
};

/// An empty world on the default engine.
std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc);

} // namespace Shapes
