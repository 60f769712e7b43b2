// SPDX-License-Identifier: MIT
#include "NativeEngine.h"

#include <Shapes/Contact.h>

#include "../Tolerances.h"
#include "../shapes/Response.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace Shapes::Native {

CNativeEngine::CNativeEngine(CWorldCore& world)
    : m_cWorld(world),
      m_cState(world.GetState()),
      m_cLanes(world.GetDesc().m_nThreads),
      m_stdLanes(m_cLanes.Count(std::numeric_limits<std::size_t>::max())) {
  for (CLane& lane : m_stdLanes)
    lane.m_pStats = &lane.m_cStats;
  First().m_pStats = &Stats();
  First().m_cContinuous.SetSubsteps(world.GetDesc().m_nSubsteps);
}

void CNativeEngine::Added(CShapeId id) {
  m_bBallsChanged = true;
  if (const std::size_t k = m_cState.FindShape(id); k != CWorldState::npos && !m_bShapesChanged)
    m_bShapesChanged = !m_cBroadPhase.Add(m_cState.m_stdShapes[k]);
}

void CNativeEngine::Removed(CShapeId id, std::unique_ptr<CShape> pShape) {
  m_bBallsChanged = true;
  if (pShape == nullptr) {
    const std::vector<CShapeId>& ids = m_cState.m_cBalls.m_stdId;
    const auto place = std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
    First().m_cContinuous.ForgetBall(static_cast<std::size_t>(place));
  } else if (!m_bShapesChanged) {
    m_bShapesChanged = !m_cBroadPhase.Remove(std::move(pShape));
  }
}

void CNativeEngine::Changed(CShapeId id, eChange change) {
  // Balls are found where they are in each step; only solid shapes have boxes that are kept.
  const std::size_t k = m_cState.FindShape(id);
  if (change == eChange::Filter) m_bBallsChanged = true;
  if (k == CWorldState::npos) return;
  const CShapeEntry& entry = m_cState.m_stdShapes[k];
  if ((change == eChange::Pose || change == eChange::Reset) && IsSolid(*entry.m_pShape))
    First().m_cContinuous.ShapeWasPut();
  if (change == eChange::Sensor) m_bShapesChanged = true;
  if (!m_bShapesChanged && change <= eChange::Motion) m_cBroadPhase.Update(entry);
}

std::shared_ptr<const CEngineMemory> CNativeEngine::Save() {
  return std::make_shared<CContinuous::CMemory>(First().m_cContinuous.GetMemory());
}

void CNativeEngine::Loaded(const CEngineMemory* pMemory) {
  m_bShapesChanged = m_bBallsChanged = true;
  const auto* const pNative = dynamic_cast<const CContinuous::CMemory*>(pMemory);
  First().m_cContinuous.SetMemory(pNative != nullptr ? *pNative : CContinuous::CMemory());
}

void CNativeEngine::UpdateBroadPhase() {
  m_cBroadPhase.Build(m_cState.m_stdShapes);
  m_stdKinematic.clear();
  for (const CShapeEntry& entry : m_cState.m_stdShapes)
    if (entry.m_pShape->GetMotionType() == eMotion::Kinematic) m_stdKinematic.push_back(entry.m_pShape.get());
  m_bShapesChanged = false;
}

void CNativeEngine::Substep(float dt) {
  if (m_bShapesChanged) UpdateBroadPhase();
  if (!Runs(eEffect::Continuous)) m_cState.m_cBalls.m_cDisturbed.m_bIsEverywhere = true;
  if (std::exchange(m_bBallsChanged, false)) {
    const std::vector<float>& radius = m_cState.m_cBalls.m_stdRadius;
    m_fLargestRadius = radius.empty() ? 0.0f : *std::max_element(radius.begin(), radius.end());
    m_bFilters = HasFilters();
  }
  // Rounded as in CollideWithShapesOf.
  const float near = m_fLargestRadius + g_fCandidateSlack * m_fLargestRadius;
  m_cBroadPhase.SetReach(Runs(eEffect::Continuous) ? g_fGridReach * m_fLargestRadius : near, near);
  if (Runs(eEffect::Continuous)) {
    Sweep(dt);
    if (Runs(eEffect::Kinematics)) MoveShapes(dt);
    return;
  }
  if (Runs(eEffect::Kinematics)) {
    MoveShapes(dt);
    m_cBroadPhase.BoxKinematic(0.0f);
  }
  MoveBalls(dt);
  if (Runs(eEffect::BallPairs)) CollideBalls();
}

