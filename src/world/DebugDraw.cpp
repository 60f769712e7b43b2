// SPDX-License-Identifier: MIT
#include <Shapes/DebugDraw.h>

#include <Shapes/World.h>

#include "../geometry/VisitShape.h"

namespace Shapes {
namespace {

eRole RoleOf(const CWorld& world, CShapeId id) {
  if (!world.GetCanCollide(id)) return eRole::Off;
  if (world.GetSensor(id)) return eRole::Sensor;
  switch (world.GetMotionType(id)) {
  case eMotion::Static: return eRole::Static;
  case eMotion::Kinematic: return eRole::Kinematic;
  default: return eRole::Ball;
  }
}

void DrawShape(const CShape& shape, eRole role, CDebugDraw& draw) {
  VisitShape(
      shape,
      CPerShape{[&](const CPoint& point) { draw.DrawPoint(point.GetPos(), role); },
                [&](const CLineSeg& seg) { draw.DrawSegment(seg.GetEndPt0(), seg.GetEndPt1(), role); },
                [&](const CCircle& circle) { draw.DrawCircle(circle.GetPos(), circle.GetRadius(), role); },
                [&](const CArc& arc) {
                  if (arc.IsFullCircle())
                    draw.DrawCircle(arc.GetPos(), arc.GetRadius(), role);
                  else
                    draw.DrawArc(arc.GetPos(), arc.GetRadius(), arc.GetAngle0(), arc.GetSpan(), role);
                }});
}

} // namespace

void Draw(const CWorld& world, CDebugDraw& draw) {
  for (const CShapeId id : world.GetShapeIds())
    DrawShape(world.GetShape(id), RoleOf(world, id), draw);
  for (const CShapeId id : world.GetBallIds())
    draw.DrawCircle(world.GetPos(id), world.GetRadius(id), RoleOf(world, id));
  for (const CContactEvent& contact : world.GetContacts()) {
    draw.DrawPoint(contact.m_vPOI, eRole::Contact);
    const float length = world.Contains(contact.m_cBall) ? world.GetRadius(contact.m_cBall) : 0.0f;
    draw.DrawSegment(contact.m_vPOI, contact.m_vPOI + length * contact.m_vNorm, eRole::Contact);
  }
}

} // namespace Shapes
