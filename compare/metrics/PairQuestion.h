// SPDX-License-Identifier: MIT
#pragma once

#include "reference/Vec2.h"
#include "scene/Trial.h"

namespace Shapes::Compare {

/// One shape (or other ball) and one ball on their free flight through one step, to be put to several
/// engines: both are where they end up at the end of the step, and know where they came from.
class CPairQuestion {
public:
  /// A shape that is not a ball. @param time scene time at the beginning of the step
  CPairQuestion(const CSceneShape& shape, const CDynamicCircleDesc& ball, double time,
                const CWorldDesc& world);
  /// Two balls; `ball` is the one that responds.
  CPairQuestion(const CDynamicCircleDesc& other, const CDynamicCircleDesc& ball, const CWorldDesc& world);

  struct CAnswer {
    bool m_bDetected = false;
    float m_fSetback = 0.0f;
    CVec2d m_vCentre = CVec2d::Zero(); ///< claimed at the impact: POI + r n
  };
  CAnswer Ask(const CBackend& backend) const;

private:
  std::unique_ptr<CShape> m_pShape;
  std::unique_ptr<CDynamicCircle> m_pBall;
};

} // namespace Shapes::Compare