bool CNativeEngine::HasFilters() const {
  const auto isOther = [](const CFilter& filter) { return filter != CFilter(); };
  return std::any_of(m_cState.m_cBalls.m_stdFilter.begin(), m_cState.m_cBalls.m_stdFilter.end(), isOther) ||
         std::any_of(m_cState.m_stdShapes.begin(), m_cState.m_stdShapes.end(),
                     [&](const CShapeEntry& entry) { return isOther(entry.m_pShape->GetFilter()); });
}

void CNativeEngine::MoveShapes(float dt) {
  for (CShape* pShape : m_stdKinematic) {
    Stats().m_nShapesTurned += pShape->GetMoving();
    pShape->Advance(dt, m_cWorld.GetLimits().m_fMaxLength);
  }
}

void CNativeEngine::MoveBalls(float dt) {
  CBallArrays& b = m_cState.m_cBalls;
  const bool falls = Runs(eEffect::Gravity);
  const bool canExceed = falls && CanExceedMaxSpeed(m_cState.m_vGravity * dt);
  if (falls) Stats().m_nBallsAccelerated += b.Size();
  ForEachLane([&, gravity = m_cState.m_vGravity](CLane& lane, std::size_t begin, std::size_t end) {
    // Of their own, so that the loop need not look for them after each ball.
    Vector2 *pPos = b.m_stdPos.data(), *pPrevPos = b.m_stdPrevPos.data(), *pVel = b.m_stdVel.data();
    const float* pRadius = b.m_stdRadius.data();
    if (lane.m_stdNear.size() < end - begin) lane.m_stdNear.resize(end - begin);
    std::uint32_t* const pNear = lane.m_stdNear.data();
    std::size_t near = 0;
    std::uint64_t capped = 0, lost = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (falls) Accelerate(pVel[i], gravity, dt);
      if (canExceed) capped += CapSpeed(pVel[i]);
      pPrevPos[i] = pPos[i];
      Move(pPos[i], pVel[i], dt);
      lost += pPos[i] == pPrevPos[i] && pVel[i] != Vector2::Zero();
      // A list, because no processor foresees whether a ball is near a shape.
      pNear[near] = static_cast<std::uint32_t>(i);
      near += !m_cBroadPhase.IsClear(pPos[i], pRadius[i]);
    }
    lane.m_pStats->m_nSpeedsCapped += capped;
    lane.m_pStats->m_nMovesLost += lost;
    for (std::size_t k = 0; k < near; ++k)
      if (b.IsSolid(pNear[k])) CollideWithShapesOf(pNear[k], lane);
  });
}

// Into which the balls are cut.
std::size_t CNativeEngine::CountLanes() {
  if (m_stdLanes.size() == 1) return 1;
  const std::size_t lanes = m_cLanes.Count(m_cState.m_cBalls.Size());
  return lanes > 1 && m_cBroadPhase.MakeShareable() ? lanes : 1;
}

// Calls f(lane, begin, end) for all balls, and takes the contacts and the counts of the lanes in their order.
template <class F>
void CNativeEngine::ForEachLane(const F& f) {
  const std::size_t n = m_cState.m_cBalls.Size(), lanes = CountLanes();
  if (lanes == 1)
    f(First(), 0, n);
  else
    m_cLanes.ForEach(
        n, lanes, [&](std::size_t k, std::size_t begin, std::size_t end) { f(m_stdLanes[k], begin, end); });
  for (std::size_t k = 0; k < lanes; ++k) {
    if (k > 0) AddCounts(m_stdLanes[k]);
    Report(m_stdLanes[k]);
  }
}

void CNativeEngine::AddCounts(CLane& lane) {
  const CWorldStats stats = std::exchange(lane.m_cStats, CWorldStats());
  Stats().m_nShapeTests += stats.m_nShapeTests;
  Stats().m_nSweeps += stats.m_nSweeps;
  Stats().m_nBallsSwept += stats.m_nBallsSwept;
  Stats().m_nMovesLost += stats.m_nMovesLost;
  Stats().m_nContacts += stats.m_nContacts;
  Stats().m_nSpeedsCapped += stats.m_nSpeedsCapped;
}

void CNativeEngine::Report(CLane& lane) {
  for (const CContactEvent& event : lane.m_stdContacts)
    m_cWorld.Report(event);
  lane.m_stdContacts.clear();
}

CBall CNativeEngine::Ball(std::size_t i) const {
  const CBallArrays& b = m_cState.m_cBalls;
  return {b.m_stdPos[i], b.m_stdPrevPos[i], b.m_stdVel[i], b.m_stdRadius[i]};
}

