// SPDX-License-Identifier: MIT
// The energy of the balls of a scene.
#pragma once

#include "reference/Vec2.h"
#include "scene/Trial.h"

#include <cstddef>

namespace Shapes::Compare {

/// Kinetic and potential energy, with heights from the lowest corner of the bounds: where gravity points to.
class CEnergy {
public:
  explicit CEnergy(const CScene& scene) : m_cScene(scene), m_vGravity(ToDouble(scene.m_cWorld.m_vGravity)) {
    const Vector2 &low = scene.m_cBounds.GetBottomRt(), &high = scene.m_cBounds.GetTopLeft();
    m_vLowest = {static_cast<double>(m_vGravity.x() > 0.0 ? low.x() : high.x()),
                 static_cast<double>(m_vGravity.y() > 0.0 ? high.y() : low.y())};
  }

  double GetOf(const CWorld& world, std::size_t ball) const {
    return static_cast<double>(m_cScene.m_stdBalls[ball].m_cDesc.m_fMass) *
           (0.5 * ToDouble(world.GetBallVelocities()[ball]).squaredNorm() -
            m_vGravity.dot(ToDouble(world.GetBallPositions()[ball]) - m_vLowest));
  }

  double GetSum(const CWorld& world) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < m_cScene.m_stdBalls.size(); ++i)
      sum += GetOf(world, i);
    return sum;
  }

private:
  const CScene& m_cScene;
  CVec2d m_vGravity, m_vLowest;
};

} // namespace Shapes::Compare
