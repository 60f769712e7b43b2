// SPDX-License-Identifier: MIT
// Points: posts without extent, and guards at the ends of segments and arcs.
#pragma once

#include <Shapes/Shape.h>

namespace Shapes {

class CPointDesc : public CShapeDesc {
public:
  CPointDesc() : CShapeDesc(eShape::Point) {}
  /// @param p position, user units  @param e elasticity
  explicit CPointDesc(const Vector2& p, float e = 1.0f);
};

/// A static point.
class CPoint : public CShape {
public:
  /// @throws std::invalid_argument naming the field that is not finite, negative or too large
  explicit CPoint(const CPointDesc& desc) : CPoint(desc, eMotion::Static) {}
  std::unique_ptr<CShape> Clone() const override;

protected:
  CPoint(const CPointDesc& desc, eMotion motion);

private:
  void Update() override;
};

/// A point that turns about its rotation centre.
using CKinematicPoint = CKinematic<CPoint, CPointDesc>;

} // namespace Shapes
