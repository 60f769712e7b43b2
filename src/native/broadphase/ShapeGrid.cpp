// SPDX-License-Identifier: MIT
#include "ShapeGrid.h"

#include "../../Tolerances.h"
#include "../../geometry/VisitShape.h"

#include <algorithm>
#include <bit>
#include <cmath>

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

std::size_t CShapeGrid::CountCells(std::size_t shapes) {
  return std::clamp<std::size_t>(g_nCellsPerShape * shapes, g_nLeastCells, g_nMostCells);
}

bool CShapeGrid::Build(std::span<const CShape* const> shapes, std::span<const std::uint32_t> orders,
                       float reach) {
  Clear();
  FailIf(orders.empty());
  CAabb2D box = shapes[orders.front()]->GetAABB();
  float size = 0.0f;
  for (const std::uint32_t order : orders) {
    box += shapes[order]->GetAABB().GetTopLeft();
    box += shapes[order]->GetAABB().GetBottomRt();
    size = std::max(size, SizeOf(*shapes[order]));
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
  const auto cells = static_cast<float>(CountCells(orders.size()));
  m_fCellSize = std::max(std::sqrt(m_vExtent.x() * (m_vExtent.y() / cells)),
                         m_vExtent.maxCoeff() / static_cast<float>(g_nMostColumns));
  FailIf(!(m_fCellSize > 1.0f / g_fLargestGrid));
  m_fCellsPerUnit = 1.0f / m_fCellSize;
  // One more than rounding may make of the last place.
  m_nColumns = static_cast<std::uint32_t>(m_vExtent.x() * m_fCellsPerUnit) + 1;
  m_nRows = static_cast<std::uint32_t>(m_vExtent.y() * m_fCellsPerUnit) + 1;

  std::vector<CNear> found;
  for (const std::uint32_t order : orders) {
    // From the four squares of cells, or fewer, that hold all within reach of it.
    const CAabb2D& around = shapes[order]->GetAABB();
    const Vector2 first(around.GetTopLeft().x(), around.GetBottomRt().y());
    const Vector2 end(around.GetBottomRt().x(), around.GetTopLeft().y());
    const Vector2 margin = Vector2::Constant(reach + m_fPad + m_fCellSize);
    const float width = (end - first + 2.0f * margin).maxCoeff() * m_fCellsPerUnit;
    const std::uint32_t square = std::bit_ceil(static_cast<std::uint32_t>(width) + 1);
    const Vector2 from = (first - margin - m_vOrigin).cwiseMax(0.0f) * m_fCellsPerUnit;
    const auto column = static_cast<std::uint32_t>(from.x()) / square * square;
    const auto row = static_cast<std::uint32_t>(from.y()) / square * square;
    for (const std::uint32_t r : {row, row + square})
      for (const std::uint32_t c : {column, column + square})
        Enter(*shapes[order], order, c, r, square, found);
  }

  // Sorted by cell; those of a cell stay in the order in which they have come.
  m_stdCells.assign(std::size_t{m_nColumns} * m_nRows + 1, CCell());
  for (CCell& cell : m_stdCells)
    cell.m_fClearance = m_fReach + m_fCellSize * g_fHalfDiagonal;
  for (const CNear& near : found) {
    ++m_stdCells[near.m_nCell].m_nBegin;
    float& clearance = m_stdCells[near.m_nCell].m_fClearance;
    clearance = std::min(clearance, near.m_cEntry.m_fDistance);
  }
  std::uint32_t end = 0;
  for (CCell& cell : m_stdCells)
    cell.m_nBegin = end += cell.m_nBegin;
  m_stdEntries.resize(found.size());
  for (std::size_t k = found.size(); k-- > 0;)
    m_stdEntries[--m_stdCells[found[k].m_nCell].m_nBegin] = found[k].m_cEntry;
  return true;
}

// Enters a shape in those cells of a square of cells from which it is within reach.
void CShapeGrid::Enter(const CShape& shape, std::uint32_t order, std::uint32_t column, std::uint32_t row,
                       std::uint32_t size, std::vector<CNear>& found) const {
  if (column >= m_nColumns || row >= m_nRows) return;
  const auto columns = static_cast<float>(column), rows = static_cast<float>(row),
             side = static_cast<float>(size);
  const Vector2 center = m_vOrigin + GetCenter(columns, rows, side);
  const float distance = GetDistance(shape, center) - m_fPad;
  if (distance > m_fReach + g_fHalfDiagonal * side * m_fCellSize) return;
  if (size == 1) {
    found.push_back({row * m_nColumns + column, {order, distance}});
    return;
  }
  const std::uint32_t half = size / 2;
  for (const std::uint32_t r : {row, row + half})
    for (const std::uint32_t c : {column, column + half})
      Enter(shape, order, c, r, half, found);
}

} // namespace Shapes::Native
