// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Shape.h>

#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// A grid over shapes that stay where they are. Each cell knows how far from its centre the nearest shape is,
/// so that a ball in the open is told so without looking at any shape, and lists those near it.
class CShapeGrid {
public:
  /// @param shapes  by order
  /// @param orders  those of them that are taken in, ascending
  /// @param reach  the largest radius that ForEachNear is asked for, user units, above 0
  /// @returns whether it could: not where places are so far out that floats of them overflow
  bool Build(std::span<const CShape* const> shapes, std::span<const std::uint32_t> orders, float reach);
  void Clear() { *this = CShapeGrid(); }
  bool IsBuilt() const { return !m_stdCells.empty(); }
  /// Cells that a grid of so many shapes has, about.
  static std::size_t CountCells(std::size_t shapes);

  float GetReach() const { return m_fReach; }
  /// Whether surely no shape comes within r of p; it tells so of most places that are clear.
  bool IsClear(const Vector2& p, float r) const {
    CSpot spot;
    return Find(p, spot) ? IsBeyond(spot.m_pCell->m_fClearance, r, spot) : r <= m_fReach;
  }
  /// Calls f(order) for every shape that comes within r of p, and maybe some others, in ascending order.
  /// @param r  at most GetReach()
  template <class F>
  void ForEachNear(const Vector2& p, float r, const F& f) const {
    CSpot spot;
    if (!Find(p, spot) || IsBeyond(spot.m_pCell->m_fClearance, r, spot)) return;
    for (std::uint32_t k = spot.m_pCell->m_nBegin; k < spot.m_pCell[1].m_nBegin; ++k)
      if (!IsBeyond(m_stdEntries[k].m_fDistance, r, spot)) f(m_stdEntries[k].m_nOrder);
  }

private:
  struct CCell {
    float m_fClearance = 0.0f;  // from its centre to the nearest shape, at least
    std::uint32_t m_nBegin = 0; // of its entries, which end where those of the next cell begin
  };
  struct CEntry {
    std::uint32_t m_nOrder;
    float m_fDistance; // from the centre of the cell, at least
  };
  // A shape near a cell.
  struct CNear {
    std::uint32_t m_nCell;
    CEntry m_cEntry;
  };

  // A place in a cell.
  struct CSpot {
    const CCell* m_pCell;
    float m_fSquare; // of its distance from the centre of the cell
  };

  // None outside of the grid, where no shape is within reach. A NaN is outside.
  bool Find(const Vector2& p, CSpot& spot) const {
    const Vector2 from = p - m_vOrigin;
    if (!(from.x() >= 0.0f && from.x() < m_vExtent.x() && from.y() >= 0.0f && from.y() < m_vExtent.y()))
      return false;
    const auto column = static_cast<std::uint32_t>(m_fCellsPerUnit * from.x());
    const auto row = static_cast<std::uint32_t>(m_fCellsPerUnit * from.y());
    spot = {&m_stdCells[std::size_t{row} * m_nColumns + column],
            (from - GetCenter(static_cast<float>(column), static_cast<float>(row), 1.0f)).squaredNorm()};
    return true;
  }
  // Of a square of cells, from the origin.
  Vector2 GetCenter(float column, float row, float size) const {
    return m_fCellSize * (Vector2(column, row) + Vector2::Constant(0.5f * size));
  }
  // Whether what is farther than `distance` from the centre of the cell is farther than r from the spot.
  static bool IsBeyond(float distance, float r, const CSpot& spot) {
    const float rest = distance - r;
    return rest > 0.0f && rest * rest > spot.m_fSquare;
  }
  void Enter(const CShape& shape, std::uint32_t order, std::uint32_t column, std::uint32_t row,
             std::uint32_t size, std::vector<CNear>& found) const;

  std::vector<CCell> m_stdCells; // row by row, and one more that only ends the last
  std::vector<CEntry> m_stdEntries;
  Vector2 m_vOrigin = Vector2::Zero(), m_vExtent = Vector2::Zero();
  float m_fCellSize = 0.0f, m_fCellsPerUnit = 0.0f;
  std::uint32_t m_nColumns = 0, m_nRows = 0;
  float m_fReach = 0.0f;
  float m_fPad = 0.0f; // what roundings may add up to
};

} // namespace Shapes::Native
