// SPDX-License-Identifier: MIT
// Answers to what a world is asked, on the geometry of src/geometry, so that they are the same for all
// engines.
#pragma once

#include <Shapes/Questions.h>

#include "../geometry/AabbTree.h"
#include "../geometry/Vector.h"
#include "WorldState.h"

#include <optional>
#include <vector>

namespace Shapes {

class CQuestions {
public:
  /// Takes in what is solid, as it is now. The state has to stay as it is until the last question.
  explicit CQuestions(const CWorldState& state);

  // As of CWorld.
  std::optional<CCastHit> Cast(const Vector2& from, const Vector2& to, float radius,
                               const CFilter& filter) const;
  std::vector<CCastHit> CastAll(const Vector2& from, const Vector2& to, float radius,
                                const CFilter& filter) const;
  std::optional<CClosestHit> FindClosest(const Vector2& p, float reach, const CFilter& filter) const;
  std::vector<CShapeId> FindInCircle(const Vector2& center, float radius, const CFilter& filter) const;
  std::vector<CShapeId> FindInBox(const CAabb2D& box, const CFilter& filter) const;

private:
  struct CItem {
    CShapeId m_cId;
    const CShapeEntry* m_pEntry; // null for a ball
    std::size_t m_nBall;
    CFilter m_cFilter;
  };
  struct CWay;
  std::optional<CCastHit> CastAt(const CItem& item, const CWay& way) const;
  bool FindAt(const CItem& item, const Vector2d& p, double reach, CClosestHit& hit) const;
  template <class F>
  void ForEachInBox(const CAabb2D& box, const CFilter& filter, const F& f) const;

  const CWorldState& m_cState;
  std::vector<CItem> m_stdItems;
  Geometry::CAabbTree m_cTree;
  double m_fSpacing = 0.0; // side of the square that each would have if they were spread evenly
};

} // namespace Shapes
