// SPDX-License-Identifier: MIT
// All that a world holds, in the order of ids. Every engine keeps its worlds here; saving a world copies it.
#pragma once

#include <Shapes/Aabb2D.h>
#include <Shapes/MotionLimits.h>

#include "../Tolerances.h"
#include "Engine.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace Shapes {

/// Whether balls bounce off it.
inline bool IsSolid(const CShape& shape) { return shape.GetCanCollide() && !shape.GetSensor(); }

/// Where something was added, removed or changed since balls were last moved: one that sleeps there may lie
/// on nothing, or in something.
struct CDisturbed {
  std::vector<CAabb2D> m_stdBoxes;
  bool m_bIsEverywhere = true; ///< Also where another engine or mode has made the last substep.

  void Add(const CAabb2D& box) {
    m_bIsEverywhere |= m_stdBoxes.size() == g_nMostDisturbed;
    if (!m_bIsEverywhere) m_stdBoxes.push_back(box);
  }
  void Clear() {
    m_stdBoxes.clear();
    m_bIsEverywhere = false;
  }
};

/// Balls as one array for each property; the same index in each is the same ball.
struct CBallArrays {
  std::vector<CShapeId> m_stdId;
  std::vector<Vector2> m_stdPos;
  std::vector<Vector2> m_stdPrevPos; // at the beginning of the substep
  std::vector<Vector2> m_stdVel;
  // The rest of the doubles that an engine has computed, beyond the floats above: over many small steps their
  // roundings would add up. Of native under gravity with Continuous; zero where a user has set the floats.
  std::vector<Vector2> m_stdPosTail;
  std::vector<Vector2> m_stdVelTail;
  // Seconds for which each has been at rest, as an engine counts them: g_fSleepTime where it sleeps.
  std::vector<float> m_stdCalm;
  CDisturbed m_cDisturbed;
  std::vector<float> m_stdRadius;
  std::vector<float> m_stdMass;
  std::vector<float> m_stdElasticity;
  std::vector<CFilter> m_stdFilter;
  std::vector<std::uint8_t> m_stdSensor;
  std::vector<std::uint8_t> m_stdCanCollide;
  std::vector<void*> m_stdUser;

  std::size_t Size() const { return m_stdId.size(); }
  bool IsSolid(std::size_t i) const { return m_stdCanCollide[i] && !m_stdSensor[i]; }
  bool IsAsleep(std::size_t i) const { return m_stdCalm[i] >= g_fSleepTime; }
  CAabb2D GetAABB(std::size_t i) const {
    const Vector2 r(m_stdRadius[i], m_stdRadius[i]);
    return {m_stdPos[i] - r, m_stdPos[i] + r};
  }
  void Add(CShapeId id, const CDynamicCircleDesc& desc);
  void Remove(std::size_t i);
  /// As a user of the world does, not the engine.
  void SetPos(std::size_t i, const Vector2& p) {
    m_stdPos[i] = m_stdPrevPos[i] = p;
    m_stdPosTail[i] = Vector2::Zero();
  }
  void SetVel(std::size_t i, const Vector2& v) {
    m_stdVel[i] = v;
    m_stdVelTail[i] = Vector2::Zero();
  }
  void ForgetTails();
};

/// Velocity and rotation speed of a shape.
struct CDrive {
  Vector2 m_vVel;
  float m_fRotSpeed;
};

/// A shape that is not a ball.
struct CShapeEntry {
  CShapeId m_cId;
  /// Its velocity and rotation speed are 0 where Kinematics is forbidden, and at a stop.
  std::unique_ptr<CShape> m_pShape;
  Vector2 m_vVel;    ///< The one that the user gave it, units per second.
  float m_fRotSpeed; ///< Likewise, revolutions per second.
  bool m_bIsHeld = false;
  CMotionLimits m_cLimits;

  CShapeEntry(CShapeId id, std::unique_ptr<CShape> pShape)
      : m_cId(id),
        m_pShape(std::move(pShape)),
        m_vVel(m_pShape->GetVel()),
        m_fRotSpeed(m_pShape->GetRotSpeed()) {}
  CShapeEntry(const CShapeEntry& entry)
      : m_cId(entry.m_cId),
        m_pShape(entry.m_pShape->Clone()),
        m_vVel(entry.m_vVel),
        m_fRotSpeed(entry.m_fRotSpeed),
        m_bIsHeld(entry.m_bIsHeld),
        m_cLimits(entry.m_cLimits) {}
  CShapeEntry(CShapeEntry&&) = default;
  CShapeEntry& operator=(CShapeEntry&&) = default;

  void SetVel(const Vector2& v) {
    m_vVel = v;
    m_pShape->SetVel(m_bIsHeld ? Vector2(Vector2::Zero()) : v);
  }
  void SetRotSpeed(float revsPerSecond) {
    m_fRotSpeed = revsPerSecond;
    m_pShape->SetRotSpeed(m_bIsHeld ? 0.0f : revsPerSecond);
  }
  bool HasStops() const { return m_cLimits != CMotionLimits(); }
  CDrive GetDrive() const { return {m_pShape->GetVel(), m_pShape->GetRotSpeed()}; }
  /// Moves with other speeds than it was given.
  void SetDrive(const CDrive& drive) {
    m_pShape->SetVel(drive.m_vVel);
    m_pShape->SetRotSpeed(drive.m_fRotSpeed);
  }
  /// The shape stands still despite its speeds.
  void SetHeld(bool b) {
    m_bIsHeld = b;
    SetVel(m_vVel);
    SetRotSpeed(m_fRotSpeed);
  }
};

/// A ball and what it touches: named as in CContactEvent.
struct CTouchingPair {
  CShapeId m_cBall;
  CShapeId m_cShape;
  friend auto operator<=>(const CTouchingPair&, const CTouchingPair&) = default;
};

/// How the two of a pair meet.
enum class eMeeting { None, Solid, Sensor };

class CWorldState {
public:
  std::uint32_t m_nNextId = 1;
  Vector2 m_vGravity = Vector2::Zero();
  CWorldLimits m_cLimits; // of the world that it is from
  std::vector<CShapeEntry> m_stdShapes;
  CBallArrays m_cBalls;
  // Whose end was not told yet, in order: with sensors, and of what is solid.
  std::vector<CTouchingPair> m_stdTouching;
  std::vector<CTouchingPair> m_stdSolidTouching;
  std::shared_ptr<const CEngineMemory> m_pMemory; // of a state that was saved: what goes with it

  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  /// Index in m_stdShapes or in the ball arrays; npos if there is none. Ids ascend in both.
  std::size_t FindShape(CShapeId id) const;
  std::size_t FindBall(CShapeId id) const;
  /// None where one of them is gone or turned off. What belongs to a game has no id, and is solid.
  eMeeting GetMeeting(const CTouchingPair& pair) const;
};

} // namespace Shapes
