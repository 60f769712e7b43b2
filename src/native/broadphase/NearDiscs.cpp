// SPDX-License-Identifier: MIT
#include "NearDiscs.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace Shapes::Native {

CNearDiscs::CDisc CNearDiscs::GetWide(const CDisc& disc) const {
  return {disc.m_vCenter, (1.0f + g_fNearSlack) * disc.m_fRadius + m_fSlack};
}

void CNearDiscs::Build(float slack) {
  m_fSlack = slack;
  m_stdWide.resize(m_stdDiscs.size());
  for (std::size_t k = 0; k < m_stdDiscs.size(); ++k)
    m_stdWide[k] = GetWide(m_stdDiscs[k]);
  m_cGrid.Build(m_stdWide);
  m_stdLists.assign(m_stdDiscs.size(), {});
  m_stdNear.clear();
  m_stdCame.clear();
  m_stdBits.assign(m_stdDiscs.size() / 64 + 1, 0);
}

// The names from `begin` on, each once: by comparing, or where they are many by a bit for each disc.
void CNearDiscs::Order(std::vector<std::uint32_t>& names, std::size_t begin) {
  const auto first = names.begin() + static_cast<std::ptrdiff_t>(begin);
  if (names.size() - begin < m_stdBits.size()) {
    std::sort(first, names.end());
    names.erase(std::unique(first, names.end()), names.end());
    return;
  }
  for (auto it = first; it != names.end(); ++it)
    m_stdBits[*it / 64] |= std::uint64_t{1} << (*it % 64);
  names.resize(begin);
  for (std::uint32_t k = 0; k < m_stdBits.size(); ++k)
    for (std::uint64_t bits = std::exchange(m_stdBits[k], 0); bits != 0; bits &= bits - 1)
      names.push_back(64 * k + static_cast<std::uint32_t>(std::countr_zero(bits)));
}

void CNearDiscs::MakeList(std::uint32_t disc) {
  const CDisc& d = m_stdWide[disc];
  const auto begin = static_cast<std::uint32_t>(m_stdNear.size());
  m_cGrid.FindNear(d.m_vCenter, d.m_fRadius, [&](std::uint32_t other) {
    if (other != disc) m_stdNear.push_back(other);
  });
  Order(m_stdNear, begin);
  m_stdLists[disc] = {begin, static_cast<std::uint32_t>(m_stdNear.size()), g_nNone};
}

// Unless it is there.
void CNearDiscs::Come(std::uint32_t disc, CList& list) {
  const std::span<const std::uint32_t> near = GetNear(list);
  if (std::binary_search(near.begin(), near.end(), disc)) return;
  for (std::uint32_t k = list.m_nCame; k != g_nNone; k = m_stdCame[k].m_nNext)
    if (m_stdCame[k].m_nDisc == disc) return;
  m_stdCame.push_back({disc, list.m_nCame});
  list.m_nCame = static_cast<std::uint32_t>(m_stdCame.size() - 1);
}

void CNearDiscs::Move(std::uint32_t disc, const CDisc& to) {
  if (to.IsWithin(m_stdWide[disc])) return;
  m_stdWide[disc] = GetWide(to);
  // Those of the ways that it does not take any more have to be forgotten now and then.
  if (m_cGrid.Size() > g_nMostDiscs * m_stdWide.size())
    m_cGrid.Build(m_stdWide);
  else
    m_cGrid.Move(disc, m_stdWide[disc]);
  MakeList(disc);
  for (const std::uint32_t other : GetNear(m_stdLists[disc]))
    if (CList& list = m_stdLists[other]; list.IsMade()) Come(disc, list);
}

std::span<const std::uint32_t> CNearDiscs::FindAtBegin(std::uint32_t disc) {
  if (!m_stdLists[disc].IsMade()) MakeList(disc);
  return GetNear(m_stdLists[disc]);
}

void CNearDiscs::Find(std::uint32_t disc, std::vector<std::uint32_t>& found) {
  const std::span<const std::uint32_t> near = FindAtBegin(disc);
  found.assign(near.begin(), near.end());
  std::uint32_t k = m_stdLists[disc].m_nCame;
  if (k == g_nNone) return;
  for (; k != g_nNone; k = m_stdCame[k].m_nNext)
    found.push_back(m_stdCame[k].m_nDisc);
  Order(found, 0);
}

} // namespace Shapes::Native
