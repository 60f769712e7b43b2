// SPDX-License-Identifier: MIT
#include "HashGrid.h"

#include "../../Tolerances.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace Shapes::Native {
namespace {

constexpr std::uint32_t g_nNone = 0xFFFFFFFFu;
// Balls smaller than the largest by more than this many powers of two share one level.
constexpr int g_nMostLevels = 12;

} // namespace

void CHashGrid::Build(std::span<const Vector2> pos, std::span<const float> radius) {
  const std::size_t n = pos.size();
  m_stdLevelOf.resize(n);
  m_stdBucketOf.resize(n);
  m_stdNext.resize(n);
  m_stdPrev.resize(n);
  m_stdHead.assign(std::bit_ceil(2 * n + 1), g_nNone);
  m_stdLevels.clear();
  if (n == 0) return;

  // Level 0 has the widest cells, each level half of the one before. Empty levels cost nothing when asked.
  const float largest = *std::max_element(radius.begin(), radius.end());
  const int top = largest > 0.0f ? std::ilogb(largest) + 2 : 0; // 2^top > diameter
  for (int k = 0; k < g_nMostLevels; ++k)
    m_stdLevels.push_back({std::ldexp(1.0, top - k), 0.0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const int exponent = radius[i] > 0.0f ? std::ilogb(radius[i]) + 2 : top - g_nMostLevels;
    const auto level = static_cast<std::uint32_t>(std::min(top - exponent, g_nMostLevels - 1));
    m_stdLevelOf[i] = level;
    m_stdLevels[level].m_fLargest = std::max(m_stdLevels[level].m_fLargest, static_cast<double>(radius[i]));
    ++m_stdLevels[level].m_nBalls;
    Link(i, pos[i]);
  }
}

std::uint32_t CHashGrid::Bucket(std::uint32_t level, double x, double y) const {
  // The bits of the (whole) cell numbers: no overflow however far out a ball is.
  std::uint64_t h = std::bit_cast<std::uint64_t>(x + 0.0) * 0x9E3779B97F4A7C15u;
  h = (h ^ (h >> 29) ^ std::bit_cast<std::uint64_t>(y + 0.0)) * 0xBF58476D1CE4E5B9u;
  h = (h ^ (h >> 32) ^ level) * 0x94D049BB133111EBu;
  return static_cast<std::uint32_t>(h >> 33) & static_cast<std::uint32_t>(m_stdHead.size() - 1);
}

void CHashGrid::Link(std::uint32_t i, const Vector2& p) {
  const std::uint32_t level = m_stdLevelOf[i];
  const double cell = m_stdLevels[level].m_fCell;
  const std::uint32_t b = Bucket(level, std::floor(static_cast<double>(p.x()) / cell),
                                 std::floor(static_cast<double>(p.y()) / cell));
  m_stdBucketOf[i] = b;
  m_stdPrev[i] = g_nNone;
  m_stdNext[i] = m_stdHead[b];
  if (m_stdHead[b] != g_nNone) m_stdPrev[m_stdHead[b]] = i;
  m_stdHead[b] = i;
}

void CHashGrid::Move(std::uint32_t i, const Vector2& p) {
  if (m_stdPrev[i] != g_nNone)
    m_stdNext[m_stdPrev[i]] = m_stdNext[i];
  else
    m_stdHead[m_stdBucketOf[i]] = m_stdNext[i];
  if (m_stdNext[i] != g_nNone) m_stdPrev[m_stdNext[i]] = m_stdPrev[i];
  Link(i, p);
}

void CHashGrid::Query(const Vector2& p, float r, std::vector<std::uint32_t>& found) const {
  const double px = p.x(), py = p.y();
  for (std::uint32_t level = 0; level < m_stdLevels.size(); ++level) {
    const CLevel& l = m_stdLevels[level];
    if (l.m_nBalls == 0) continue;
    const double reach = (static_cast<double>(r) + l.m_fLargest) * (1.0 + static_cast<double>(g_fBoxPadding));
    const double x0 = std::floor((px - reach) / l.m_fCell), x1 = std::floor((px + reach) / l.m_fCell);
    const double y0 = std::floor((py - reach) / l.m_fCell), y1 = std::floor((py + reach) / l.m_fCell);
    // Written so that a position that is not finite ends here too.
    if (!((x1 - x0 + 1.0) * (y1 - y0 + 1.0) <= static_cast<double>(l.m_nBalls) + 16.0) ||
        !(std::max({-x0, x1, -y0, y1}) < 0x1p52)) {
      // More cells than balls (or cells too far out to be counted one by one): every ball of the level.
      for (std::uint32_t i = 0; i < m_stdLevelOf.size(); ++i)
        if (m_stdLevelOf[i] == level) found.push_back(i);
      continue;
    }
    for (double x = x0; x <= x1; x += 1.0)
      for (double y = y0; y <= y1; y += 1.0)
        for (std::uint32_t i = m_stdHead[Bucket(level, x, y)]; i != g_nNone; i = m_stdNext[i])
          found.push_back(i);
  }
}

} // namespace Shapes::Native
