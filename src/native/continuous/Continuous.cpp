// SPDX-License-Identifier: MIT
#include "Continuous.h"

#include "../../shapes/Response.h"
#include "Rounding.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Shapes::Native {

bool CContinuous::CEvent::operator<(const CEvent& other) const {
  return std::tie(m_fTime, m_nBall) > std::tie(other.m_fTime, other.m_nBall);
}

void CContinuous::Step(CBallArrays& balls, CStaticBroadPhase& shapes, bool pairs, const Vector2& gravity,
                       float dt, CWorldStats& stats) {
  m_pBalls = &balls;
  m_pShapes = &shapes;
  m_pStats = &stats;
  m_fStep = static_cast<double>(dt);
  m_vGravity = gravity.cast<double>();
  m_stdContacts.clear();
  m_stdPathVertices.clear();
  m_stdQueue.clear();
  m_cResting.Begin(m_vGravity, m_fStep);
  if (!IsFalling())
    balls.m_bIsDisturbed = true;
  else if (std::exchange(balls.m_bIsDisturbed, false))
    std::fill(balls.m_stdCalm.begin(), balls.m_stdCalm.end(), 0.0f);
  if (IsFalling() && AllSleep(balls) && !shapes.IsAnyMoving()) {
    balls.m_stdPrevPos = balls.m_stdPos;
    return;
  }
  shapes.BoxKinematic(dt);
  shapes.MakeGeometries(dt);

  TakeBalls(balls);
  SortBalls(pairs);
  WakeDisturbed(balls);
  const auto n = static_cast<std::uint32_t>(m_stdBalls.size());
  if (IsFalling())
    FindRestingContacts();
  else
    for (std::uint32_t i = 0; i < n; ++i)
      SetBackFromBalls(i);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (m_stdBalls[i].m_bIsAsleep) continue;
    // Out of one shape may be into another: a ball in a wedge is set back in turns.
    FindShapes(i);
    for (int turn = 0; turn < g_nSetBackRounds && SetBackFromShapes(i); ++turn)
      FindShapes(i);
    if (m_stdBalls[i].m_bIsInPile) continue;
    if (IsFalling())
      for (const std::uint32_t order : m_stdShapesFound)
        if (HoldIfTouching(m_stdBalls[i], order)) ReportHold(m_stdBalls[i]);
    FindFirst(i);
  }
  if (!m_cResting.IsEmpty()) SolveRestingContacts();
  for (std::uint32_t i = 0; i < n; ++i) {
    if (m_stdBalls[i].m_bIsAsleep) continue;
    FindBallImpacts(i);
    Queue(i);
  }

  while (!m_stdQueue.empty()) {
    std::pop_heap(m_stdQueue.begin(), m_stdQueue.end());
    const CEvent event = m_stdQueue.back();
    m_stdQueue.pop_back();
    const CMoving& ball = m_stdBalls[event.m_nBall];
    if (event.m_nVersion != ball.m_nVersion) continue;
    if (ball.m_cNext.m_bIsBall &&
        m_stdBalls[ball.m_cNext.m_nOther].m_nVersion != ball.m_cNext.m_nOtherVersion)
      FindNext(event.m_nBall); // the other one has got another way meanwhile
    else
      Resolve(event.m_nBall);
  }
  PutBalls(balls);
  if (IsFalling()) FallAsleep(balls);
}

// The first impact of a ball with the shapes that were found.
void CContinuous::FindFirst(std::uint32_t i) {
  m_pStats->m_nBallsSwept += !m_stdShapesFound.empty();
  FindNextShape(m_stdBalls[i]);
}

