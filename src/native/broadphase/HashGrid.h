// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/ShapeMath.h>

#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Native {

/// A hashed grid of balls, one level of cells for each power of two of the diameter, so that a few large
/// balls among many small ones do not spoil it. A ball lives in the cell of its centre; cells are at least
/// its diameter wide.
class CHashGrid {
public:
  /// Takes in these balls; the index is the ball's name from then on.
  void Build(std::span<const Vector2> pos, std::span<const float> radius);
  /// Ball i is at p now.
  void Move(std::uint32_t i, const Vector2& p);
  /// Appends to found every ball that can overlap a circle at p of radius r, and maybe others or one twice,
  /// in no order.
  void Query(const Vector2& p, float r, std::vector<std::uint32_t>& found) const;

private:
  struct CLevel {
    double m_fCell;    // width of its cells
    double m_fLargest; // largest radius in it
    std::uint32_t m_nBalls;
  };
  std::uint32_t Bucket(std::uint32_t level, double x, double y) const;
  void Link(std::uint32_t i, const Vector2& p);

  std::vector<CLevel> m_stdLevels;
  std::vector<std::uint32_t> m_stdLevelOf;  // of each ball
  std::vector<std::uint32_t> m_stdBucketOf; // of each ball
  std::vector<std::uint32_t> m_stdNext;     // ball -> next ball in its bucket
  std::vector<std::uint32_t> m_stdPrev;
  std::vector<std::uint32_t> m_stdHead; // bucket -> first ball
};

} // namespace Shapes::Native
