// SPDX-License-Identifier: MIT
#pragma once

#include <Shapes/Aabb2D.h>

#include "../Tolerances.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace Shapes::Geometry {

/// A box that is surely larger than the rounding of any kernel against a shape with this box.
inline CAabb2D Padded(const CAabb2D& box, float margin = 0.0f) {
  const Vector2 &tl = box.GetTopLeft(), &br = box.GetBottomRt();
  const float size = std::max(tl.cwiseAbs().maxCoeff(), br.cwiseAbs().maxCoeff());
  const float pad = margin + g_fBoxPadding * (size + margin);
  return {tl + Vector2(-pad, pad), br + Vector2(pad, -pad)};
}

/// A tree of boxes over items 0 .. n-1: finds the items whose box meets a box in O(log n + found).
class CAabbTree {
public:
  /// Builds the tree over these boxes by halving the longer axis.
  void Build(std::span<const CAabb2D> boxes);
  /// Items in it.
  std::size_t Size() const { return m_stdLeaves.size(); }
  /// Takes new boxes for the same items and keeps the tree: O(n), for shapes that turn a little.
  void Refit(std::span<const CAabb2D> boxes);
  /// Lets the box of an item reach as far as this one, too: O(log n).
  void Grow(std::uint32_t item, const CAabb2D& box);
  /// Appends to found every item whose box meets this one, in no order.
  void Query(const CAabb2D& box, std::vector<std::uint32_t>& found) const;
  /// Calls take(item) for every item of which the box, and all boxes around it, are as `meets` wants them.
  template <class TMeets, class TTake>
  void Visit(const TMeets& meets, const TTake& take) const {
    for (std::uint32_t i = 0; i < m_stdNodes.size();) {
      const CNode& node = m_stdNodes[i];
      if (!meets(node.m_cBox)) {
        i = node.m_nEnd;
        continue;
      }
      if (IsLeaf(i)) take(node.m_nItem);
      ++i;
    }
  }

private:
  // Depth first: the left child of a node is the next one, the right one comes where the left one ends.
  struct CNode {
    CAabb2D m_cBox;
    std::uint32_t m_nEnd;  // index behind all that is below the node
    std::uint32_t m_nItem; // leaf only
  };
  bool IsLeaf(std::size_t node) const { return m_stdNodes[node].m_nEnd == node + 1; }
  void BuildNode(std::span<const CAabb2D> boxes, std::span<std::uint32_t> items, std::uint32_t parent);

  std::vector<CNode> m_stdNodes;
  std::vector<std::uint32_t> m_stdParents; // of each node; of the root itself
  std::vector<std::uint32_t> m_stdLeaves;  // of each item
};

} // namespace Shapes::Geometry