void CContinuous::TakeBalls(const CBallArrays& b) {
  m_stdBoxes.clear();
  std::size_t n = 0;
  double fastest = 0.0; // squared
  for (std::size_t i = 0; i < b.Size(); ++i) {
    if (!b.m_stdCanCollide[i] || b.m_stdSensor[i]) continue;
    // Those of the last substep are taken again: most of what they have is not looked at before it is set.
    if (n == m_stdBalls.size()) m_stdBalls.emplace_back();
    CMoving& ball = m_stdBalls[n++];
    ball.m_nBall = i;
    ball.m_vPos = Join(b.m_stdPos[i], b.m_stdPosTail[i]);
    ball.m_vVel = Join(b.m_stdVel[i], b.m_stdVelTail[i]);
    ball.m_vFall = m_vGravity;
    ball.m_fRadius = static_cast<double>(b.m_stdRadius[i]);
    ball.m_fMass = static_cast<double>(b.m_stdMass[i]);
    ball.m_fElasticity = static_cast<double>(b.m_stdElasticity[i]);
    ball.Begin();
    fastest = std::max(fastest, ball.m_vVel.squaredNorm());
    ball.m_bIsAsleep = IsFalling() && b.m_stdCalm[i] >= g_fCalmTime;
    ball.m_vAcc = ball.m_bIsAsleep ? Vector2d(Vector2d::Zero()) : m_vGravity;
    m_stdBoxes.push_back(GetBox(ball));
  }
  m_stdBalls.resize(n);
  m_fFastest = std::sqrt(fastest);
}

// The tree does not matter to what comes out, so it may be an old one whose boxes have moved on.
void CContinuous::SortBalls(bool pairs) {
  const std::size_t n = pairs ? m_stdBoxes.size() : 0;
  if (n == m_cBallTree.Size() && ++m_nRefits < g_nMaxRefits) return m_cBallTree.Refit(m_stdBoxes);
  m_cBallTree.Build(std::span<const CAabb2D>(m_stdBoxes).first(n));
  m_nRefits = 0;
}

// The floats of a place and a velocity, and under gravity what they lack.
void CContinuous::Put(const Vector2d& p, const Vector2d& v, std::size_t i, CBallArrays& b) const {
  b.m_stdPos[i] = ToFloat(p);
  b.m_stdVel[i] = ToFloat(v);
  if (!IsFalling()) return;
  b.m_stdPosTail[i] = ToFloat(p - b.m_stdPos[i].cast<double>());
  b.m_stdVelTail[i] = ToFloat(v - b.m_stdVel[i].cast<double>());
}

void CContinuous::PutBalls(CBallArrays& b) {
  const auto dt = static_cast<float>(m_fStep);
  b.m_stdPrevPos = b.m_stdPos;
  auto ball = m_stdBalls.begin();
  for (std::size_t i = 0; i < b.Size(); ++i) {
    const bool isSolid = ball != m_stdBalls.end() && ball->m_nBall == i;
    if (isSolid && ball->m_bIsMoved) {
      Advance(*ball, m_fStep - ball->m_fTime);
      Put(ball->m_vPos, ball->m_vVel, i, b);
    } else if (!IsFalling()) {
      Move(b.m_stdPos[i], b.m_stdVel[i], dt);
    } else if (!isSolid || !ball->m_bIsAsleep) {
      const CMotion motion{Join(b.m_stdPos[i], b.m_stdPosTail[i]), Join(b.m_stdVel[i], b.m_stdVelTail[i]),
                           0.0, m_fStep, m_vGravity};
      Put(motion.PosAt(m_fStep), motion.VelAt(m_fStep), i, b);
    }
    ball += isSolid;
  }
}

CMotion CContinuous::GetMotion(const CMoving& ball) const {
  return {ball.m_vPos, ball.m_bIsHalted ? ball.m_vCarried : ball.m_vVel, ball.m_fRadius,
          m_fStep - ball.m_fTime, ball.m_bIsHalted ? Vector2d(Vector2d::Zero()) : ball.m_vAcc};
}

CAabb2D CContinuous::GetBox(const CMoving& ball) const {
  const CMotion motion = GetMotion(ball);
  CAabb2D box(ToFloat(motion.m_vPos), ToFloat(motion.m_vPos));
  box += ToFloat(motion.PosAt(motion.m_fDuration));
  return Padded(box, static_cast<float>(motion.m_fRadius + motion.GetSagitta()) * (1.0f + g_fBoxPadding));
}

