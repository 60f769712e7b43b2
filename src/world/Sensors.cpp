// SPDX-License-Identifier: MIT
#include "Sensors.h"

#include "Touches.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace Shapes {
namespace {

// Not smaller, whatever the rounding.
CAabb2D ToFloatBox(const CBox2d& box) {
  const auto low = box.min().cast<float>().eval(), high = box.max().cast<float>().eval();
  return Geometry::Padded({{low.x(), high.y()}, {high.x(), low.y()}});
}

} // namespace

bool CSensors::Begin(CWorldState& state, std::vector<CSensorEvent>& events) {
  if (m_bIsInvalid) FindSensors(state);
  EndLost(state, eMeeting::Sensor, state.m_stdTouching, events);
  return m_bAny;
}

void CSensors::FindSensors(const CWorldState& state) {
  m_stdVertices.clear(); // their balls may have other indices now
  m_stdBalls.clear();
  m_stdStaticShapes.clear();
  m_stdKinematicShapes.clear();
  for (std::uint32_t i = 0; i < state.m_cBalls.Size(); ++i)
    if (state.m_cBalls.m_stdSensor[i]) m_stdBalls.push_back(i);
  for (std::uint32_t i = 0; i < state.m_stdShapes.size(); ++i) {
    const CShape& shape = *state.m_stdShapes[i].m_pShape;
    if (!shape.GetSensor() && m_stdBalls.empty()) continue;
    (shape.GetMotionType() == eMotion::Kinematic ? m_stdKinematicShapes : m_stdStaticShapes).push_back(i);
  }
  m_bShapesChanged = true;
  m_bAny = !m_stdBalls.empty() || !m_stdStaticShapes.empty() || !m_stdKinematicShapes.empty();
  m_bIsInvalid = false;
}

std::span<const CContactEvent> CSensors::Sense(CWorldState& state, float dt,
                                               std::vector<CSensorEvent>& events, CWorldStats& stats) {
  const CBallArrays& b = state.m_cBalls;
  m_stdSeen.clear();
  TakePaths(b);
  TakeShapes(state);
  for (std::size_t i = 0; i < b.Size(); ++i) {
    if (!b.m_stdCanCollide[i]) continue;
    m_stdFound.clear();
    m_cTree.Query(ToFloatBox(m_stdBoxes[i]), m_stdFound);
    for (const std::uint32_t k : m_stdFound)
      TouchShape(b, i, m_stdStatic[k], dt, stats);
    for (const CSensed& sensed : m_stdKinematic)
      TouchShape(b, i, sensed, dt, stats);
  }
  for (const std::size_t i : m_stdBalls) {
    if (!b.m_stdCanCollide[i]) continue;
    for (std::size_t j = 0; j < b.Size(); ++j)
      if (j != i && b.m_stdCanCollide[j] && !(j < i && b.m_stdSensor[j])) // two sensors meet once
        TouchBall(b, std::min(i, j), std::max(i, j), dt, stats);
  }
  ReportChanges(state.m_stdTouching, events);
  return m_stdContacts;
}

void CSensors::TakePaths(const CBallArrays& b) {
  // An engine reports the vertices of each ball in the order of time, but may take the balls in any order.
  std::stable_sort(m_stdVertices.begin(), m_stdVertices.end(),
                   [](const CBallVertex& x, const CBallVertex& y) { return x.m_nBall < y.m_nBall; });
  m_stdPoints.clear();
  m_stdFirst.clear();
  m_stdBoxes.clear();
  auto vertex = m_stdVertices.begin();
  for (std::size_t i = 0; i < b.Size(); ++i) {
    m_stdFirst.push_back(m_stdPoints.size());
    m_stdPoints.push_back({0.0, b.m_stdPrevPos[i].cast<double>()});
    for (; vertex != m_stdVertices.end() && vertex->m_nBall == i; ++vertex)
      m_stdPoints.push_back(
          {std::clamp(vertex->m_cPoint.m_fTime, m_stdPoints.back().m_fTime, 1.0), vertex->m_cPoint.m_vPos});
    m_stdPoints.push_back({1.0, b.m_stdPos[i].cast<double>()});
  }
  m_stdFirst.push_back(m_stdPoints.size());
  for (std::size_t i = 0; i < b.Size(); ++i) {
    const Vector2d r = Vector2d::Constant(b.m_stdRadius[i]);
    const CBox2d box = GetBox(GetPath(i));
    m_stdBoxes.emplace_back(box.min() - r, box.max() + r);
  }
  m_stdVertices.clear();
}

CBallPath CSensors::GetPath(std::size_t i) const {
  return CBallPath(m_stdPoints).subspan(m_stdFirst[i], m_stdFirst[i + 1] - m_stdFirst[i]);
}

void CSensors::TakeShapes(const CWorldState& state) {
  const auto take = [&](const std::vector<std::uint32_t>& shapes, std::vector<CSensed>& sensed) {
    sensed.clear();
    for (const std::uint32_t k : shapes)
      if (state.m_stdShapes[k].m_pShape->GetCanCollide()) sensed.push_back(Take(state.m_stdShapes[k]));
  };
  take(m_stdKinematicShapes, m_stdKinematic);
  if (!std::exchange(m_bShapesChanged, false)) return;
  take(m_stdStaticShapes, m_stdStatic);
  std::vector<CAabb2D> boxes;
  for (const CSensed& sensed : m_stdStatic)
    boxes.push_back(ToFloatBox(sensed.m_cBox));
  m_cTree.Build(boxes);
}

