// SPDX-License-Identifier: MIT
// Circles: bumpers and posts. On native a static circle is a ring: a ball may be inside it and bounces off
// the inside. Box2D's circles are solid.
#pragma once

#include <Shapes/LineSeg.h>
#include <Shapes/Shape.h>

namespace Shapes {

class CCircleDesc : public CShapeDesc {
public:
  CCircleDesc() : CShapeDesc(eShape::Circle) {}
  /// @param p centre, user units  @param r radius, user units  @param e elasticity
  CCircleDesc(const Vector2& p, float r, float e = 1.0f);

  float m_fRadius = 0.0f;
};

/// A static circle.
class CCircle : public CShape {
public:
  /// @throws std::invalid_argument naming the field that is not finite, negative or too large
  explicit CCircle(const CCircleDesc& desc) : CCircle(desc, eMotion::Static) {}
  std::unique_ptr<CShape> Clone() const override;

  float GetRadius() const { return m_fRadius; }
  /// Whether p is strictly inside the circle. Right unless p is within 1 ulp of its distance from the centre
  /// of the circle.
  bool PtInCircle(const Vector2& p) const;
  /// The point of the perimeter closest to p; the topmost one if p is the centre. Error at most 3 ulp of
  /// |centre| + radius.
  Vector2 ClosestPt(const Vector2& p) const;

  /// The points in which the tangents through p touch the circle. Seen from p, p0 is to the left of the
  /// centre and p1 to the right.
  /// Error: with c the centre and d = |c - p|, p0 and p1 are within 10 ulp of |p| + d of the circle, and the
  /// tangent and the radius through them are at right angles but for as much. Close to the circle the point
  /// slides along it: its own error is at most 10 ulp of (|p| + d) (1 + d / length of the tangent), from a
  /// distance of 16 ulp of d on.
  /// @return false if p is inside the circle or is its centre: there is no tangent then, p0 and p1 are
  /// unchanged. Right unless p is within 1 ulp of d of the circle.
  bool Tangents(const Vector2& p, Vector2& p0, Vector2& p1) const;

  /// The outer common tangents of this circle and another, each as the segment between the points in which it
  /// touches them; t0 is to the right of the way from this centre to the other's, t1 to the left. Equal radii
  /// give parallel tangents. Both circles are shrunk by the smaller radius, which leaves the tangents'
  /// directions (J. Casey, A Sequel to the First Six Books of the Elements of Euclid, 1888, pp. 31-32). Only
  /// the ends of t0 and t1 are set.
  /// Error: with c, c' the centres and d their distance, the ends are within 8 ulp of |c| + |c'| + r + r' of
  /// their circles, and tangents and radii at right angles but for as much. Where one circle all but contains
  /// the other the ends slide along them: their own error is at most 1 + 1 / sin a times that, cos a =
  /// |r - r'| / d, from d = |r - r'| + 16 ulp of d on.
  /// @return false if one circle contains the other (touching inside included): t0 and t1 are unchanged then.
  /// Right unless d and |r - r'| differ by less than 2 ulp of d.
  /// @throws std::invalid_argument if pCircle is null
  bool Tangents(const CCircle* pCircle, CLineSegDesc& t0, CLineSegDesc& t1) const;

  /// The first of the two outer common tangents, t0 above.
  bool Tangent(const CCircle* pCircle, CLineSegDesc& t) const;

protected:
  CCircle(const CCircleDesc& desc, eMotion motion, eShape type = eShape::Circle);

private:
  friend class CArc;
  friend class CDynamicCircle;
  void Update() override;

  float m_fRadius;
};

/// A circle that turns about its rotation centre.
using CKinematicCircle = CKinematic<CCircle, CCircleDesc>;

} // namespace Shapes
