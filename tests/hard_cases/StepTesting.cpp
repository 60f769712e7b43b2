// SPDX-License-Identifier: MIT
#include "StepTesting.h"

#include <algorithm>
#include <cmath>

namespace Shapes::HardCases {

CSceneDesc MakeScene(std::vector<CAnyShapeDesc> shapes, std::vector<CDynamicCircleDesc> balls, float dt,
                     const Vector2& gravity) {
  CSceneDesc scene;
  scene.m_cWorld.m_vGravity = gravity;
  scene.m_cWorld.m_fTimeStep = dt;
  scene.m_stdShapes = std::move(shapes);
  scene.m_stdBalls = std::move(balls);
  return scene;
}

CStepped::CStepped(eColumn column, const CSceneDesc& scene)
    : m_fTimeStep(scene.m_cWorld.m_fTimeStep), m_nShapes(scene.m_stdShapes.size()) {
  const Vector2& g = scene.m_cWorld.m_vGravity;
  if (column == eColumn::Reference) {
    m_cReference.emplace(scene.m_stdShapes, scene.m_stdBalls, g);
    return;
  }
  m_pWorld = MakeWorld(column, Desc(column, g, m_fTimeStep));
  m_stdIds = scene.AddTo(*m_pWorld);
}

void CStepped::Step(int times) {
  for (int i = 0; i < times; ++i) {
    m_stdEvents.clear();
    if (m_pWorld)
      m_pWorld->Step();
    else
      m_cReference->Step(m_fTimeStep, m_stdEvents);
  }
}

Vector2d CStepped::GetPos(std::size_t ball) const {
  if (!m_pWorld) return m_cReference->GetBall(ball).m_vPos;
  return m_pWorld->GetPos(m_stdIds.at(m_nShapes + ball)).cast<double>();
}

Vector2d CStepped::GetVel(std::size_t ball) const {
  if (!m_pWorld) return m_cReference->GetBall(ball).m_vVel;
  return m_pWorld->GetVel(m_stdIds.at(m_nShapes + ball)).cast<double>();
}

void CStepped::SetPos(std::size_t ball, const Vector2d& p) {
  if (!m_pWorld) return m_cReference->SetBall(ball, p, GetVel(ball));
  m_pWorld->SetPos(m_stdIds.at(m_nShapes + ball), p.cast<float>());
}

void CStepped::SetOrientation(std::size_t shape, float angle) {
  if (!m_pWorld) return m_cReference->SetOrientation(shape, angle);
  m_pWorld->SetOrientation(m_stdIds.at(shape), angle);
}

std::vector<CImpact> CStepped::GetImpacts() const {
  std::vector<CImpact> impacts;
  for (const auto& e : m_stdEvents)
    impacts.push_back({e.m_vPOI, e.m_vNorm, e.m_fDepth, true, e.m_fTime});
  if (m_pWorld)
    for (const CContactEvent& e : m_pWorld->GetContacts())
      impacts.push_back(
          {e.m_vPOI.cast<double>(), e.m_vNorm.cast<double>(), e.m_fSetback, e.m_fSpeed != 0.0f});
  return impacts;
}

double Worst(double a, double b) { return std::isnan(a) || std::isnan(b) ? g_fNever : std::max(a, b); }

double AngleBetween(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

double OffBy(const CStepped& stepped, const Vector2d& p, const Vector2d& v, std::size_t ball) {
  return Worst(Distance(stepped.GetPos(ball), p), Distance(stepped.GetVel(ball), v) / v.norm());
}

Vector2 Turned(double x, double y, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {static_cast<float>(c * x - s * y), static_cast<float>(s * x + c * y)};
}

} // namespace Shapes::HardCases
