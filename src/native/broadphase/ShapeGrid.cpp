// SPDX-License-Identifier: MIT
#include "ShapeGrid.h"

#include "../../Tolerances.h"
#include "../../geometry/VisitShape.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace Shapes::Native {
namespace {

float GetDistance(const CShape& shape, const Vector2& p) {
  const auto from = [&p](const auto& s) { return Length(p - s.ClosestPt(p)); };
  return VisitShape(shape, CPerShape{[&p](const CPoint& point) { return Length(p - point.GetPos()); },
                                     [&](const CLineSeg& s) { return from(s); },
                                     [&](const CCircle& s) { return from(s); },
                                     [&](const CArc& s) { return from(s); }});
}

// Largest number that the distances to a shape near the origin are computed from.
float SizeOf(const CShape& shape) {
  const auto round = [](const CCircle& s) { return s.GetPos().cwiseAbs().maxCoeff() + s.GetRadius(); };
  return VisitShape(shape, CPerShape{[](const CPoint&) { return 0.0f; }, [](const CLineSeg&) { return 0.0f; },
                                     [&](const CCircle& s) { return round(s); },
                                     [&](const CArc& s) { return round(s); }});
}

} // namespace

bool CShapeGrid::Build(std::span<const CPlaced> shapes, const Geometry::CAabbTree& tree, float reach) {
  Clear();
  FailIf(shapes.empty());
  CAabb2D box = shapes.front().m_pShape->GetAABB();
  float size = 0.0f;
  for (const CPlaced& placed : shapes) {
    box += placed.m_pShape->GetAABB();
    size = std::max(size, SizeOf(*placed.m_pShape));
  }
  const Vector2 low(box.GetTopLeft().x(), box.GetBottomRt().y()),
      high(box.GetBottomRt().x(), box.GetTopLeft().y());
  size = std::max({size, low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()}) + reach;
  FailIf(!(size < g_fLargestGrid));

  m_fReach = reach;
  m_fPad = g_fGridPadding * size;
  m_vOrigin = low - Vector2::Constant(reach + 2.0f * m_fPad);
  m_vExtent = high + Vector2::Constant(reach + 2.0f * m_fPad) - m_vOrigin;
  // Where it is long and thin, its length decides.
  const auto cells = static_cast<float>(
      std::clamp<std::size_t>(g_nCellsPerShape * shapes.size(), g_nLeastCells, g_nMostCells));
  m_fCellSize = std::max(std::sqrt(m_vExtent.x() * (m_vExtent.y() / cells)),
                         m_vExtent.maxCoeff() / static_cast<float>(g_nMostColumns));
  FailIf(!(m_fCellSize > 1.0f / g_fLargestGrid));
  m_fCellsPerUnit = 1.0f / m_fCellSize;
  // One more than rounding may make of the last place.
  m_nColumns = static_cast<std::uint32_t>(m_vExtent.x() * m_fCellsPerUnit) + 1;
  m_nRows = static_cast<std::uint32_t>(m_vExtent.y() * m_fCellsPerUnit) + 1;

  m_stdShapes.assign(shapes.begin(), shapes.end());
  m_pTree = &tree;
  m_stdCells.resize(std::size_t{m_nColumns} * m_nRows);
  return true;
}

// All cells of the block in which this one is.
void CShapeGrid::Fill(std::uint32_t column, std::uint32_t row) {
  column -= column % g_nBlock;
  row -= row % g_nBlock;
  const Vector2 center = m_vOrigin + GetCenter(column, row, g_nBlock);
  m_stdFound.clear();
  m_pTree->Query(Geometry::Padded(CAabb2D(center, center), GetReach(g_nBlock) + m_fPad), m_stdFound);
  m_stdNear.clear();
  for (const std::uint32_t item : m_stdFound)
    Enter(m_stdShapes[item], column, row, g_nBlock);
  std::sort(m_stdNear.begin(), m_stdNear.end(), [](const CNear& a, const CNear& b) {
    return std::tie(a.m_nCell, a.m_cEntry.m_nOrder) < std::tie(b.m_nCell, b.m_cEntry.m_nOrder);
  });
  auto near = m_stdNear.begin();
  for (std::uint32_t r = row; r < std::min(row + g_nBlock, m_nRows); ++r)
    for (std::uint32_t c = column; c < std::min(column + g_nBlock, m_nColumns); ++c) {
      const std::uint32_t index = r * m_nColumns + c;
      CCell& cell = m_stdCells[index];
      cell.m_nBegin = static_cast<std::uint32_t>(m_stdEntries.size());
      cell.m_fClearance = GetReach(1);
      for (; near != m_stdNear.end() && near->m_nCell == index; ++near) {
        m_stdEntries.push_back(near->m_cEntry);
        cell.m_fClearance = std::min(cell.m_fClearance, near->m_cEntry.m_fDistance);
      }
      cell.m_nSize = static_cast<std::uint32_t>(m_stdEntries.size()) - cell.m_nBegin;
    }
}

void CShapeGrid::FillAll() {
  if (std::exchange(m_bIsFull, true)) return;
  for (std::uint32_t row = 0; row < m_nRows; row += g_nBlock)
    for (std::uint32_t column = 0; column < m_nColumns; column += g_nBlock)
      if (m_stdCells[std::size_t{row} * m_nColumns + column].m_nBegin == g_nEmpty) Fill(column, row);
}

// Enters a shape in those cells of a square of cells from which it is within reach.
void CShapeGrid::Enter(const CPlaced& placed, std::uint32_t column, std::uint32_t row, std::uint32_t size) {
  if (column >= m_nColumns || row >= m_nRows) return;
  const float distance = GetDistance(*placed.m_pShape, m_vOrigin + GetCenter(column, row, size)) - m_fPad;
  if (distance > GetReach(size)) return;
  if (size == 1) {
    m_stdNear.push_back({row * m_nColumns + column, {placed.m_nOrder, distance}});
    return;
  }
  const std::uint32_t half = size / 2;
  for (const std::uint32_t r : {row, row + half})
    for (const std::uint32_t c : {column, column + half})
      Enter(placed, c, r, half);
}

} // namespace Shapes::Native
