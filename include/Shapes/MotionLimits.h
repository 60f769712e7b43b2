// SPDX-License-Identifier: MIT
// The stops of a kinematic shape: flippers, plungers, drop targets.
#pragma once

#include <Shapes/ShapeMath.h>

#include <limits>

namespace Shapes {

/// The range in which a kinematic shape of a world moves by its velocity and rotation speed. At a stop it
/// rests, and gives no ball a kick, until its speed turns round; the speed stays what it was set to. One that
/// a game has put beyond its stops moves towards them only. The default has none. CWorld::Add and SetLimits
/// refuse a range that is none (std::invalid_argument).
class CMotionLimits {
public:
  CMotionLimits() = default;
  /// @param least, most  orientations, radians from the pose at construction, counterclockwise, less than a
  /// whole turn apart: a flipper that strikes clockwise has (-1, 0) and a negative rotation speed
  static CMotionLimits OfAngle(float least, float most) {
    CMotionLimits limits;
    limits.m_fLeastAngle = least;
    limits.m_fMostAngle = most;
    return limits;
  }
  /// A paddle has its rotation centre in its middle: desc.m_vRotCenter = desc.m_vPos, which of a segment is
  /// the midpoint. The centre is (0, 0) unless given, and one beyond the box never moves away from it.
  /// @param a, b  opposite corners of the box in which the rotation centre stays, user units
  static CMotionLimits OfCenter(const Vector2& a, const Vector2& b) {
    CMotionLimits limits;
    limits.m_vLeastCenter = a.cwiseMin(b);
    limits.m_vMostCenter = a.cwiseMax(b);
    return limits;
  }

  float m_fLeastAngle = -std::numeric_limits<float>::infinity();
  float m_fMostAngle = std::numeric_limits<float>::infinity();
  Vector2 m_vLeastCenter = Vector2::Constant(-std::numeric_limits<float>::infinity());
  Vector2 m_vMostCenter = Vector2::Constant(std::numeric_limits<float>::infinity());

  friend bool operator==(const CMotionLimits& a, const CMotionLimits& b) {
    return a.m_fLeastAngle == b.m_fLeastAngle && a.m_fMostAngle == b.m_fMostAngle &&
           a.m_vLeastCenter == b.m_vLeastCenter && a.m_vMostCenter == b.m_vMostCenter;
  }
};

} // namespace Shapes
