// SPDX-License-Identifier: MIT
#include "NativeWorld.h"

#include "../shapes/Effects.h"
#include "../shapes/Response.h"
#include "../shapes/WorldState.h"

#include <algorithm>

namespace Shapes::Native {
CNativeWorld::CNativeWorld(const CWorldDesc& desc) : CWorld(desc, CWorldLimits()) {}

void CNativeWorld::OnAdded(CShapeId id) { OnChanged(id, eChange::Pose); }

void CNativeWorld::OnRemoved(CShapeId) { m_bShapesChanged = true; }

void CNativeWorld::OnChanged(CShapeId id, eChange what) {
  // Balls are looked at where they are in each step; only shapes have boxes that are kept, unless they are
  // sensors.
  const std::size_t k = State().FindShape(id);
  if (k == CWorldState::npos || what == eChange::Properties) return;
  const CShapeEntry& entry = State().m_stdShapes[k];
  const bool turned = std::find(m_stdTurning.begin(), m_stdTurning.end(), &entry) != m_stdTurning.end();
  if (what != eChange::Motion || turned != entry.m_pShape->GetRotating()) m_bShapesChanged = true;
}

void CNativeWorld::Substep(float dt) {
  if (m_nPlanned != GetContentVersion()) PlanStages();
  for (const CStage stage : m_stdFirst)
    (this->*stage)(dt);
  bool swept = Runs(eEffect::Continuous);
  if (IsContinuousOpen() && GetFastMoves().IsAny(State().m_cBalls.m_stdVel)) {
    swept = true;
    CountContinuous();
  }
  for (const CStage stage : swept ? m_stdContinuous : m_stdApproximate)
    (this->*stage)(dt);
}

void CNativeWorld::PlanStages() {
  m_nPlanned = GetContentVersion();
  if (m_bShapesChanged) {
    m_cSolids.Sort(State().m_stdShapes);
    m_stdTurning.clear();
    for (const CShapeEntry& entry : State().m_stdShapes)
      if (entry.m_pShape->GetRotating()) m_stdTurning.push_back(&entry);
    m_bShapesChanged = false;
  }
  const bool reports = Runs(eEffect::Events);
  m_stdFirst.clear();
  if (Runs(eEffect::Gravity)) m_stdFirst.push_back(&CNativeWorld::Accelerate);

  m_stdApproximate.clear();
  if (Runs(eEffect::Kinematics)) m_stdApproximate.push_back(&CNativeWorld::TurnShapes);
  m_stdApproximate.push_back(&CNativeWorld::MoveBalls);
  if (m_cSolids.Size() > 0)
    m_stdApproximate.push_back(reports ? &CNativeWorld::MeetShapes<true> : &CNativeWorld::MeetShapes<false>);
  if (Runs(eEffect::BallPairs))
    m_stdApproximate.push_back(reports ? &CNativeWorld::MeetBalls<true> : &CNativeWorld::MeetBalls<false>);

  m_stdContinuous = {&CNativeWorld::Sweep};
  if (Runs(eEffect::Kinematics)) m_stdContinuous.push_back(&CNativeWorld::TurnShapes);
}

void CNativeWorld::Accelerate(float dt) {
  CBallArrays& b = State().m_cBalls;
  const Vector2 g = State().m_vGravity;
  for (Vector2& v : b.m_stdVel)
    Shapes::Accelerate(v, g, dt);
  Stats().m_nBallsAccelerated += b.Size();
}

void CNativeWorld::TurnShapes(float dt) {
  for (const CShapeEntry* pEntry : m_stdTurning)
    pEntry->m_pShape->Advance(dt);
  Stats().m_nShapesTurned += m_stdTurning.size();
  m_cSolids.BoxTurning();
}

void CNativeWorld::MoveBalls(float dt) {
  CBallArrays& b = State().m_cBalls;
  b.m_stdPrevPos = b.m_stdPos;
  for (std::size_t i = 0; i < b.Size(); ++i)
    Move(b.m_stdPos[i], b.m_stdVel[i], dt);
}

CBall CNativeWorld::Ball(std::size_t i) const {
  const CBallArrays& b = State().m_cBalls;
  return {b.m_stdPos[i], b.m_stdPrevPos[i], b.m_stdVel[i], b.m_stdRadius[i]};
}

bool CNativeWorld::Meets(std::size_t i) const {
  const CBallArrays& b = State().m_cBalls;
  return b.m_stdCanCollide[i] && !b.m_stdSensor[i];
}

void CNativeWorld::CollectShapes(const CBall& ball, std::uint32_t firstRank) {
  m_stdCandidates.clear();
  const CAabb2D box = Padded(CAabb2D(ball.m_vPos, ball.m_vPos), ball.m_fRadius * (1.0f + g_fCandidateSlack));
  m_cSolids.Query(box, m_stdCandidates);
  if (firstRank > 0) std::erase_if(m_stdCandidates, [=](std::uint32_t rank) { return rank < firstRank; });
  std::sort(m_stdCandidates.begin(), m_stdCandidates.end());
}

template <bool TReports>
void CNativeWorld::MeetShapes(float) {
  const CBallArrays& b = State().m_cBalls;
  for (std::size_t i = 0; i < b.Size(); ++i)
    if (Meets(i)) MeetShapesOf<TReports>(i);
}

template <bool TReports>
void CNativeWorld::MeetShapesOf(std::size_t ball) {
  const CBallArrays& b = State().m_cBalls;
  const float slack = g_fCandidateSlack * b.m_stdRadius[ball];
  Vector2 collectedAt = b.m_stdPos[ball];
  CollectShapes(Ball(ball), 0);
  for (std::size_t k = 0; k < m_stdCandidates.size(); ++k) {
    const std::uint32_t rank = m_stdCandidates[k];
    MeetShape<TReports>(ball, m_cSolids.Get(rank));
    if ((b.m_stdPos[ball] - collectedAt).cwiseAbs().maxCoeff() <= slack) continue;
    // A response has moved the ball out of the reach of what was collected: the rest again, from where it is
    // now.
    collectedAt = b.m_stdPos[ball];
    CollectShapes(Ball(ball), rank + 1);
    k = static_cast<std::size_t>(-1);
  }
}

template <bool TReports>
void CNativeWorld::MeetShape(std::size_t i, const CShapeEntry& entry) {
  const CShape& shape = *entry.m_pShape;
  if (!shape.GetCanCollide()) return;
  ++Stats().m_nShapeTests;
  CHit hit;
  if (!Detect(shape, Ball(i), hit)) return;

  CBallArrays& b = State().m_cBalls;
  const Vector2 surface = shape.GetSurfaceVelocity(hit.m_vPOI);
  if constexpr (TReports)
    Report({entry.m_cId, b.m_stdId[i], hit.m_vPOI, hit.m_vNorm, hit.m_fSetback,
            ApproachSpeed(b.m_stdVel[i], surface, hit.m_vNorm)});
  ++Stats().m_nContacts;
  const float e = b.m_stdElasticity[i] * shape.GetElasticity();
  RespondKinematic(hit.m_vNorm, hit.m_fSetback, e, surface, b.m_stdPos[i], b.m_stdVel[i]);
  Count(CapSpeed(b.m_stdVel[i]));
}

void CNativeWorld::CollectBalls(std::size_t i, std::uint32_t first) {
  const CBallArrays& b = State().m_cBalls;
  m_stdFound.clear();
  m_stdCandidates.clear();
  m_cGrid.Query(b.m_stdPos[i], b.m_stdRadius[i], m_stdFound);
  for (const std::uint32_t j : m_stdFound) {
    if (j < first || !Meets(j)) continue;
    const float reach = (b.m_stdRadius[i] + b.m_stdRadius[j]) * (1.0f + g_fBoxPadding);
    if ((b.m_stdPos[j] - b.m_stdPos[i]).cwiseAbs().maxCoeff() <= reach) m_stdCandidates.push_back(j);
  }
  std::sort(m_stdCandidates.begin(), m_stdCandidates.end());
  m_stdCandidates.erase(std::unique(m_stdCandidates.begin(), m_stdCandidates.end()), m_stdCandidates.end());
}

template <bool TReports>
void CNativeWorld::MeetBalls(float) {
  const CBallArrays& b = State().m_cBalls;
  m_cGrid.Build(b.m_stdPos, b.m_stdRadius);
  for (std::uint32_t i = 0; i + 1 < b.Size(); ++i) {
    if (!Meets(i)) continue;
    CollectBalls(i, i + 1);
    for (std::size_t k = 0; k < m_stdCandidates.size(); ++k) {
      const std::uint32_t j = m_stdCandidates[k];
      if (!MeetBall<TReports>(i, j)) continue;
      m_cGrid.Move(i, b.m_stdPos[i]);
      m_cGrid.Move(j, b.m_stdPos[j]);
      CollectBalls(i, j + 1);
      k = static_cast<std::size_t>(-1);
    }
  }
}

template <bool TReports>
bool CNativeWorld::MeetBall(std::size_t i, std::size_t j) {
  ++Stats().m_nBallTests;
  CHit hit;
  FailIf(!DetectBallBall(Ball(j), Ball(i), hit));

  CBallArrays& b = State().m_cBalls;
  if constexpr (TReports)
    Report({b.m_stdId[j], b.m_stdId[i], hit.m_vPOI, hit.m_vNorm, hit.m_fSetback,
            ApproachSpeed(b.m_stdVel[i], b.m_stdVel[j], hit.m_vNorm)});
  ++Stats().m_nContacts;
  RespondDynamic(hit.m_vNorm, hit.m_fSetback, b.m_stdElasticity[i] * b.m_stdElasticity[j], b.m_stdMass[j],
                 b.m_stdMass[i], b.m_stdPos[j], b.m_stdVel[j], b.m_stdPos[i], b.m_stdVel[i]);
  Count(CapSpeed(b.m_stdVel[j]));
  Count(CapSpeed(b.m_stdVel[i]));
  return true;
}

void CNativeWorld::Sweep(float dt) {
  const bool reports = Runs(eEffect::Events);
  m_cContinuous.Step(State().m_cBalls, m_cSolids, Runs(eEffect::BallPairs), GetKick(), dt, Stats());
  for (const CContinuous::CBend& bend : m_cContinuous.GetBends())
    Bend(bend.m_nBall, bend.m_vPos, bend.m_fPart);
  if (reports)
    for (const CContactEvent& event : m_cContinuous.GetContacts())
      Report(event);
}

} // namespace Shapes::Native
