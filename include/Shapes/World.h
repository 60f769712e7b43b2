// SPDX-License-Identifier: MIT
// Worlds: they own shapes, move them by Step, and report contacts.
#pragma once

#include <Shapes/Backend.h>
#include <Shapes/Events.h>
#include <Shapes/Questions.h>
#include <Shapes/Stats.h>
#include <Shapes/WorldDesc.h>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace Shapes {

/// A copy of all that a world holds, made by SaveState. Cheap to copy.
class CSavedState {
private:
  friend class CWorld;
  struct CImpl;
  std::shared_ptr<const CImpl> m_pImpl;
};

/// Owns its shapes and steps them. Functions that take an id throw std::invalid_argument if no shape has it,
/// or if the shape is not of the kind that the function is for, and setters if a value is not valid; nothing
/// has changed then. Worlds are made by CBackend::MakeWorld or MakeWorld below. A world is for one thread at
/// a time, const functions included. Lengths are in user units, angles in radians, counterclockwise.
class CWorld final {
public:
  /// The state and the engine behind the interface.
  struct CImpl;
  explicit CWorld(std::unique_ptr<CImpl> pImpl);
  ~CWorld();
  CWorld(const CWorld&) = delete;
  CWorld& operator=(const CWorld&) = delete;

  const CWorldDesc& GetDesc() const;
  /// @throws std::invalid_argument if g is not finite or too large
  void SetGravity(const Vector2& g);

  /// Adds a shape, from a descriptor of any kind; m_eMotionType says whether it is static or kinematic.
  /// @throws std::invalid_argument naming the field and the value that is not valid; nothing is added then
  CShapeId Add(const CAnyShapeDesc& desc);
  /// Adds a compound: kinematic shapes about one rotation centre with one rotation speed, one velocity and
  /// the same stops, whatever their descriptors say of these. All or none is added.
  /// @param rotCenter, revsPerSecond, v, limits  as the fields of CShapeDesc
  /// @throws std::invalid_argument as Add, also for a ball among them; "shape 1: ..." is of descs[1]
  /// @returns an id for each of them, in their order
  std::vector<CShapeId> AddCompound(std::span<const CAnyShapeDesc> descs, const Vector2& rotCenter,
                                    float revsPerSecond = 0.0f, const Vector2& v = Vector2::Zero(),
                                    const CMotionLimits& limits = {});
  void Remove(CShapeId id);
  bool Contains(CShapeId id) const;

  /// Moves everything by the time step of the description.
  void Step();
  /// The contacts of the last Step, in the order of their responses; those of sensors follow at the end of
  /// each substep, by ball and then by shape. This and the next three are valid until the next Step or
  /// LoadState (in a b2World of a game, PreStep): what they tell may be answered meanwhile, also by Remove.
  /// Ask Contains first: a ball or a shape may be listed more than once, and be gone when its next entry is
  /// read. The ends of what is removed are told in the next Step, with the ids that are gone.
  std::span<const CContactEvent> GetContacts() const;
  /// Begins and ends of touches of sensors in the last Step, substep by substep, within one in the order of
  /// ball and then by shape. A ball that crosses a sensor within a step gives both.
  std::span<const CSensorEvent> GetSensorEvents() const;
  /// Touches of solid shapes and balls that began or ended in the last Step, substep by substep; within one
  /// by ball and then by shape. Empty unless the description forces eEffect::Touches.
  std::span<const CTouchEvent> GetTouchEvents() const;
  /// The balls that CWorldStats::m_nBallsHalted counted in the last Step, each once, by id: they had too many
  /// impacts and stayed where they were for a part of it, or a kinematic shape went over them. Empty on
  /// Box2D.
  std::span<const CShapeId> GetHaltedBalls() const;
  const CWorldStats& GetStats() const;

  /// The effects of the next substep, from the present content of the world.
  CEffects GetEffects() const;
  /// The same in words: a line for each effect with its name, whether it runs, and why. "Kinematics: runs; 2
  /// shapes move or rotate".
  std::string ExplainEffects() const;

  // Of any shape.
  eShape GetShapeType(CShapeId id) const;
  eMotion GetMotionType(CShapeId id) const;
  Vector2 GetPos(CShapeId id) const;
  /// Moves a shape or a ball for good. The rotation centre of a kinematic shape moves along, until Reset. A
  /// shape of a compound leaves the others, unless all are moved by the same way.
  /// @throws std::invalid_argument if the shape would be beyond the limits of the engine there
  void SetPos(CShapeId id, const Vector2& p);
  float GetElasticity(CShapeId id) const;
  void SetElasticity(CShapeId id, float e);
  bool GetSensor(CShapeId id) const;
  void SetSensor(CShapeId id, bool b);
  bool GetCanCollide(CShapeId id) const;
  void SetCanCollide(CShapeId id, bool b = true);
  CFilter GetFilter(CShapeId id) const;
  void SetFilter(CShapeId id, const CFilter& filter);
  void* GetUserPtr(CShapeId id) const;
  void SetUserPtr(CShapeId id, void* p);

