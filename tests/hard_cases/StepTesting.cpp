// SPDX-License-Identifier: MIT
#include "StepTesting.h"

namespace Shapes::HardCases {

CStepped::CStepped(eColumn column, const std::vector<CAnyShapeDesc>& shapes,
                   const std::vector<CDynamicCircleDesc>& balls, float dt, const Vector2& gravity)
    : m_fTimeStep(dt), m_nShapes(shapes.size()) {
  if (column == Reference) {
    m_cReference.emplace(shapes, balls, gravity);
    return;
  }
  m_pWorld = MakeWorld(column, gravity, dt);
  CSceneDesc scene;
  scene.m_stdShapes = shapes;
  scene.m_stdBalls = balls;
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

namespace {

void SetTimes(CSeen& seen, const CShot& shot) {
  const CDynamicCircleDesc& ball = shot.m_stdBalls[0];
  Vector2d p = ball.m_vPos.cast<double>(), v = ball.m_vVel.cast<double>();
  if (shot.m_stdBalls.size() > 1) {
    p -= shot.m_stdBalls[1].m_vPos.cast<double>();
    v -= shot.m_stdBalls[1].m_vVel.cast<double>();
  }
  // p_end = p + v t + v' (T - t)
  const Vector2d change = v - seen.m_vVel;
  const Vector2d way = seen.m_vPos - p - seen.m_vVel * static_cast<double>(shot.m_fSeconds);
  if (!change.isZero(0.0)) seen.m_fTime = way.dot(change) / change.squaredNorm();
  const Vector2d centre = seen.m_vPOI + static_cast<double>(ball.m_fRadius) * seen.m_vNorm;
  seen.m_fContactTime = (centre - p).dot(v) / v.squaredNorm();
}

CAnswer Bounce(const CVec<CFifty>& v, const CFifty& t, const CVec<CFifty>& n) {
  return {t, n, v - CFifty(2) * v.dot(n) * n};
}

// From outside, side = 1, or from inside, -1; the centres are `reach` apart then.
CAnswer MeetCircle(const CDynamicCircleDesc& ball, const CFifty& reach, int side) {
  const CVec<CFifty> d = ball.m_vPos.cast<CFifty>(), v = ball.m_vVel.cast<CFifty>();
  const CFifty a = v.dot(v), b = d.dot(v), root = sqrt(CFifty(b * b - a * (d.dot(d) - reach * reach)));
  const CFifty t = (-b - side * root) / a;
  return Bounce(v, t, CVec<CFifty>(side * (d + v * t) / reach));
}

} // namespace

CSeen Shoot(eColumn column, const CShot& shot) {
  const bool exact = column == Reference, asNative = IsNative(column) || shot.m_nBox2DSteps == 0;
  const unsigned steps = exact ? 1 : asNative ? shot.m_nSteps : shot.m_nBox2DSteps;
  CStepped stepped(column, shot.m_stdShapes, shot.m_stdBalls, shot.m_fSeconds / static_cast<float>(steps),
                   shot.m_vGravity);
  if (exact && shot.m_vExactPos) stepped.SetPos(0, *shot.m_vExactPos);
  CSeen seen;
  std::optional<CImpact> first;
  for (unsigned i = 0; i < steps; ++i) {
    stepped.Step();
    for (const CImpact& impact : stepped.GetImpacts()) {
      ++seen.m_nContacts;
      if (!first && impact.m_bApproaches) first = impact;
    }
  }
  seen.m_vPos = stepped.GetPos();
  seen.m_vVel = stepped.GetVel();
  if (shot.m_stdBalls.size() > 1) {
    seen.m_vPos -= stepped.GetPos(1);
    seen.m_vVel -= stepped.GetVel(1);
  }
  if (first) {
    seen.m_vPOI = first->m_vPOI;
    seen.m_vNorm = first->m_vNorm;
    seen.m_fSetback = first->m_fSetback;
  }
  if (!exact)
    SetTimes(seen, shot);
  else if (first)
    seen.m_fTime = seen.m_fContactTime = first->m_fTime;
  return seen;
}

CAnswer MeetDisc(const CDynamicCircleDesc& ball, float R) {
  return MeetCircle(ball, CFifty(R) + CFifty(ball.m_fRadius), 1);
}

CAnswer MeetRing(const CDynamicCircleDesc& ball, float R) {
  return MeetCircle(ball, CFifty(R) - CFifty(ball.m_fRadius), -1);
}

CAnswer MeetFloor(const CDynamicCircleDesc& ball) {
  const CVec<CFifty> p = ball.m_vPos.cast<CFifty>(), v = ball.m_vVel.cast<CFifty>();
  return Bounce(v, (p.y() - CFifty(ball.m_fRadius)) / -v.y(), CVec<CFifty>(CFifty(0), CFifty(1)));
}

double ErrorOf(const CSeen& seen, const CAnswer& answer) {
  const double time = std::abs(seen.m_fTime - static_cast<double>(answer.m_fTime));
  if (!std::isfinite(time)) return g_fNever;
  return std::max({time, Distance(seen.m_vNorm, answer.m_vNorm.cast<double>()),
                   Distance(seen.m_vVel, answer.m_vVel.cast<double>())});
}

double ErrorOfFlight(const CSeen& seen, const CShot& shot) {
  const CDynamicCircleDesc& ball = shot.m_stdBalls[0];
  const Vector2d p = shot.m_vExactPos.value_or(ball.m_vPos.cast<double>()), v = ball.m_vVel.cast<double>();
  return std::max({Distance(seen.m_vVel, v),
                   Distance(seen.m_vPos, p + v * static_cast<double>(shot.m_fSeconds)),
                   static_cast<double>(seen.m_nContacts)});
}

CHardCase ShotCase(const CShot& shot, const CAnswer& answer) {
  CHardCase c;
  const double size = std::max(
      {1.0, static_cast<double>(answer.m_fTime), static_cast<double>(answer.m_vVel.cwiseAbs().maxCoeff())});
  c.m_cBound = {16.0 * g_fDoubleRounding * size, 16.0 * g_fFloatRounding * size,
                "t, n and v' within 8 roundings"};
  c.m_fnError = [shot, answer](eColumn column) { return ErrorOf(Shoot(column, shot), answer); };
  return c;
}

} // namespace Shapes::HardCases
