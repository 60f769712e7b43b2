// SPDX-License-Identifier: MIT
#include "DiscGrid.h"

#include <bit>
#include <cstring>
#include <limits>

namespace Shapes::Native {
namespace {

// Of two, that of the first bit of what is positive; of all that are subnormal the same. (std::ilogb is a
// call.)
int GetExponent(float x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits); // std::bit_cast is too new for some libraries
  return static_cast<int>(bits >> 23) - 127;
}

} // namespace

void CDiscGrid::Build(std::span<const CDisc> discs) {
  m_stdEntries.resize(discs.size());
  m_bIsFew = discs.size() <= g_nFewDiscs;
  if (m_bIsFew) {
    for (std::size_t i = 0; i < discs.size(); ++i)
      m_stdEntries[i] = {discs[i], static_cast<std::uint32_t>(i), g_nNone};
    return;
  }
  m_stdLevels.fill(CLevel());
  m_stdAdded.assign(std::bit_ceil(2 * discs.size() + 1), g_nNone);
  m_nRowBits = static_cast<unsigned>(std::bit_width(m_stdAdded.size())) / 2;
  m_nLevels = 0;
  m_stdBegins.assign(m_stdAdded.size() + 1, 0);
  m_stdBucketOf.resize(discs.size());
  m_stdEntryOf.resize(discs.size());
  float largest = 0.0f;
  for (const CDisc& disc : discs)
    largest = std::max(largest, disc.m_fRadius);

  // Level 0 has the widest cells, at least as wide as the diameter.
  m_nTop = largest > 0.0f ? GetExponent(largest) + 2 : 0;
  for (std::size_t k = 0; k < m_stdLevels.size(); ++k)
    m_stdLevels[k].m_fCellsPerUnit = std::ldexp(1.0, g_nPowersPerLevel * static_cast<int>(k) - m_nTop);
  for (std::size_t i = 0; i < discs.size(); ++i)
    ++m_stdBegins[m_stdBucketOf[i] = Enter(discs[i])];
  std::uint32_t end = 0;
  for (std::uint32_t& begin : m_stdBegins)
    begin = end += begin;
  for (std::size_t i = discs.size(); i-- > 0;)
    m_stdEntries[m_stdEntryOf[i] = --m_stdBegins[m_stdBucketOf[i]]] = {
        discs[i], static_cast<std::uint32_t>(i), g_nNone};
}

void CDiscGrid::Move(std::uint32_t index, const CDisc& disc) {
  if (m_bIsFew) {
    m_stdEntries[index].m_cDisc = disc;
    return;
  }
  const std::uint32_t bucket = Enter(disc);
  CDisc& old = m_stdEntries[m_stdEntryOf[index]].m_cDisc;
  if (bucket == m_stdBucketOf[index]) {
    old = disc;
    return;
  }
  old = {Vector2::Constant(std::numeric_limits<float>::max()), 0.0f}; // nobody looks there
  m_stdBucketOf[index] = bucket;
  m_stdEntryOf[index] = static_cast<std::uint32_t>(m_stdEntries.size());
  m_stdEntries.push_back({disc, index, m_stdAdded[bucket]});
  m_stdAdded[bucket] = m_stdEntryOf[index];
}

// Those that are larger than all are in the widest cells, too, and those that are smaller than all in the
// last.
std::size_t CDiscGrid::GetLevel(float radius) const {
  const int last = static_cast<int>(m_stdLevels.size()) - 1;
  const int level = radius > 0.0f ? (m_nTop - GetExponent(radius) - 2) / g_nPowersPerLevel : last;
  return static_cast<std::size_t>(std::clamp(level, 0, last));
}

// Counts it where it belongs, and tells its bucket.
std::uint32_t CDiscGrid::Enter(const CDisc& disc) {
  const std::size_t k = GetLevel(disc.m_fRadius);
  CLevel& level = m_stdLevels[k];
  level.m_fLargest = std::max(level.m_fLargest, static_cast<double>(disc.m_fRadius));
  ++level.m_nDiscs;
  m_nLevels = std::max(m_nLevels, k + 1);
  return GetBucket(k, CellAt(static_cast<double>(disc.m_vCenter.x()), level),
                   CellAt(static_cast<double>(disc.m_vCenter.y()), level));
}

} // namespace Shapes::Native