CSensors::CSensed CSensors::Take(const CShapeEntry& entry) {
  const CShape& shape = *entry.m_pShape;
  CSensed sensed{&entry, CZone(shape), CBox2d(), shape.GetRotCenter().cast<double>(), Vector2d::Zero(), 0.0};
  if (shape.GetMoving()) { // else these are of an earlier step
    sensed.m_vMove = shape.GetLastMove().cast<double>();
    sensed.m_fTurn = static_cast<double>(shape.GetLastTurn());
  }
  sensed.m_cBox = sensed.m_cZone.GetBox();
  if (sensed.m_fTurn != 0.0) { // wherever it is within reach of its centre
    const Vector2d low = (sensed.m_cBox.min() - sensed.m_vRotCenter).cwiseAbs();
    const Vector2d high = (sensed.m_cBox.max() - sensed.m_vRotCenter).cwiseAbs();
    const Vector2d reach = Vector2d::Constant(low.cwiseMax(high).norm());
    sensed.m_cBox = CBox2d(sensed.m_vRotCenter - reach, sensed.m_vRotCenter + reach);
  }
  const CBox2d before(sensed.m_cBox.min() - sensed.m_vMove, sensed.m_cBox.max() - sensed.m_vMove);
  sensed.m_cBox.extend(before);
  return sensed;
}

// Of those whose boxes meet.
void CSensors::TouchShape(const CBallArrays& b, std::size_t i, const CSensed& sensed, double dt,
                          CWorldStats& stats) {
  if (!b.m_stdSensor[i] && !sensed.m_pEntry->m_pShape->GetSensor()) return;
  if (!m_stdBoxes[i].intersects(sensed.m_cBox)) return;
  ++stats.m_nSensorTests;
  const CBallPath path = GetPath(i);
  const bool moves = sensed.m_fTurn != 0.0 || !sensed.m_vMove.isZero(0.0);
  if (moves)
    MakeRotatedPath(path, sensed.m_vRotCenter, sensed.m_fTurn, sensed.m_vMove, b.m_stdRadius[i],
                    m_stdOtherPath);
  auto touch = sensed.m_cZone.Touch(moves ? CBallPath(m_stdOtherPath) : path, b.m_stdRadius[i]);
  if (!touch || !DoMeet(b.m_stdFilter[i], sensed.m_pEntry->m_pShape->GetFilter())) return;
  Vector2d velocity = GetVelocity(path, touch->m_fTime) / dt;
  if (moves) { // back to the pose at that time
    const double left = 1.0 - touch->m_fTime, back = -left * sensed.m_fTurn;
    touch->m_vPOI = Turn(touch->m_vPOI, sensed.m_vRotCenter, back);
    touch->m_vNorm = Turn(touch->m_vNorm, Vector2d::Zero(), back);
    const Vector2d d = touch->m_vPOI - sensed.m_vRotCenter;
    velocity -= (sensed.m_fTurn * Geometry::Perp(d) + sensed.m_vMove) / dt;
    touch->m_vPOI -= left * sensed.m_vMove;
  }
  Add(b.m_stdId[i], sensed.m_pEntry->m_cId, *touch, velocity);
}

void CSensors::TouchBall(const CBallArrays& b, std::size_t i, std::size_t j, double dt, CWorldStats& stats) {
  if (!m_stdBoxes[i].intersects(m_stdBoxes[j])) return;
  ++stats.m_nSensorTests;
  MakeRelativePath(GetPath(i), GetPath(j), m_stdOtherPath);
  auto touch = CZone(Vector2d::Zero(), b.m_stdRadius[j]).Touch(m_stdOtherPath, b.m_stdRadius[i]);
  if (!touch || !DoMeet(b.m_stdFilter[i], b.m_stdFilter[j])) return;
  touch->m_vPOI += GetPos(GetPath(j), touch->m_fTime);
  Add(b.m_stdId[i], b.m_stdId[j], *touch, GetVelocity(m_stdOtherPath, touch->m_fTime) / dt);
}

void CSensors::Add(CShapeId ball, CShapeId shape, const CZone::CTouch& touch, const Vector2d& velocity) {
  const double most = std::numeric_limits<float>::max();
  const auto speed = static_cast<float>(std::clamp(-velocity.dot(touch.m_vNorm), 0.0, most));
  m_stdSeen.push_back(
      {{shape, ball, touch.m_vPOI.cast<float>(), touch.m_vNorm.cast<float>(), 0.0f, speed, true},
       touch.m_bAtEnd});
}

// Tells the pairs that were seen from those that touched before.
void CSensors::ReportChanges(std::vector<CTouchingPair>& touching, std::vector<CSensorEvent>& events) {
  const auto pairOf = [](const CSeen& seen) {
    return CTouchingPair{seen.m_cEvent.m_cBall, seen.m_cEvent.m_cShape};
  };
  std::sort(m_stdSeen.begin(), m_stdSeen.end(),
            [&](const CSeen& a, const CSeen& b) { return pairOf(a) < pairOf(b); });
  m_stdContacts.clear();
  m_stdTouching.clear();
  auto old = touching.begin();
  const auto endBefore = [&](const auto& isBefore) {
    for (; old != touching.end() && isBefore(*old); ++old)
      events.push_back(TouchEvent(*old, false));
  };
  for (const CSeen& seen : m_stdSeen) {
    const CTouchingPair pair = pairOf(seen);
    endBefore([&](const CTouchingPair& other) { return other < pair; });
    m_stdContacts.push_back(seen.m_cEvent);
    if (old != touching.end() && *old == pair)
      ++old;
    else
      events.push_back(TouchEvent(pair, true));
    if (seen.m_bAtEnd)
      m_stdTouching.push_back(pair);
    else
      events.push_back(TouchEvent(pair, false));
  }
  endBefore([](const CTouchingPair&) { return true; });
  std::swap(touching, m_stdTouching);
}

} // namespace Shapes
