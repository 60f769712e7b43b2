// SPDX-License-Identifier: MIT
#pragma once

#include "../../Tolerances.h"

#include <Shapes/ShapeMath.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// A hashed grid of discs: cells of several widths, so that a few large discs
/// among many small ones do not spoil it. A disc is in the cell of its centre.
class CDiscGrid {
public:
  static constexpr double g_fRounded = 1.0 + static_cast<double>(g_fBoxPadding); // as kernels round it
  struct CDisc {
    Vector2 m_vCenter;
    float m_fRadius;
    /// Whether it lies within another one that is larger by `slack`.
    bool IsWithin(const CDisc& other, float slack = 0.0f) const {
      const auto rest = static_cast<double>(other.m_fRadius + slack - m_fRadius);
      return rest >= 0.0 && (m_vCenter - other.m_vCenter).cast<double>().squaredNorm() <= rest * rest;
    }
    /// Whether they do, as far as kernels do not err.
    bool Overlaps(const CDisc& other) const {
      // In double, where no square overflows.
      const double x = static_cast<double>(other.m_vCenter.x()) - static_cast<double>(m_vCenter.x());
      const double y = static_cast<double>(other.m_vCenter.y()) - static_cast<double>(m_vCenter.y());
      const double reach =
          g_fRounded * (static_cast<double>(m_fRadius) + static_cast<double>(other.m_fRadius));
      return x * x + y * y <= reach * reach;
    }
  };
  /// Takes in these discs instead of those before; the index is the name of a disc from then on.
  void Build(std::span<const CDisc> discs);
  /// Takes this disc instead of the one of this name.
  void Move(std::uint32_t index, const CDisc& disc);
  /// Discs in it, and places that some have left: those are looked at, too, until it is built anew.
  std::size_t Size() const { return m_stdEntries.size(); }
  /// Calls f(index) for every disc that overlaps the disc of radius r about p, maybe more than once, in no
  /// order.
  template <class F>
  void FindNear(const Vector2& p, float r, const F& f) const;

private:
  struct CLevel {
    double m_fCellsPerUnit = 0.0;
    double m_fLargest = 0.0; // radius in it
    std::size_t m_nDiscs = 0;
  };
  struct CEntry {
    CDisc m_cDisc;
    std::uint32_t m_nIndex;
    std::uint32_t m_nNext; // of those that have come to a bucket
  };
  std::size_t GetLevel(float radius) const;
  std::uint32_t Enter(const CDisc& disc);
  static std::int64_t CellAt(double x, const CLevel& level);
  std::uint32_t GetBucket(std::size_t level, std::int64_t x, std::int64_t y) const;

  static constexpr std::uint32_t g_nNone = 0xFFFFFFFFu;
  bool m_bIsFew = false; // no cells: the entries are the discs in their order
  std::array<CLevel, g_nMostLevels> m_stdLevels;
  std::size_t m_nLevels = 0;              // up to the last one that has discs
  unsigned m_nRowBits = 0;                // there are two to this power of buckets in a row
  int m_nTop = 0;                         // exponent of the widest cells
  std::vector<std::uint32_t> m_stdBegins; // of each bucket in the entries; the next one begins where it ends
  std::vector<CEntry> m_stdEntries;       // bucket by bucket, and then those that have come
  std::vector<std::uint32_t> m_stdAdded;  // the last one of each bucket
  std::vector<std::uint32_t> m_stdBucketOf; // of each disc
  std::vector<std::uint32_t> m_stdEntryOf;  // of each disc
};

// Cells that are far out are one: there is nothing to be won there. (std::floor is a call where the processor
// may be an old one.)
inline std::int64_t CDiscGrid::CellAt(double x, const CLevel& level) {
  const double most = 0x1p40, cell = std::min(x * level.m_fCellsPerUnit, most);
  if (!(cell > -most)) return -(std::int64_t{1} << 40); // a NaN, too
  const auto towardsZero = static_cast<std::int64_t>(cell);
  return towardsZero - (static_cast<double>(towardsZero) > cell);
}

// Neighbours in a row are neighbours in memory. Cells that are as far apart as a row is long, or as there are
// rows, share a bucket: few do where all balls are in one place.
inline std::uint32_t CDiscGrid::GetBucket(std::size_t level, std::int64_t x, std::int64_t y) const {
  const std::size_t size = m_stdAdded.size();
  const std::uint64_t cell = (static_cast<std::uint64_t>(y) << m_nRowBits) + static_cast<std::uint64_t>(x);
  return static_cast<std::uint32_t>((cell + level * (size / m_stdLevels.size())) & (size - 1));
}

template <class F>
void CDiscGrid::FindNear(const Vector2& p, float r, const F& f) const {
  const auto px = static_cast<double>(p.x()), py = static_cast<double>(p.y()), pr = static_cast<double>(r);
  const CEntry* const pEntries = m_stdEntries.data();
  const CDisc asked{p, r};
  const auto visit = [=, &f](const CEntry& entry) {
    if (asked.Overlaps(entry.m_cDisc)) f(entry.m_nIndex);
  };
  const auto visitRange = [=](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e)
      visit(pEntries[e]);
  };
  const auto visitAll = [&] { visitRange(0, m_stdEntries.size()); };
  if (m_bIsFew) return visitAll();
  const bool hasAdded = m_stdEntries.size() > m_stdEntryOf.size();
  for (std::size_t k = 0; k < m_nLevels; ++k) {
    const CLevel& level = m_stdLevels[k];
    if (level.m_nDiscs == 0) continue;
    const double reach = g_fRounded * (pr + level.m_fLargest);
    const std::int64_t x0 = CellAt(px - reach, level), x1 = CellAt(px + reach, level);
    const std::int64_t y0 = CellAt(py - reach, level), y1 = CellAt(py + reach, level);
    const auto cells = static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1);
    if (cells > static_cast<double>(m_stdEntries.size())) return visitAll();
    for (std::int64_t y = y0; y <= y1; ++y) {
      // The buckets of a row follow each other, maybe round the end.
      const std::uint32_t first = GetBucket(k, x0, y), last = GetBucket(k, x1, y);
      const bool isRound = last < first;
      visitRange(m_stdBegins[first], m_stdBegins[isRound ? m_stdAdded.size() : last + 1]);
      if (isRound) visitRange(0, m_stdBegins[last + 1]);
      for (std::int64_t x = x0; hasAdded && x <= x1; ++x)
        for (std::uint32_t e = m_stdAdded[GetBucket(k, x, y)]; e != g_nNone; e = m_stdEntries[e].m_nNext)
          visit(m_stdEntries[e]);
    }
  }
}

} // namespace Shapes::Native
