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
  struct CDisc {
    Vector2 m_vCenter;
    float m_fRadius;
  };
  /// Takes in these discs instead of those before; the index is the name of a disc from then on.
  void Build(std::span<const CDisc> discs);
  /// Takes this disc instead of the one of this name.
  void Move(std::uint32_t index, const CDisc& disc);
  /// Discs in it, and places that some have left: those are looked at, too, until it is built anew.
  std::size_t Size() const { return m_stdEntries.size(); }
  /// Calls f(index) for every disc that overlaps the disc of radius r about p, maybe more than once, in no
  /// order, until f returns true; whether it did.
  template <class F>
  bool FindNear(const Vector2& p, float r, const F& f) const;

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
  static bool Overlaps(const CDisc& disc, const Vector2& p, float r);

  static constexpr double g_fRounded = 1.0 + static_cast<double>(g_fBoxPadding); // as kernels round it
  static constexpr std::uint32_t g_nNone = 0xFFFFFFFFu;
  std::array<CLevel, g_nMostLevels> m_stdLevels;
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

inline std::uint32_t CDiscGrid::GetBucket(std::size_t level, std::int64_t x, std::int64_t y) const {
  // Neighbours in a row are neighbours in memory.
  const std::uint64_t row =
      (static_cast<std::uint64_t>(y) * m_stdLevels.size() + level) * 0x9E3779B97F4A7C15u;
  return static_cast<std::uint32_t>(((row >> 32) + static_cast<std::uint64_t>(x)) & (m_stdAdded.size() - 1));
}

// In double, where no square overflows.
inline bool CDiscGrid::Overlaps(const CDisc& disc, const Vector2& p, float r) {
  const double x = static_cast<double>(disc.m_vCenter.x()) - static_cast<double>(p.x());
  const double y = static_cast<double>(disc.m_vCenter.y()) - static_cast<double>(p.y());
  const double reach = g_fRounded * (static_cast<double>(r) + static_cast<double>(disc.m_fRadius));
  return x * x + y * y <= reach * reach;
}

template <class F>
bool CDiscGrid::FindNear(const Vector2& p, float r, const F& f) const {
  const auto visit = [&](std::size_t k) {
    return Overlaps(m_stdEntries[k].m_cDisc, p, r) && f(m_stdEntries[k].m_nIndex);
  };
  const auto visitAll = [&] {
    for (std::size_t e = 0, n = m_stdEntries.size(); e < n; ++e)
      if (visit(e)) return true;
    return false;
  };
  if (m_stdEntries.size() <= g_nFewDiscs) return visitAll();
  for (std::size_t k = 0; k < m_stdLevels.size(); ++k) {
    const CLevel& level = m_stdLevels[k];
    if (level.m_nDiscs == 0) continue;
    const double px = p.x(), py = p.y(), reach = g_fRounded * (static_cast<double>(r) + level.m_fLargest);
    const std::int64_t x0 = CellAt(px - reach, level), x1 = CellAt(px + reach, level);
    const std::int64_t y0 = CellAt(py - reach, level), y1 = CellAt(py + reach, level);
    const auto cells = static_cast<double>(x1 - x0 + 1) * static_cast<double>(y1 - y0 + 1);
    if (cells > static_cast<double>(m_stdEntries.size())) return visitAll();
    for (std::int64_t y = y0; y <= y1; ++y)
      for (std::int64_t x = x0; x <= x1; ++x) {
        const std::uint32_t bucket = GetBucket(k, x, y);
        for (std::size_t e = m_stdBegins[bucket]; e < m_stdBegins[bucket + 1]; ++e)
          if (visit(e)) return true;
        for (std::uint32_t e = m_stdAdded[bucket]; e != g_nNone; e = m_stdEntries[e].m_nNext)
          if (visit(e)) return true;
      }
  }
  return false;
}

} // namespace Shapes::Native
