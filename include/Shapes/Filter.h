// SPDX-License-Identifier: MIT
// Which shapes and balls meet each other, as in Box2D.
#pragma once

#include <cstdint>

namespace Shapes {

/// One bit for each group of shapes and balls. Two meet, as solid ones and as sensors, if the mask of each
/// has a bit of the category of the other. By default all are of one group that meets all.
struct CFilter {
  std::uint16_t m_nCategory = 0x0001; ///< The groups that it is of.
  std::uint16_t m_nMask = 0xFFFF;     ///< The groups that it meets.
  friend bool operator==(const CFilter&, const CFilter&) = default;
};

inline bool DoMeet(const CFilter& a, const CFilter& b) {
  return (a.m_nMask & b.m_nCategory) != 0 && (b.m_nMask & a.m_nCategory) != 0;
}

} // namespace Shapes
