// SPDX-License-Identifier: MIT
#include "Field.h"
#include "Random.h"

#include <algorithm>

namespace Shapes::Compare::Benchmark {
namespace {

constexpr float g_fRadius = 0.25f;

template <class CDesc>
CDesc Sensor(CDesc desc) {
  desc.m_bIsSensor = true;
  return desc;
}

std::vector<CAnyShapeDesc> MakeTable() {
  std::vector<CAnyShapeDesc> table{CLineSegDesc({0, 0}, {0, 14.5f}),     CLineSegDesc({10, 0}, {10, 14.5f}),
                                   CLineSegDesc({0, 0}, {10, 0}),        CArcDesc({5, 14}, 5, 0, g_fPi),
                                   CLineSegDesc({9.1f, 0}, {9.1f, 13}),  CPointDesc(Vector2(9.1f, 13)),
                                   CLineSegDesc({9.1f, 13}, {10, 13.9f})};
  for (const float side : {-1.0f, 1.0f}) {
    const auto place = [side](float x, float y) { return Vector2(4.55f + side * x, y); };
    const Vector2 top = place(3.4f, 7.6f), bottom = place(2.25f, 5);
    table.insert(table.end(), {CLineSegDesc(place(4.55f, 4.784f), place(1.79f, 3.19f)), CPointDesc(top),
                               CPointDesc(bottom), CLineSegDesc(top, bottom)});
  }
  for (const Vector2& p : {Vector2(2.7f, 12.3f), Vector2(6.5f, 12.3f), Vector2(4.6f, 9.9f)})
    table.push_back(CCircleDesc(p, 0.6f));
  for (const Vector2& p : {Vector2(1, 9.6f), Vector2(8.1f, 9.4f)})
    table.push_back(CCircleDesc(p, 0.15f));
  for (const Vector2& p : {Vector2(2.5f, 15), Vector2(4.6f, 14.3f), Vector2(6.7f, 15), Vector2(1, 12)})
    table.push_back(CPointDesc(p));
  for (const Vector2& p : {Vector2(3.55f, 16), Vector2(5.65f, 16), Vector2(1.2f, 14.6f)})
    table.push_back(Sensor(CCircleDesc(p, 0.3f)));
  table.push_back(Sensor(CLineSegDesc({0, 0.3f}, {10, 0.3f})));
  return table;
}

// side: -1 the left one, 1 the right one. It turns by 60 degrees in 16 steps.
CFlipper MakeFlipper(float side) {
  const Vector2 pivot(4.55f + 1.9f * side, 3), tip(4.55f + 0.731f * side, 2.325f);
  return {MakeCapsule(pivot, 0.22f, tip, 0.12f), pivot, -1.25f * side};
}

} // namespace

CField MakePinball(std::size_t balls) {
  CField field;
  field.m_vSize = {10, 19};
  field.m_fStep = 1.0f / 120.0f;
  field.m_stdShapes = MakeTable();
  field.m_stdFlippers = {MakeFlipper(-1), MakeFlipper(1)};
  CRandom between;
  // Above the slingshots, in no bumper and no other ball.
  while (field.m_stdBalls.size() < balls) {
    const CDynamicCircleDesc ball({between(0.3f, 8.8f), between(7.9f, 18)}, g_fRadius,
                                  {between(-8, 8), between(-8, 8)});
    const auto isNear = [&](const Vector2& p, float reach) { return (p - ball.m_vPos).norm() < reach; };
    if (ball.m_vPos.y() > 14 && !isNear({5, 14}, 4.7f)) continue; // beyond the arc
    const bool isTaken =
        std::any_of(field.m_stdBalls.begin(), field.m_stdBalls.end(),
                    [&](const CDynamicCircleDesc& other) { return isNear(other.m_vPos, 2 * g_fRadius); }) ||
        std::any_of(field.m_stdShapes.begin(), field.m_stdShapes.end(), [&](const CAnyShapeDesc& shape) {
          const auto* pCircle = std::get_if<CCircleDesc>(&shape);
          return pCircle != nullptr && isNear(pCircle->m_vPos, pCircle->m_fRadius + g_fRadius);
        });
    if (!isTaken) field.m_stdBalls.push_back(ball);
  }
  return field;
}

} // namespace Shapes::Compare::Benchmark