  // Of shapes that are not balls.
  /// All of them, in the order of their ids.
  std::vector<CShapeId> GetShapeIds() const;
  /// The shape as it is now, to draw it or ask it. Valid until it is removed or a state is loaded.
  const CShape& GetShape(CShapeId id) const;
  /// From the pose when it was added, in [0, 2 pi): a stop at -1 is read as 5.28.
  float GetOrientation(CShapeId id) const;
  /// Of a kinematic shape, about its rotation centre.
  void SetOrientation(CShapeId id, float angle);
  /// The one that it was given, be it at a stop or not; revolutions per second, counterclockwise.
  float GetRotSpeed(CShapeId id) const;
  /// Of a kinematic shape.
  void SetRotSpeed(CShapeId id, float revsPerSecond);
  /// The same of all shapes of a compound, which one alone would leave.
  /// @throws std::invalid_argument if any of them cannot turn; none does then
  void SetRotSpeed(std::span<const CShapeId> ids, float revsPerSecond);
  Vector2 GetRotCenter(CShapeId id) const;
  void SetRotCenter(CShapeId id, const Vector2& center);
  /// The stops of a kinematic shape, between which it moves and turns; of a compound those of all its shapes
  /// have to be set.
  CMotionLimits GetLimits(CShapeId id) const;
  void SetLimits(CShapeId id, const CMotionLimits& limits);
  /// Puts a kinematic shape back to its pose and rotation centre when it was added.
  void Reset(CShapeId id);

  // Of balls and kinematic shapes.
  /// Units per second; (0, 0) of a static shape.
  Vector2 GetVel(CShapeId id) const;
  /// A kinematic shape moves by it with its rotation centre, through other shapes, and pushes balls; it stops
  /// at the limits of the engine. A shape that is moved by SetPos has no speed.
  /// @throws std::invalid_argument if v is not finite or faster than the engine can go
  void SetVel(CShapeId id, const Vector2& v);
  /// The same of all shapes of a compound, which one alone would leave.
  /// @throws std::invalid_argument as for one; none of them has another velocity then
  void SetVel(std::span<const CShapeId> ids, const Vector2& v);

  // Of balls.
  float GetRadius(CShapeId id) const;
  float GetMass(CShapeId id) const;
  /// All balls in the order of their ids, one array for each property. Valid until a ball is added or
  /// removed, or a state is loaded.
  std::span<const CShapeId> GetBallIds() const;
  std::span<const Vector2> GetBallPositions() const;
  std::span<const Vector2> GetBallVelocities() const;

  // Queries of the world as it is now, the same on every engine. They find what is solid, at its present
  // place, and meets a shape with this filter: the default one is of category 1, and does not see what has a
  // mask without that bit. Sensors and what is turned off are left out. Computed in double, and rounded once.
  // The first one after a change or a step makes a tree of all shapes and balls. They throw
  // std::invalid_argument for what is not finite.

  /// The first hit of a circle of this radius on the segment between two points (a ray, if the radius is 0),
  /// as a ball would: circles are rings from inside, one-sided shapes let through what comes from their open
  /// side, and what overlaps at the beginning is met at once if the circle approaches, else only
  /// where it comes to it again, as from inside a ring. Of several at the same time, to the rounding of
  /// m_fShare, the lowest id.
  std::optional<CCastHit> Cast(const Vector2& from, const Vector2& to, float radius = 0.0f,
                               const CFilter& filter = {}) const;
  /// All that it would meet if it went through, each shape and ball once, in the order in which it does.
  std::vector<CCastHit> CastAll(const Vector2& from, const Vector2& to, float radius = 0.0f,
                                const CFilter& filter = {}) const;
  /// The closest shape or ball that is closer than `reach`: circles and arcs are curves, balls are disks.
  std::optional<CClosestHit> FindClosest(const Vector2& p,
                                         float reach = std::numeric_limits<float>::infinity(),
                                         const CFilter& filter = {}) const;
  /// All shapes and balls that a ball there would overlap (FindInCircle), or that have a point in the box
  /// (FindInBox), by id. A ring around a smaller ball, or around the box, is none; sides do not matter.
  std::vector<CShapeId> FindInCircle(const Vector2& center, float radius, const CFilter& filter = {}) const;
  std::vector<CShapeId> FindInBox(const CAabb2D& box, const CFilter& filter = {}) const;

  /// All shapes, their poses and properties, and the gravity; not the statistics or the contacts. A world
  /// that goes on after SaveState, and one that goes on after LoadState of it, have the same bits on the same
  /// engine. On native saving changes nothing; on Box2D the bodies are made anew, without the impulses with
  /// which a step begins its search, so that piles which are saved in each step do not come to rest.
  CSavedState SaveState();
  /// The ids are those of the state from then on. Where another world has saved it, an id that this one has
  /// given before may name another shape in it.
  /// @throws std::invalid_argument if the state is default constructed, or if this world cannot hold the
  /// state of another one; nothing has changed then
  void LoadState(const CSavedState& state);

private:
  std::unique_ptr<CImpl> m_pImpl;
};

/// An empty world on the default engine.
std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc);

} // namespace Shapes
