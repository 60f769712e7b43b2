// SPDX-License-Identifier: MIT
#pragma once

#include "DiscGrid.h"

namespace Shapes::Native {

/// Which discs are near each other while some of them move: a list for each, which is made once, when it is
/// asked for, and is made anew or grows where a disc has moved. A pile asks several times for each move: to
/// search the grid each time would cost 5 to 10% more instructions of a step.
class CNearDiscs {
public:
  using CDisc = CDiscGrid::CDisc;

  /// The discs by their names 0, 1, ..: to be set before Build.
  std::vector<CDisc>& GetDiscs() { return m_stdDiscs; }
  /// As it was when they were set.
  const CDisc& Get(std::uint32_t disc) const { return m_stdDiscs[disc]; }
  /// Forgets all lists. A disc that moves within one that is larger by g_fNearSlack and `slack` has not
  /// moved.
  /// @param slack  user units, not below 0
  void Build(float slack);
  /// @param to  where it is, and its radius, from now on
  void Move(std::uint32_t disc, const CDisc& to);
  /// Takes into `found`, which is empty, all others that overlap it now, in the order of their names, and
  /// some that are near or were.
  void Find(std::uint32_t disc, std::vector<std::uint32_t>& found);
  /// The same until any is moved.
  std::span<const std::uint32_t> FindAtBegin(std::uint32_t disc);

private:
  // In m_stdNear from begin to end, by name; and those that have come since.
  struct CList {
    std::uint32_t m_nBegin = g_nNone, m_nEnd = g_nNone, m_nCame = g_nNone;
    bool IsMade() const { return m_nBegin != g_nNone; }
  };
  struct CCame {
    std::uint32_t m_nDisc, m_nNext;
  };
  std::span<const std::uint32_t> GetNear(const CList& list) const {
    return std::span(m_stdNear).subspan(list.m_nBegin, list.m_nEnd - list.m_nBegin);
  }
  CDisc GetWide(const CDisc& disc) const;
  void MakeList(std::uint32_t disc);
  void Order(std::vector<std::uint32_t>& names, std::size_t begin);
  void Come(std::uint32_t disc, CList& list);

  static constexpr std::uint32_t g_nNone = 0xFFFFFFFFu;
  float m_fSlack = 0.0f;
  std::vector<CDisc> m_stdDiscs; // as they were at Build
  std::vector<CDisc> m_stdWide;  // in which each has stayed since it was looked for
  CDiscGrid m_cGrid;
  std::vector<CList> m_stdLists;
  std::vector<std::uint32_t> m_stdNear;
  std::vector<CCame> m_stdCame;
  std::vector<std::uint64_t> m_stdBits; // one of each disc, all 0
};

} // namespace Shapes::Native
