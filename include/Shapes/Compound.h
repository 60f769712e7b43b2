// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Shape.h>

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

  float GetOrientation() const { return m_fOrientation; } ///< Radians in [0, 2 pi).
  void SetOrientation(float angle) { Rotate(m_vRotCenter, angle); }
  const Vector2& GetVel() const { return m_vVel; } ///< Units per second.
  void SetVel(const Vector2& v);
  float GetRotSpeed() const { return m_fRotSpeed; } ///< Revolutions per second.
  void SetRotSpeed(float revsPerSecond);
  const Vector2& GetRotCenter() const { return m_vRotCenter; }
  void SetRotCenter(const Vector2& center);

private:
  std::vector<CShape*> m_stdShapes;
  float m_fOrientation = 0.0f;
  double m_fAngle = 0.0; // the same before it was rounded, but for whole turns
  Vector2 m_vVel = Vector2::Zero();
  float m_fRotSpeed = 0.0f;
  Vector2 m_vRotCenter = Vector2::Zero();
  Eigen::Vector2d m_vMoved = Eigen::Vector2d::Zero();          // of m_vRotCenter, by m_vVel
  Eigen::Vector2d m_vStartRotCenter = Eigen::Vector2d::Zero(); // without it
};

} // namespace Shapes
