// SPDX-License-Identifier: MIT
#include "StaticBroadPhase.h"

#include "../../Tolerances.h"
#include "../../geometry/VisitShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace Shapes::Native {
namespace {

// The kernel of an arc errs by its centre and its radius, and both may be far from its box.
CAabb2D BoxOf(const CShape& shape, float margin = 0.0f) {
  const float size = VisitShape(
      shape, CPerShape{[](const CPoint&) { return 0.0f; }, [](const CLineSeg&) { return 0.0f; },
                       [](const CCircle&) { return 0.0f; },
                       [](const CArc& arc) { return arc.GetPos().cwiseAbs().maxCoeff() + arc.GetRadius(); }});
  return Padded(shape.GetAABB(), margin + g_fBoxPadding * size);
}

// As CShape::Advance turns it, radians.
float TurnIn(const CShape& shape, float dt) { return g_fTwoPi * shape.GetRotSpeed() * dt; }

// Distance of the farthest point of a shape from the centre about which it turns. Error a few roundings in
// double.
double GetReach(const CShape& shape) {
  const auto from = [&](const Vector2& p) {
    return (p.cast<double>() - shape.GetRotCenter().cast<double>()).norm();
  };
  const auto ofDisk = [&](const CCircle& circle) { return from(circle.GetPos()) + circle.GetRadius(); };
  return VisitShape(shape, CPerShape{[&](const CPoint& point) { return from(point.GetPos()); },
                                     [&](const CLineSeg& seg) {
                                       return std::max(from(seg.GetEndPt0()), from(seg.GetEndPt1()));
                                     },
                                     [&](const CCircle& circle) { return ofDisk(circle); },
                                     [&](const CArc& arc) { return ofDisk(arc); }});
}

// No point of a shape turns by more than its turn times its reach, and all stay within their reach.
CAabb2D BoxOfMove(const CShape& shape, float dt) {
  const auto reach = static_cast<float>(GetReach(shape));
  const float turn = std::abs(TurnIn(shape, dt)), way = Length(shape.GetVel()) * dt * (1.0f + g_fBoxPadding);
  if (turn < 1.0f) return BoxOf(shape, turn * reach + way);
  const Vector2& c = shape.GetRotCenter();
  return Padded(CAabb2D(c, c), reach + way);
}

} // namespace

void CStaticBroadPhase::Build(const std::vector<CShapeEntry>& shapes) {
  m_stdByOrder.clear();
  m_stdRemoved.clear();
  for (const bool points : {true, false})
    for (const CShapeEntry& entry : shapes)
      if ((entry.m_pShape->GetShapeType() == eShape::Point) == points && !entry.m_pShape->GetSensor())
        m_stdByOrder.push_back({entry.m_cId, entry.m_pShape.get()});

  for (CGroup* pGroup : {&m_cStatic, &m_cKinematic}) {
    pGroup->m_stdOrder.clear();
    pGroup->m_stdBoxes.clear();
  }
  for (std::uint32_t order = 0; order < Size(); ++order) {
    const CShape& shape = GetShape(order);
    CGroup& group = shape.GetMotionType() == eMotion::Kinematic ? m_cKinematic : m_cStatic;
    group.m_stdOrder.push_back(order);
    group.m_stdBoxes.push_back(BoxOf(shape));
  }
  m_stdIsOld.assign(Size(), 1);
  m_stdOld.resize(Size());
  std::iota(m_stdOld.begin(), m_stdOld.end(), 0u);
  m_bIsBoxedAtRest = false;
  m_cStatic.BuildTree();
  m_cKinematic.BuildTree();
  m_stdGeometries.resize(Size());
  DropGrid();
}

bool CStaticBroadPhase::Add(const CShapeEntry& entry) {
  const CShape& shape = *entry.m_pShape;
  FailIf(shape.GetMotionType() == eMotion::Kinematic);
  if (shape.GetSensor()) return true; // it is not in it
  FailIf(shape.GetShapeType() == eShape::Point);
  FailIf(m_cStatic.m_stdBoxes.size() >= m_cStatic.m_cTree.Size() + g_nMostLoose);
  const auto order = static_cast<std::uint32_t>(Size());
  m_stdByOrder.push_back({entry.m_cId, entry.m_pShape.get()});
  m_stdGeometries.emplace_back();
  m_stdIsOld.push_back(1);
  m_stdOld.push_back(order);
  m_cStatic.m_stdOrder.push_back(order);
  m_cStatic.m_stdBoxes.push_back(BoxOf(shape));
  Loosen(order, m_cStatic.m_stdBoxes.back());
  return true;
}

