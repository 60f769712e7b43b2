// SPDX-License-Identifier: MIT
// Descriptions of sensors.
#pragma once

#include <Shapes/Circle.h>

namespace Shapes {

template <class TDesc>
TDesc Sensor(TDesc desc) {
  desc.m_bIsSensor = true;
  return desc;
}

inline CCircleDesc MakeZone(const Vector2& p = Vector2::Zero(), float r = 1) {
  return Sensor(CCircleDesc(p, r));
}

} // namespace Shapes
