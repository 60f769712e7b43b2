// SPDX-License-Identifier: MIT
// Arcs. An arc runs counterclockwise from angle 0 to angle 1; equal angles are the full circle. Swapping the
// angles gives the complement.
#pragma once

#include <Shapes/Circle.h>

namespace Shapes {

class CArcDesc : public CCircleDesc {
public:
  CArcDesc() : CArcDesc(Vector2::Zero(), 0.0f, 0.0f, 0.0f) {}
  /// @param p centre  @param r radius, user units  @param a0, a1 angles of the ends, radians  @param e
  /// elasticity
  CArcDesc(const Vector2& p, float r, float a0, float a1, float e = 1.0f);

  /// Sets the angles, each reduced to [0, 2 pi). Angles that are a whole turn apart within their rounding,
  /// such as 0 and the float nearest to 2 pi, are the full circle.
  void SetAngles(float a0, float a1);
  // Error of the ends at most 2 ulp of |centre| + radius; of the tangents 1 ulp of 1.
  float GetAngle0() const { return m_fAngle0; }
  float GetAngle1() const { return m_fAngle1; }
  void GetEndPts(Vector2& p0, Vector2& p1) const;
  /// Unit tangents that point from each end into the arc: t0 counterclockwise from end 0, t1 clockwise from
  /// end 1.
  void GetTangents(Vector2& t0, Vector2& t1) const;

  eSides m_eSides = eSides::Both; ///< Front is the outside.

private:
  float m_fAngle0;
  float m_fAngle1;
};

/// A static arc.
class CArc : public CCircle {
public:
  /// @throws std::invalid_argument naming the field that is not finite, negative or too large
  explicit CArc(const CArcDesc& desc) : CArc(desc, eMotion::Static) {}
  std::unique_ptr<CShape> Clone() const override;

  float GetAngle0() const { return m_fAngle0; }
  /// Within 12 ulp of one radian of that of the descriptor, once around counted as nothing.
  float GetAngle1() const;
  /// Angle from end 0 counterclockwise to end 1, radians in (0, 2 pi]. Error at most 6 ulp of one radian.
  float GetSpan() const { return m_fSpan; }
  bool IsFullCircle() const { return m_bFull; }
  /// Error at most 2 ulp of |centre| + radius at construction.
  void GetEndPts(Vector2& p0, Vector2& p1) const { p0 = m_vPt0, p1 = m_vPt1; }
  const Vector2& GetEndPt0() const { return m_vPt0; }
  const Vector2& GetEndPt1() const { return m_vPt1; }
  /// Unit tangents that point from each end into the arc: across the ways to the ends as these were rounded,
  /// so the error is at most 4 ulp of (|centre| + radius) / radius.
  void GetTangents(Vector2& t0, Vector2& t1) const;
  eSides GetSides() const { return m_eSides; }

  /// Whether p lies in the sector of the arc, at any distance from the centre. The end rays and the centre
  /// count as inside. By cross products, without angles: no branch cut, and the arc's own end points are
  /// always inside. Right for every direction that is farther than 10 ulp of (|centre| + radius) / radius, in
  /// radians, from both ends.
  bool PtInSector(const Vector2& p) const;
  /// The point of the arc closest to p: on the circle if p is in the sector, else the nearer end; end 0 if p
  /// is the centre. It is within 10 ulp of |centre| + radius of the arc, and by no more than that plus 2 ulp
  /// of |p - centre| farther from p than the closest.
  Vector2 ClosestPt(const Vector2& p) const;

protected:
  CArc(const CArcDesc& desc, eMotion motion);

private:
  void Translate(const Vector2& d) override;
  Vector2 TurnFromStart(const Vector2& center, float angle) override;
  void Update() override;

  float m_fAngle0;
  float m_fSpan;
  bool m_bFull;
  eSides m_eSides;
  Vector2 m_vPt0; // the ends
  Vector2 m_vPt1;
  Vector2 m_vStartPt0; // at construction
  Vector2 m_vStartPt1;
  float m_fStartAngle0;
};

/// An arc that turns about its rotation centre.
using CKinematicArc = CKinematic<CArc, CArcDesc>;

} // namespace Shapes