// It is not where the grid has it.
void CStaticBroadPhase::Loosen(std::uint32_t order, const CAabb2D& box) {
  if (!m_cGrid.IsBuilt()) return;
  m_nAsked = m_nLasted = 0;
  m_bIsGridComplete = false;
  std::erase_if(m_stdLoose, [=](const CLoose& loose) { return loose.m_nOrder == order; });
  m_stdLoose.push_back({order, box});
  if (m_stdLoose.size() > g_nMostLoose) DropGrid();
}

bool CStaticBroadPhase::Remove(std::unique_ptr<CShape> pShape) {
  FailIf(pShape->GetMotionType() == eMotion::Kinematic);
  if (pShape->GetSensor()) return true; // it is not in it
  FailIf(g_nLeastKeptShare * (m_stdRemoved.size() + 1) > Size());
  pShape->SetCanCollide(false);
  m_stdRemoved.push_back(std::move(pShape));
  return true;
}

void CStaticBroadPhase::Update(const CShapeEntry& entry) {
  const auto place = [](const CSolidShape& solid) {
    return std::pair(solid.m_pShape->GetShapeType() != eShape::Point, solid.m_cId);
  };
  const CSolidShape wanted{entry.m_cId, entry.m_pShape.get()};
  const auto it = std::lower_bound(
      m_stdByOrder.begin(), m_stdByOrder.end(), wanted,
      [&](const CSolidShape& solid, const CSolidShape& other) { return place(solid) < place(other); });
  if (it == m_stdByOrder.end() || it->m_cId != entry.m_cId) return; // a sensor
  const auto order = static_cast<std::uint32_t>(it - m_stdByOrder.begin());
  const CShape& shape = GetShape(order);
  CGroup& group = shape.GetMotionType() == eMotion::Kinematic ? m_cKinematic : m_cStatic;
  const auto item = std::lower_bound(group.m_stdOrder.begin(), group.m_stdOrder.end(), order);
  const auto i = static_cast<std::uint32_t>(item - group.m_stdOrder.begin());
  if (!std::exchange(m_stdIsOld[order], std::uint8_t{1})) m_stdOld.push_back(order);
  m_bIsBoxedAtRest = false;
  group.m_stdBoxes[i] = BoxOf(shape);
  if (&group == &m_cStatic) Loosen(order, group.m_stdBoxes[i]);
  if (i >= group.m_cTree.Size()) return;
  // The box of the old place stays in the tree, which makes it less selective, until all are fitted again.
  if (++group.m_nGrown < group.m_cTree.Size()) return group.m_cTree.Grow(i, group.m_stdBoxes[i]);
  group.m_cTree.Refit(std::span(group.m_stdBoxes).first(group.m_cTree.Size()));
  group.m_nGrown = 0;
}

void CStaticBroadPhase::BoxKinematic(float dt) {
  const bool wasBoxedAtRest = std::exchange(m_bIsBoxedAtRest, !IsAnyMoving());
  if (wasBoxedAtRest && m_bIsBoxedAtRest) return;
  for (std::size_t i = 0; i < m_cKinematic.m_stdOrder.size(); ++i)
    m_cKinematic.m_stdBoxes[i] = BoxOfMove(GetShape(m_cKinematic.m_stdOrder[i]), dt);
  m_cKinematic.m_cTree.Refit(m_cKinematic.m_stdBoxes);
}

bool CStaticBroadPhase::IsAnyMoving() const {
  const auto& orders = m_cKinematic.m_stdOrder;
  return std::any_of(orders.begin(), orders.end(),
                     [this](std::uint32_t order) { return GetShape(order).GetMoving(); });
}

bool CStaticBroadPhase::MovesNear(const CAabb2D& box) const {
  for (std::size_t i = 0; i < m_cKinematic.m_stdOrder.size(); ++i)
    if (GetShape(m_cKinematic.m_stdOrder[i]).GetMoving() && (m_cKinematic.m_stdBoxes[i] && box)) return true;
  return false;
}

