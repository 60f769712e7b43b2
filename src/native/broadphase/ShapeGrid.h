// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Shape.h>

#include "../../Tolerances.h"
#include "../../geometry/AabbTree.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// A grid over shapes that stay where they are. Each cell knows how far from its centre the nearest shape is,
/// so that a ball in the open is told so without looking at any shape, and lists those near it. A tree of
/// boxes says which, once a ball has come near the cell.
class CShapeGrid {
public:
  struct CPlaced {
    const CShape* m_pShape;
    std::uint32_t m_nOrder;
  };
  /// @param shapes  by order
  /// @param tree  of boxes around them, which has to stay, as they have to
  /// @param reach  the largest radius that ForEachNear is asked for, user units, above 0
  /// @returns whether it could: not where places are so far out that floats of them overflow
  bool Build(std::span<const CPlaced> shapes, const Geometry::CAabbTree& tree, float reach);
  void Clear() { *this = CShapeGrid(); }
  bool IsBuilt() const { return !m_stdCells.empty(); }
  /// Fills all cells: from then on questions change nothing.
  void FillAll();
  float GetReach() const { return m_fReach; }
  /// Whether surely no shape comes within r of p; it tells so of most places that are clear.
  bool IsClear(const Vector2& p, float r) {
    // From outside no shape is nearer than from the nearest place of the grid. A NaN is at its origin.
    const Vector2 from = p - m_vOrigin;
    const CSpot spot = FindWithin({std::min(std::max(0.0f, from.x()), m_vExtent.x()),
                                   std::min(std::max(0.0f, from.y()), m_vExtent.y())});
    return IsBeyond(spot.m_pCell->m_fClearance, r, spot);
  }
  /// Calls f(order) for every shape that comes within r of p, and maybe some others, in ascending order,
  /// until it returns false.
  /// @param r  at most GetReach()
  template <class F>
  void ForEachNear(const Vector2& p, float r, const F& f) {
    // Outside of the grid no shape is within reach. A NaN is outside.
    const Vector2 from = p - m_vOrigin;
    if (!(from.x() >= 0.0f && from.x() < m_vExtent.x() && from.y() >= 0.0f && from.y() < m_vExtent.y()))
      return;
    const CSpot spot = FindWithin(from);
    if (IsBeyond(spot.m_pCell->m_fClearance, r, spot)) return;
    const CEntry* const pBegin = m_stdEntries.data() + spot.m_pCell->m_nBegin;
    for (const CEntry& entry : std::span(pBegin, spot.m_pCell->m_nSize))
      if (!IsBeyond(entry.m_fDistance, r, spot) && !f(entry.m_nOrder)) return;
  }

private:
  struct CCell {
    float m_fClearance = 0.0f;                      // from its centre to the nearest shape, at least
    std::uint32_t m_nBegin = g_nEmpty, m_nSize = 0; // of its entries; empty until a ball comes
  };
  static constexpr std::uint32_t g_nEmpty = 0xFFFFFFFFu;
  static constexpr std::uint32_t g_nBlock = 8; // cells in a row that are filled together
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

  // From the origin.
  CSpot FindWithin(const Vector2& from) {
    const auto column = static_cast<std::uint32_t>(m_fCellsPerUnit * from.x());
    const auto row = static_cast<std::uint32_t>(m_fCellsPerUnit * from.y());
    const Vector2 center = GetCenter(column, row, 1);
    CCell& cell = m_stdCells[std::size_t{row} * m_nColumns + column];
    if (cell.m_nBegin == g_nEmpty) [[unlikely]]
      Fill(column, row);
    return {&cell, (from - center).squaredNorm()};
  }
  // Of a square of cells, from the origin.
  Vector2 GetCenter(std::uint32_t column, std::uint32_t row, std::uint32_t size) const {
    return m_fCellSize * (Vector2(static_cast<float>(column), static_cast<float>(row)) +
                          Vector2::Constant(0.5f * static_cast<float>(size)));
  }
  // From the centre of a square of cells to what is within reach of any place in it.
  float GetReach(std::uint32_t size) const {
    return m_fReach + g_fHalfDiagonal * static_cast<float>(size) * m_fCellSize;
  }
  // Whether what is farther than `distance` from the centre of the cell is farther than r from the spot.
  static bool IsBeyond(float distance, float r, const CSpot& spot) {
    const float rest = distance - r;
    // Without a jump, as nobody foresees the answer.
    return (rest > 0.0f) & (rest * rest > spot.m_fSquare);
  }
  void Fill(std::uint32_t column, std::uint32_t row);
  void Enter(const CPlaced& placed, std::uint32_t column, std::uint32_t row, std::uint32_t size);

  std::vector<CPlaced> m_stdShapes; // items of the tree
  const Geometry::CAabbTree* m_pTree = nullptr;
  std::vector<CCell> m_stdCells; // row by row
  std::vector<CEntry> m_stdEntries;
  Vector2 m_vOrigin = Vector2::Zero(), m_vExtent = Vector2::Zero();
  float m_fCellSize = 0.0f, m_fCellsPerUnit = 0.0f;
  std::uint32_t m_nColumns = 0, m_nRows = 0;
  bool m_bIsFull = false; // all cells are filled
  float m_fReach = 0.0f;
  float m_fPad = 0.0f;                   // what roundings may add up to
  std::vector<std::uint32_t> m_stdFound; // of a block, and where in it
  std::vector<CNear> m_stdNear;
};

} // namespace Shapes::Native
