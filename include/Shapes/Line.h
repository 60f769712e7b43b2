// SPDX-License-Identifier: MIT
// Infinite line, for computations inside the library. It is no shape: nothing collides with it.
#pragma once

#include <Shapes/ShapeMath.h>

namespace Shapes {

/// A line, kept as a point and a unit direction, from which everything is computed. Gradient and intercepts
/// can be read; no computation goes through them, because they are infinite or lose all digits for steep
/// lines.
class CLine {
public:
  /// The line of gradient m through p, y = m x + b; m infinite (of either sign) is the vertical line x = p.x.
  CLine(const Vector2& p, float m);

  /// The one point of both lines; (Inf, Inf) if they are parallel. Nothing in the library uses that value.
  /// With p and q the points that define the two lines, x the crossing and s the sine of the angle between
  /// them, the error is at most 8 ulp of (|p| + |q - p| + |x - p|) / |s|, as long as |s| is above 2^-20.
  Vector2 Intersect(const CLine& line) const;
  /// The point of the line closest to q. Error at most 4 ulp of |q| + |q - p|, p the point that defines
  /// the line, for every direction.
  Vector2 ClosestPt(const Vector2& q) const;

  // Error of the first two at most 3 ulp of the result; of the intercepts 4 ulp of |p.x| + |p.y / m| and of
  // |p.y| + |m p.x|, which for steep and flat lines is much more than the result. All of it where m and 1 / m
  // are neither denormal nor infinite in float.
  float GetGradient() const;        ///< m; +Inf for a vertical line.
  float GetInverseGradient() const; ///< 1/m; +Inf for a horizontal line.
  float GetXIntercept() const;      ///< c in x = y/m + c; Inf for a horizontal line.
  float GetYIntercept() const;      ///< b in y = m x + b; Inf for a vertical line.

private:
  friend class CLineSeg;
  CLine() : m_vPt(Vector2::Zero()), m_vDir(1.0f, 0.0f) {}

  Vector2 m_vPt;
  Vector2 m_vDir; // unit; of a segment from end 0 to end 1
};

} // namespace Shapes
