// SPDX-License-Identifier: MIT
#include "Solids.h"

#include "../shapes/Effects.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Native {
namespace {

// The kernel of an arc errs by its centre and its radius, and both may be far from its box.
CAabb2D BoxOf(const CShape& shape, float margin = 0.0f) {
  if (shape.GetShapeType() != eShape::Arc) return Padded(shape.GetAABB(), margin);
  const float size = shape.GetPos().cwiseAbs().maxCoeff() + static_cast<const CArc&>(shape).GetRadius();
  return Padded(shape.GetAABB(), margin + g_fBoxPadding * size);
}

// As CShape::Advance turns it, radians.
float TurnIn(const CShape& shape, float dt) { return g_fTwoPi * shape.GetRotSpeed() * dt; }

// No point of a shape moves by more than its turn times its reach, and all stay within their reach.
CAabb2D BoxOfTurn(const CShape& shape, float dt) {
  const auto reach = static_cast<float>(GetReach(shape));
  const float turn = std::abs(TurnIn(shape, dt));
  if (turn < 1.0f) return BoxOf(shape, turn * reach);
  const Vector2& c = shape.GetRotCenter();
  return Padded(CAabb2D(c, c), reach);
}

} // namespace

void CSolids::Sort(const std::vector<CShapeEntry>& shapes) {
  m_stdByRank.clear();
  for (const bool points : {true, false})
    for (const CShapeEntry& entry : shapes)
      if ((entry.m_pShape->GetShapeType() == eShape::Point) == points && !entry.m_pShape->GetSensor())
        m_stdByRank.push_back(&entry);

  for (CGroup* pGroup : {&m_cResting, &m_cTurning}) {
    pGroup->m_stdRank.clear();
    pGroup->m_stdBoxes.clear();
  }
  for (std::uint32_t rank = 0; rank < Size(); ++rank) {
    const CShape& shape = GetShape(rank);
    CGroup& group = shape.GetRotating() ? m_cTurning : m_cResting;
    group.m_stdRank.push_back(rank);
    group.m_stdBoxes.push_back(BoxOf(shape));
  }
  m_cResting.m_cTree.Build(m_cResting.m_stdBoxes);
  m_cTurning.m_cTree.Build(m_cTurning.m_stdBoxes);
  m_stdOutlines.clear();
}

void CSolids::BoxTurning() {
  for (std::size_t i = 0; i < m_cTurning.m_stdRank.size(); ++i)
    m_cTurning.m_stdBoxes[i] = BoxOf(GetShape(m_cTurning.m_stdRank[i]));
  m_cTurning.m_cTree.Refit(m_cTurning.m_stdBoxes);
}

void CSolids::BoxTurning(float dt) {
  for (std::size_t i = 0; i < m_cTurning.m_stdRank.size(); ++i)
    m_cTurning.m_stdBoxes[i] = BoxOfTurn(GetShape(m_cTurning.m_stdRank[i]), dt);
  m_cTurning.m_cTree.Refit(m_cTurning.m_stdBoxes);
}

void CSolids::Query(const CAabb2D& box, std::vector<std::uint32_t>& ranks) {
  for (const CGroup* pGroup : {&m_cResting, &m_cTurning}) {
    m_stdFound.clear();
    pGroup->m_cTree.Query(box, m_stdFound);
    for (const std::uint32_t item : m_stdFound)
      ranks.push_back(pGroup->m_stdRank[item]);
  }
}

void CSolids::MakeOutlines(float dt) {
  const bool all = m_stdOutlines.size() != Size();
  m_stdOutlines.resize(Size());
  if (all)
    for (const std::uint32_t rank : m_cResting.m_stdRank)
      m_stdOutlines[rank] = MakeOutline(GetShape(rank), 0.0);
  for (const std::uint32_t rank : m_cTurning.m_stdRank)
    m_stdOutlines[rank] = MakeOutline(GetShape(rank), static_cast<double>(TurnIn(GetShape(rank), dt)) /
                                                          static_cast<double>(dt));
}

} // namespace Shapes::Native
