// SPDX-License-Identifier: MIT
#include "Describe.h"

namespace Shapes::Games {
namespace {

CAnyShapeDesc DescribeShape(const CShape& shape) {
  switch (shape.GetShapeType()) {
  case eShape::LineSeg: {
    const auto& segment = static_cast<const CLineSeg&>(shape);
    CLineSegDesc desc(segment.GetEndPt0(), segment.GetEndPt1());
    desc.m_eSides = segment.GetSides();
    return desc;
  }
  case eShape::Circle: return CCircleDesc(shape.GetPos(), static_cast<const CCircle&>(shape).GetRadius());
  case eShape::Arc: {
    const auto& arc = static_cast<const CArc&>(shape);
    CArcDesc desc(arc.GetPos(), arc.GetRadius(), arc.GetAngle0(),
                  arc.IsFullCircle() ? arc.GetAngle0() : arc.GetAngle1());
    desc.m_eSides = arc.GetSides();
    return desc;
  }
  default: return CPointDesc(shape.GetPos());
  }
}

} // namespace

CSceneDesc Describe(const CWorld& world) {
  CSceneDesc scene;
  scene.m_cWorld = world.GetDesc();
  for (const CShapeId id : world.GetShapeIds()) {
    if (!world.GetCanCollide(id)) continue;
    CAnyShapeDesc any = DescribeShape(world.GetShape(id));
    std::visit(
        [&](CShapeDesc& desc) {
          desc.m_fElasticity = world.GetElasticity(id);
          desc.m_bIsSensor = world.GetSensor(id);
          desc.m_eMotionType = world.GetMotionType(id);
          // Scene files have no stops: what has some stands still.
          if (desc.m_eMotionType != eMotion::Kinematic || world.GetLimits(id) != CMotionLimits()) return;
          desc.m_vVel = world.GetVel(id);
          desc.m_fRotSpeed = world.GetRotSpeed(id);
          desc.m_vRotCenter = world.GetRotCenter(id);
        },
        any);
    scene.m_stdShapes.push_back(any);
  }
  for (const CShapeId id : world.GetBallIds())
    scene.m_stdBalls.emplace_back(world.GetPos(id), world.GetRadius(id), world.GetVel(id), world.GetMass(id),
                                  world.GetElasticity(id));
  return scene;
}

} // namespace Shapes::Games