void CNativeEngine::CollideWithShapesOf(std::size_t ball, CLane& lane) {
  const CBallArrays& b = m_cState.m_cBalls;
  const float slack = g_fCandidateSlack * b.m_stdRadius[ball];
  std::uint32_t next = 0; // order of the first shape that is left
  for (bool again = true; again;) {
    again = false;
    const Vector2 from = b.m_stdPos[ball];
    const auto collide = [&](std::uint32_t order) {
      if (order < next) return true;
      next = order + 1;
      const CSolidShape& solid = m_cBroadPhase.Get(order);
      if (m_bFilters && !DoMeet(b.m_stdFilter[ball], solid.m_pShape->GetFilter())) return true;
      CollideWithShape(ball, solid, lane);
      // A response may have moved the ball out of the reach that was searched: the rest again, from where it
      // is.
      again = (b.m_stdPos[ball] - from).squaredNorm() > slack * slack;
      return !again;
    };
    m_cBroadPhase.ForEachNear(from, b.m_stdRadius[ball] + slack, lane.m_stdCandidates, collide);
  }
}

void CNativeEngine::CollideWithShape(std::size_t i, const CSolidShape& solid, CLane& lane) {
  const CShape& shape = *solid.m_pShape;
  if (!shape.GetCanCollide()) return;
  ++lane.m_pStats->m_nShapeTests;
  CHit hit;
  if (!Collide(shape, Ball(i), hit)) return;

  CBallArrays& b = m_cState.m_cBalls;
  const Vector2 surface = shape.GetSurfaceVelocity(hit.m_vPOI);
  const float e = b.m_stdElasticity[i] * shape.GetElasticity();
  if (Runs(eEffect::Events)) {
    const float speed = ApproachSpeed(b.m_stdVel[i], surface, hit.m_vNorm);
    lane.m_stdContacts.push_back({solid.m_cId, b.m_stdId[i], hit.m_vPOI, hit.m_vNorm, hit.m_fSetback, speed,
                                  false, ImpulseOf(b.m_stdMass[i], e, speed)});
  }
  ++lane.m_pStats->m_nContacts;
  RespondKinematic(hit.m_vNorm, hit.m_fSetback, e, surface, b.m_stdPos[i], b.m_stdVel[i]);
  lane.m_pStats->m_nSpeedsCapped += CapSpeed(b.m_stdVel[i]);
}

// A disc around each ball with some margin, so that not every response has to update the grid.
void CNativeEngine::BuildDiscGrid() {
  const CBallArrays& b = m_cState.m_cBalls;
  m_stdDiscs.clear();
  for (std::size_t i = 0; i < b.Size(); ++i)
    m_stdDiscs.push_back({b.m_stdPos[i], b.m_stdRadius[i] * (1.0f + g_fCandidateSlack)});
  m_cDiscGrid.Build(m_stdDiscs);
}

void CNativeEngine::MoveInDiscGrid(std::uint32_t i) {
  const CBallArrays& b = m_cState.m_cBalls;
  const float slack = g_fCandidateSlack * b.m_stdRadius[i];
  if (Length(b.m_stdPos[i] - m_stdDiscs[i].m_vCenter) <= slack) return;
  // Those of the places where it was have to be forgotten now and then.
  if (m_cDiscGrid.Size() > g_nMostDiscs * b.Size()) return BuildDiscGrid();
  m_stdDiscs[i].m_vCenter = b.m_stdPos[i];
  m_cDiscGrid.Move(i, m_stdDiscs[i]);
}

void CNativeEngine::CollectBalls(std::uint32_t i, std::uint32_t first) {
  const CBallArrays& b = m_cState.m_cBalls;
  std::vector<std::uint32_t>& balls = First().m_stdCandidates;
  balls.clear();
  m_cDiscGrid.FindNear(b.m_stdPos[i], b.m_stdRadius[i], [&](std::uint32_t j) {
    const float reach = (b.m_stdRadius[i] + b.m_stdRadius[j]) * (1.0f + g_fBoxPadding);
    if (j >= first && b.IsSolid(j) && (b.m_stdPos[j] - b.m_stdPos[i]).cwiseAbs().maxCoeff() <= reach)
      balls.push_back(j);
  });
  if (balls.empty()) return;
  if (m_bFilters)
    std::erase_if(balls, [&](std::uint32_t j) { return !DoMeet(b.m_stdFilter[i], b.m_stdFilter[j]); });
  std::sort(balls.begin(), balls.end());
  balls.erase(std::unique(balls.begin(), balls.end()), balls.end());
}

