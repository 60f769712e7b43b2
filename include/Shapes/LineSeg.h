// SPDX-License-Identifier: MIT
// Line segments. The first end is the left one; of two with equal x it is the lower one.
#pragma once

#include <Shapes/Line.h>
#include <Shapes/Shape.h>

namespace Shapes {

class CLineSegDesc : public CShapeDesc {
public:
  CLineSegDesc() : CLineSegDesc(Vector2::Zero(), Vector2::Zero()) {}
  /// @param p0, p1 the ends in any order, user units  @param e elasticity
  CLineSegDesc(const Vector2& p0, const Vector2& p1, float e = 1.0f);

  /// Sets the ends, given in any order, and the position, their midpoint: within 1 ulp of |end 0| + length.
  void SetEndPts(const Vector2& p0, const Vector2& p1);
  void GetEndPts(Vector2& p0, Vector2& p1) const { p0 = m_vPt0, p1 = m_vPt1; }
  const Vector2& GetEndPt0() const { return m_vPt0; }
  const Vector2& GetEndPt1() const { return m_vPt1; }
  /// Unit vector to the left of the way from end 0 to end 1; (0, 1) for a segment of no length. Error
  /// at most 2 ulp of 1, its length within 1 ulp of 1.
  Vector2 GetNormal() const;
  /// Gradient of the line through the ends; Inf if it is vertical. Error at most 3 ulp of itself.
  float GetGradient() const;

  eSides m_eSides = eSides::Both;

private:
  Vector2 m_vPt0;
  Vector2 m_vPt1;
};

/// A static line segment. One whose ends coincide acts as a point.
class CLineSeg : public CShape, public CLine {
public:
  /// @throws std::invalid_argument naming the field that is not finite, negative or too large
  explicit CLineSeg(const CLineSegDesc& desc) : CLineSeg(desc, eMotion::Static) {}
  std::unique_ptr<CShape> Clone() const override;

  void GetEndPts(Vector2& p0, Vector2& p1) const { p0 = m_vPt0, p1 = m_vPt1; }
  const Vector2& GetEndPt0() const { return m_vPt0; }
  const Vector2& GetEndPt1() const { return m_vPt1; }
  /// Unit tangents that point from each end into the segment: t0 from end 0, t1 = -t0 from end 1. Error as of
  /// the normal.
  void GetTangents(Vector2& t0, Vector2& t1) const { t0 = m_vDir, t1 = -m_vDir; }
  /// Unit normal, the counterclockwise perpendicular of t0 at construction. It turns with a kinematic segment
  /// and does not flip when the ends change order. Error at most 2 ulp of 1, against the ends as they are
  /// now; its length is within 1 ulp of 1.
  const Vector2& GetNormal() const { return m_vNormal; }
  eSides GetSides() const { return m_eSides; }
  /// The point of the segment closest to q. Error at most 8 ulp of |q| + |end 0| + length.
  Vector2 ClosestPt(const Vector2& q) const;

protected:
  CLineSeg(const CLineSegDesc& desc, eMotion motion);

private:
  void Translate(const Vector2& d) override;
  Vector2 TurnFromStart(const Vector2& center, float angle) override;
  void Update() override;

  Vector2 m_vPt0;
  Vector2 m_vPt1;
  Vector2 m_vNormal;
  eSides m_eSides;
  Vector2 m_vStartPt0; // at construction
  Vector2 m_vStartPt1;
  Vector2 m_vStartNormal;
};

/// A line segment that turns about its rotation centre: flippers, spinners, gates.
using CKinematicLineSeg = CKinematic<CLineSeg, CLineSegDesc>;

} // namespace Shapes
