// SPDX-License-Identifier: MIT
#include "AabbTree.h"

#include <algorithm>
#include <numeric>

namespace Shapes::Geometry {

void CAabbTree::Build(std::span<const CAabb2D> boxes) {
  m_stdNodes.clear();
  m_stdParents.clear();
  m_stdLeaves.resize(boxes.size());
  if (boxes.empty()) return;
  std::vector<std::uint32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0u);
  m_stdNodes.reserve(2 * boxes.size() - 1);
  m_stdParents.reserve(2 * boxes.size() - 1);
  BuildNode(boxes, items, 0);
}

void CAabbTree::BuildNode(std::span<const CAabb2D> boxes, std::span<std::uint32_t> items,
                          std::uint32_t parent) {
  CAabb2D box = boxes[items[0]];
  for (const std::uint32_t i : items.subspan(1))
    box += boxes[i];
  const auto node = static_cast<std::uint32_t>(m_stdNodes.size());
  m_stdNodes.push_back({box, node + 1, items[0]});
  m_stdParents.push_back(parent);
  if (items.size() == 1) {
    m_stdLeaves[items[0]] = node;
    return;
  }

  const int axis = box.GetWidth() >= box.GetHt() ? 0 : 1;
  const auto centre = [&](std::uint32_t i) {
    return boxes[i].GetTopLeft()[axis] + boxes[i].GetBottomRt()[axis];
  };
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return centre(a) < centre(b); });
  BuildNode(boxes, items.first(half), node);
  BuildNode(boxes, items.subspan(half), node);
  m_stdNodes[node].m_nEnd = static_cast<std::uint32_t>(m_stdNodes.size());
}

void CAabbTree::Refit(std::span<const CAabb2D> boxes) {
  for (std::size_t i = m_stdNodes.size(); i-- > 0;) {
    CNode& node = m_stdNodes[i];
    node.m_cBox = IsLeaf(i) ? boxes[node.m_nItem] : m_stdNodes[i + 1].m_cBox;
    if (!IsLeaf(i)) node.m_cBox += m_stdNodes[m_stdNodes[i + 1].m_nEnd].m_cBox;
  }
}

void CAabbTree::Grow(std::uint32_t item, const CAabb2D& box) {
  for (std::uint32_t i = m_stdLeaves[item];; i = m_stdParents[i]) {
    m_stdNodes[i].m_cBox += box;
    if (i == 0) return;
  }
}

void CAabbTree::Query(const CAabb2D& box, std::vector<std::uint32_t>& found) const {
  Visit([&](const CAabb2D& around) { return around && box; },
        [&](std::uint32_t item) { found.push_back(item); });
}

} // namespace Shapes::Geometry
