// SPDX-License-Identifier: MIT
#pragma once

#include "../shapes/WorldState.h"

#include <cstdint>
#include <vector>

#include "BoxTree.h"
#include "Outline.h"

namespace Shapes::Native {

/// The solid shapes of a world, ranked in the order of the plain loop (points by id, then the others by id),
/// with boxes around them: those that turn apart from those that rest, so that only they are boxed anew.
class CSolids {
public:
  /// Takes in the shapes that are no sensors. They have to stay where they are in memory.
  void Sort(const std::vector<CShapeEntry>& shapes);

  std::size_t Size() const { return m_stdByRank.size(); }
  const CShapeEntry& Get(std::uint32_t rank) const { return *m_stdByRank[rank]; }
  bool AreTurning() const { return !m_cTurning.m_stdRank.empty(); }

  /// Puts boxes around the turning shapes as they are now, or around all that they sweep in the next dt
  /// seconds.
  void BoxTurning();
  void BoxTurning(float dt);
  /// Appends the ranks of all shapes whose box meets this one, in no order.
  void Query(const CAabb2D& box, std::vector<std::uint32_t>& ranks);

  /// Makes the outlines of what turns in the next dt seconds, and of the others if that was not yet done.
  void MakeOutlines(float dt);
  const COutline& GetOutline(std::uint32_t rank) const { return m_stdOutlines[rank]; }

private:
  /// Items of the tree index m_stdRank.
  struct CGroup {
    std::vector<std::uint32_t> m_stdRank;
    std::vector<CAabb2D> m_stdBoxes;
    CBoxTree m_cTree;
  };
  const CShape& GetShape(std::uint32_t rank) const { return *m_stdByRank[rank]->m_pShape; }

  std::vector<const CShapeEntry*> m_stdByRank;
  CGroup m_cResting, m_cTurning;
  std::vector<COutline> m_stdOutlines; // by rank; empty if they were not asked for yet
  std::vector<std::uint32_t> m_stdFound;
};

} // namespace Shapes::Native