// Its motion is another one.
void CContinuous::Rebox(std::uint32_t i) {
  m_stdBoxes[i] = GetBox(m_stdBalls[i]);
  m_cBallTree.Grow(i, m_stdBoxes[i]);
}

void CContinuous::SetBackFromBalls(std::uint32_t i) {
  m_stdBallsFound.clear();
  m_cBallTree.Query(m_stdBoxes[i], m_stdBallsFound);
  std::sort(m_stdBallsFound.begin(), m_stdBallsFound.end());
  for (const std::uint32_t j : m_stdBallsFound) {
    CImpact impact;
    double depth;
    if (j <= i || !OverlapBallBall(GetMotion(m_stdBalls[j]), GetMotion(m_stdBalls[i]), impact, depth))
      continue;
    const double m0 = m_stdBalls[i].m_fMass, m1 = m_stdBalls[j].m_fMass;
    CorrectPosition(i, impact.m_vNorm, depth * (m1 / (m0 + m1)));
    CorrectPosition(j, -impact.m_vNorm, depth * (m0 / (m0 + m1)));
  }
}

// The shapes on the way of the motion, or within reach of it, by order.
void CContinuous::FindShapes(std::uint32_t i, float reach) {
  m_stdShapesFound.clear();
  m_pShapes->Query(reach > 0.0f ? Padded(m_stdBoxes[i], reach) : m_stdBoxes[i], m_stdShapesFound);
  std::sort(m_stdShapesFound.begin(), m_stdShapesFound.end());
}

// From those that were found. Whether it had to.
bool CContinuous::SetBackFromShapes(std::uint32_t i) {
  bool had = false;
  for (const std::uint32_t order : m_stdShapesFound) {
    if (!m_pShapes->Get(order).m_pShape->GetCanCollide()) continue;
    const CMoving& ball = m_stdBalls[i];
    const CShapeGeometry& geometry = m_pShapes->GetGeometry(order);
    CImpact impact;
    double depth;
    if (!Overlap(geometry, GetMotion(ball), 0.0, impact, depth)) continue;
    const bool isRounding = depth <= Rounding(SizeOf(ball.m_vPos, ball.m_fRadius) + geometry.m_fSize);
    if (!isRounding && geometry.m_eSides != eSides::Both) continue;
    CorrectPosition(i, impact.m_vNorm, depth);
    had = true;
  }
  return had;
}

// The share of a push of a ball from p by `way`, all at once, that no shape is in the way of, as they are at
// `time`; those that move together with `along` are not.
double CContinuous::GetFreeShare(const Vector2d& p, const Vector2d& way, double radius, double time,
                                 const CShapeGeometry* along) const {
  CAabb2D box(ToFloat(p), ToFloat(p));
  box += ToFloat(p + way);
  std::vector<std::uint32_t> orders;
  m_pShapes->Query(Padded(box, static_cast<float>(radius) * (1.0f + g_fBoxPadding)), orders);
  CMotion motion{p, way / g_fInstant, radius, g_fInstant};
  for (const std::uint32_t order : orders) {
    const CShapeGeometry& o = m_pShapes->GetGeometry(order);
    if (along != nullptr && o.MovesAs(*along)) continue;
    CImpact impact;
    if (m_pShapes->Get(order).m_pShape->GetCanCollide() && Sweep(o, motion, time, impact) != eSweep::None)
      motion.m_fDuration = std::min(motion.m_fDuration, impact.m_fTime);
  }
  return motion.m_fDuration / g_fInstant;
}

// Moves a ball along n; if it could get through something by that, only up to what is in the way.
void CContinuous::CorrectPosition(std::uint32_t i, const Vector2d& n, double depth) {
  CMoving& ball = m_stdBalls[i];
  if (depth > g_fFarCorrection * ball.m_fRadius) {
    const Vector2d from = ball.m_vPos + Clear(SizeOf(ball.m_vPos, ball.m_fRadius), depth) * n;
    depth *= GetFreeShare(from, depth * n, ball.m_fRadius, 0.0, nullptr);
  }
  ball.m_vPos += depth * n;
  ball.m_bIsMoved = true;
  Rebox(i);
}

} // namespace Shapes::Native