void CStaticBroadPhase::Query(const CAabb2D& box, std::vector<std::uint32_t>& orders) {
  CountQuestion();
  for (const CGroup* pGroup : {&m_cStatic, &m_cKinematic})
    Query(*pGroup, box, orders);
}

void CStaticBroadPhase::Query(const CGroup& group, const CAabb2D& box, std::vector<std::uint32_t>& orders) {
  const std::size_t first = orders.size();
  group.m_cTree.Query(box, orders);
  for (auto i = static_cast<std::uint32_t>(group.m_cTree.Size()); i < group.m_stdBoxes.size(); ++i)
    if (group.m_stdBoxes[i] && box) orders.push_back(i);
  for (std::size_t k = first; k < orders.size(); ++k)
    orders[k] = group.m_stdOrder[orders[k]];
}

void CStaticBroadPhase::DropGrid() {
  m_cGrid.Clear();
  m_stdLoose.clear();
  m_bIsGridComplete = false;
  m_nAsked = m_nLasted = 0;
}

bool CStaticBroadPhase::MakeShareable() {
  FailIf(m_nLasted < g_nBeforeSharing);
  m_cGrid.FillAll();
  return true;
}

void CStaticBroadPhase::SetReach(float reach, float least) {
  if (m_cGrid.IsBuilt() && !(least <= m_cGrid.GetReach() && m_cGrid.GetReach() <= g_fMostGridReach * reach))
    DropGrid();
  if (IsGridLasting()) {
    m_nLasted += m_nLasted < g_nBeforeSharing;
    return;
  }
  if (m_nAsked < g_nAskedBeforeGrid) return;
  DropGrid();
  if (!m_cStatic.IsTreeComplete()) m_cStatic.BuildTree();
  std::vector<CShapeGrid::CPlaced> shapes;
  for (const std::uint32_t order : m_cStatic.m_stdOrder)
    shapes.push_back({&GetShape(order), order});
  m_bIsGridComplete = m_cGrid.Build(shapes, m_cStatic.m_cTree, reach) && m_cKinematic.m_stdOrder.empty();
}

// Of those that are not in the grid, if they are few.
bool CStaticBroadPhase::IsClearOfOthers(const Vector2& p, float r) const {
  FailIf(m_cKinematic.m_stdBoxes.size() > g_nMostLoose);
  const CAabb2D box = Padded(CAabb2D(p, p), r);
  const auto& boxes = m_cKinematic.m_stdBoxes;
  return std::none_of(boxes.begin(), boxes.end(), [&](const CAabb2D& other) { return other && box; }) &&
         std::none_of(m_stdLoose.begin(), m_stdLoose.end(),
                      [&](const CLoose& loose) { return loose.m_cBox && box; });
}

// Those that the grid does not tell, to those that it does.
void CStaticBroadPhase::FindOthers(const Vector2& p, float r, bool isInGrid,
                                   std::vector<std::uint32_t>& orders) {
  CountQuestion();
  const CAabb2D box = Padded(CAabb2D(p, p), r);
  if (!isInGrid) Query(m_cStatic, box, orders);
  Query(m_cKinematic, box, orders);
  for (const CLoose& loose : m_stdLoose)
    if (loose.m_cBox && box) orders.push_back(loose.m_nOrder);
  // A shape that has moved may be where it was, too.
  std::sort(orders.begin(), orders.end());
  if (!m_stdLoose.empty()) orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
}

void CStaticBroadPhase::MakeGeometries(float dt) {
  const auto make = [&](std::uint32_t order) {
    const CShape& shape = GetShape(order);
    const double speed =
        shape.GetRotating() ? static_cast<double>(TurnIn(shape, dt)) / static_cast<double>(dt) : 0.0;
    m_stdGeometries[order] = MakeShapeGeometry(shape, speed);
  };
  for (const std::uint32_t order : m_stdOld) {
    make(order);
    m_stdIsOld[order] = 0;
  }
  m_stdOld.clear();
  for (const std::uint32_t order : m_cKinematic.m_stdOrder)
    if (GetShape(order).GetMoving()) make(order);
}

} // namespace Shapes::Native