void CNativeEngine::CollideBalls() {
  const CBallArrays& b = m_cState.m_cBalls;
  const std::vector<std::uint32_t>& balls = First().m_stdCandidates;
  BuildDiscGrid();
  for (std::uint32_t i = 0; i + 1 < b.Size(); ++i) {
    if (!b.IsSolid(i)) continue;
    CollectBalls(i, i + 1);
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const std::uint32_t j = balls[k];
      if (!CollideWithBall(i, j)) continue;
      MoveInDiscGrid(i);
      MoveInDiscGrid(j);
      CollectBalls(i, j + 1);
      k = static_cast<std::size_t>(-1);
    }
  }
}

bool CNativeEngine::CollideWithBall(std::size_t i, std::size_t j) {
  ++Stats().m_nBallTests;
  CHit hit;
  FailIf(!CollideBallBall(Ball(j), Ball(i), hit));

  CBallArrays& b = m_cState.m_cBalls;
  const float e = b.m_stdElasticity[i] * b.m_stdElasticity[j];
  if (Runs(eEffect::Events)) {
    const float speed = ApproachSpeed(b.m_stdVel[i], b.m_stdVel[j], hit.m_vNorm);
    m_cWorld.Report({b.m_stdId[j], b.m_stdId[i], hit.m_vPOI, hit.m_vNorm, hit.m_fSetback, speed, false,
                     ImpulseOf(ReducedMass(b.m_stdMass[i], b.m_stdMass[j]), e, speed)});
  }
  ++Stats().m_nContacts;
  RespondDynamic(hit.m_vNorm, hit.m_fSetback, e, b.m_stdMass[j], b.m_stdMass[i], b.m_stdPos[j], b.m_stdVel[j],
                 b.m_stdPos[i], b.m_stdVel[i]);
  Count(CapSpeed(b.m_stdVel[j]));
  Count(CapSpeed(b.m_stdVel[i]));
  return true;
}

void CNativeEngine::Sweep(float dt) {
  const Vector2 gravity = Runs(eEffect::Gravity) ? m_cState.m_vGravity : Vector2(Vector2::Zero());
  if (Runs(eEffect::Gravity)) Stats().m_nBallsAccelerated += m_cState.m_cBalls.Size();
  const bool pairs = Runs(eEffect::BallPairs);
  for (CLane& lane : m_stdLanes)
    lane.m_cContinuous.Begin(m_cState.m_cBalls, m_cBroadPhase, pairs, m_bFilters, gravity, dt,
                             *lane.m_pStats);
  CContinuous& all = First().m_cContinuous;
  const bool moves = all.Prepare();
  if (moves && pairs) all.MoveTogether();
  if (moves && !pairs) {
    ForEachLane(
        [](CLane& lane, std::size_t begin, std::size_t end) { lane.m_cContinuous.MoveAlone(begin, end); });
    for (std::size_t k = 1; k < CountLanes(); ++k)
      all.Append(m_stdLanes[k].m_cContinuous);
  }
  for (const CContinuous::CPathVertex& vertex : all.GetPathVertices())
    m_cWorld.AddPathVertex(vertex.m_nBall, vertex.m_vPos, vertex.m_fPart);
  for (const CShapeId ball : all.GetHalted())
    m_cWorld.ReportHalted(ball);
  if (!Runs(eEffect::Events)) return;
  for (const CContactEvent& event : all.GetContacts())
    m_cWorld.Report(event);
}

namespace {

CBall ToBall(const CDynamicCircle& circle) {
  return {circle.GetPos(), circle.GetPrevPos(), circle.GetVel(), circle.GetRadius()};
}

bool CollidePair(CContactDesc& c) {
  // Most pairs of a game are far from each other, and their boxes say so.
  FailIf(!(Geometry::Padded(c.m_pShape->GetAABB(), c.m_pCircle->GetRadius()) && c.m_pCircle->GetPos()));
  const CBall ball = ToBall(*c.m_pCircle);
  CHit hit;
  FailIf(!(c.m_pShape->GetMotionType() == eMotion::Dynamic
               ? CollideBallBall(ToBall(static_cast<const CDynamicCircle&>(*c.m_pShape)), ball, hit)
               : Collide(*c.m_pShape, ball, hit)));
  c.m_vPOI = hit.m_vPOI;
  c.m_vNorm = hit.m_vNorm;
  c.m_fSetback = hit.m_fSetback;
  return true;
}

std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) {
  return std::make_unique<CWorld>(
      std::make_unique<CWorldCore>(desc, CWorldLimits(), CEffects(),
                                   [](CWorldCore& world) { return std::make_unique<CNativeEngine>(world); }));
}

} // namespace

extern const CBackend::CEntry g_cEntry{"native", CollidePair, MakeWorld};

} // namespace Shapes::Native
