// SPDX-License-Identifier: MIT
#include "PairQuestion.h"

#include <variant>

namespace Shapes::Compare {
namespace {

// CShape::move uses what a game has set; this one sets the scene's step and does gravity itself, which has
// two components here.
struct CStepOfShapes : CShapeCommon {
  static void Set(float dt) {
    m_fTimeStep = dt;
    m_fGravity = 0.0f;
  }
};

std::unique_ptr<CDynamicCircle> Fly(CDynamicCircleDesc desc, const CWorldDesc& world) {
  desc.m_vVel += world.m_vGravity * world.m_fTimeStep;
  auto pBall = std::make_unique<CDynamicCircle>(desc);
  CStepOfShapes::Set(world.m_fTimeStep);
  pBall->move();
  return pBall;
}

// A kinematic shape that does not move is where a static one is, so one class serves both.
std::unique_ptr<CShape> MakeKinematic(CAnyShapeDesc any) {
  std::visit([](CShapeDesc& desc) { desc.m_eMotionType = eMotion::Kinematic; }, any);
  return MakeShape(any);
}

} // namespace

CPairQuestion::CPairQuestion(const CSceneShape& shape, const CDynamicCircleDesc& ball, double time,
                             const CWorldDesc& world)
    : m_pShape(MakeKinematic(shape.m_cDesc)), m_pBall(Fly(ball, world)) {
  if (const Eigen::Vector2d way = OffsetAt(shape, time); !way.isZero(0.0))
    m_pShape->Relocate((m_pShape->GetPos().cast<double>() + way).cast<float>());
  if (const float angle = OrientationAt(shape, time); angle != 0.0f) m_pShape->SetOrientation(angle);
  m_pShape->SetRotSpeed(RotSpeedAt(shape, time, world.m_fTimeStep));
  m_pShape->SetVel(VelAt(shape, time, world.m_fTimeStep));
  m_pShape->Advance(world.m_fTimeStep);
}

CPairQuestion::CPairQuestion(const CDynamicCircleDesc& other, const CDynamicCircleDesc& ball,
                             const CWorldDesc& world)
    : m_pShape(Fly(other, world)), m_pBall(Fly(ball, world)) {}

CPairQuestion::CAnswer CPairQuestion::Ask(const CBackend& backend) const {
  CContactDesc c(m_pShape.get(), m_pBall.get());
  CAnswer answer;
  answer.m_bDetected = backend.CollisionDetected(c);
  if (!answer.m_bDetected) return answer;
  answer.m_fSetback = c.m_fSetback;
  answer.m_vCentre = ToDouble(c.m_vPOI) + static_cast<double>(m_pBall->GetRadius()) * ToDouble(c.m_vNorm);
  return answer;
}

} // namespace Shapes::Compare
