// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Point.h>

#include <vector>

namespace Shapes {

/// Kinematic shapes that move and turn as one. The compound points to the shapes and does not own them;
/// they must live as long as it does.
class CCompoundShape : public CShapeCommon {
public:
  /// Adds a shape. It gets the velocity, the rotation speed and the centre of the compound and is turned to
  /// its orientation.
  /// @throws std::invalid_argument if pShape is null, or static while the compound has a speed
  void AddShape(CShape* pShape);
  const std::vector<CShape*>& GetShapes() const { return m_stdShapes; }

  /// Turns all shapes about center to `angle` radians from their poses at construction.
  void Rotate(const Vector2& center, float angle);
  /// Puts all shapes back to their poses at construction.
  void Reset();
  /// Moves all shapes by one step.
  void move();

  float GetOrientation() const { return m_cPose.GetOrientation(); } ///< Radians in [0, 2 pi).
  void SetOrientation(float angle) { Rotate(GetRotCenter(), angle); }
  const Vector2& GetVel() const { return m_cPose.GetVel(); } ///< Units per second.
  void SetVel(const Vector2& v);
  float GetRotSpeed() const { return m_cPose.GetRotSpeed(); } ///< Revolutions per second.
  void SetRotSpeed(float revsPerSecond);
  const Vector2& GetRotCenter() const { return m_cPose.GetRotCenter(); }
  void SetRotCenter(const Vector2& center);

private:
  std::vector<CShape*> m_stdShapes;
  CKinematicPoint m_cPose{CPointDesc(Vector2::Zero())}; // moves and turns as they do
};

} // namespace Shapes
