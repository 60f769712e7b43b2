// SPDX-License-Identifier: MIT
#include "Questions.h"

#include "../Tolerances.h"
#include "../geometry/BoxOverlap.h"
#include "../geometry/TimeOfImpact.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Shapes {

using Geometry::CImpact;
using Geometry::CMotion;
using Geometry::CShapeGeometry;
using Geometry::eSweep;
using Geometry::Padded;

namespace {

CAabb2D BoxOfBall(const Vector2& p, float r) {
  return Padded(CAabb2D(p - Vector2::Constant(r), p + Vector2::Constant(r)));
}

// A round shape errs by its centre and its radius, and both may be far from its box.
CAabb2D BoxOf(const CShape& shape, const CShapeGeometry& geometry) {
  return Padded(shape.GetAABB(), g_fBoxPadding * static_cast<float>(geometry.m_fSize));
}

// At rest.
CShapeGeometry GeometryOf(const CShapeEntry& entry) {
  CShapeGeometry geometry = Geometry::MakeShapeGeometry(*entry.m_pShape, 0.0);
  geometry.m_vVel.setZero();
  return geometry;
}

CMotion At(const Vector2d& p, double r) { return {p, Vector2d::Zero(), r, 1.0}; }

CBox2d Widened(const CAabb2D& box, double by) {
  const Vector2d margin = Vector2d::Constant(by);
  const Vector2 low(box.GetTopLeft().x(), box.GetBottomRt().y()),
      high(box.GetBottomRt().x(), box.GetTopLeft().y());
  return {low.cast<double>() - margin, high.cast<double>() + margin};
}

bool IsBefore(const CCastHit& a, const CCastHit& b) {
  return std::tie(a.m_fShare, a.m_cShape) < std::tie(b.m_fShare, b.m_cShape);
}

} // namespace

// A circle that moves along itself in one second.
struct CQuestions::CWay {
  CMotion m_cMotion;

  CWay(const Vector2& from, const Vector2& to, float radius)
      : m_cMotion{from.cast<double>(), to.cast<double>() - from.cast<double>(), static_cast<double>(radius),
                  1.0} {}
  bool Meets(const CAabb2D& box, double most) const {
    return std::isfinite(
        Geometry::FindEntry(Widened(box, m_cMotion.m_fRadius), m_cMotion.m_vPos, m_cMotion.m_vVel, most));
  }
};

CQuestions::CQuestions(const CWorldState& state) : m_cState(state) {
  std::vector<CAabb2D> boxes;
  for (const CShapeEntry& entry : state.m_stdShapes) {
    const CShape& shape = *entry.m_pShape;
    if (!IsSolid(shape)) continue;
    m_stdItems.push_back({entry.m_cId, &entry, 0, shape.GetFilter()});
    boxes.push_back(BoxOf(shape, GeometryOf(entry)));
  }
  const CBallArrays& b = state.m_cBalls;
  for (std::size_t i = 0; i < b.Size(); ++i) {
    if (!b.IsSolid(i)) continue;
    m_stdItems.push_back({b.m_stdId[i], nullptr, i, b.m_stdFilter[i]});
    boxes.push_back(BoxOfBall(b.m_stdPos[i], b.m_stdRadius[i]));
  }
  m_cTree.Build(boxes);
  CBox2d all;
  for (const CAabb2D& box : boxes)
    all.extend(Widened(box, 0.0));
  if (!boxes.empty()) m_fSpacing = std::sqrt(all.volume() / static_cast<double>(boxes.size()));
}

std::optional<CCastHit> CQuestions::CastAt(const CItem& item, const CWay& way) const {
  const CBallArrays& b = m_cState.m_cBalls;
  CImpact impact;
  const bool isMet =
      item.m_pEntry != nullptr
          ? Geometry::Sweep(GeometryOf(*item.m_pEntry), way.m_cMotion, 0.0, impact) == eSweep::Impact
          : Geometry::ImpactBallBall(At(b.m_stdPos[item.m_nBall].cast<double>(), b.m_stdRadius[item.m_nBall]),
                                     way.m_cMotion, impact) == eSweep::Impact;
  if (!isMet) return {};
  return CCastHit{item.m_cId, static_cast<float>(impact.m_fTime), impact.m_vPOI.cast<float>(),
                  impact.m_vNorm.cast<float>()};
}

std::optional<CCastHit> CQuestions::Cast(const Vector2& from, const Vector2& to, float radius,
                                         const CFilter& filter) const {
  const CWay way(from, to, radius);
  std::optional<CCastHit> first;
  m_cTree.Visit(
      [&](const CAabb2D& box) { return way.Meets(box, first ? static_cast<double>(first->m_fShare) : 1.0); },
      [&](std::uint32_t k) {
        if (!DoMeet(m_stdItems[k].m_cFilter, filter)) return;
        const auto hit = CastAt(m_stdItems[k], way);
        if (hit && (!first || IsBefore(*hit, *first))) first = hit;
      });
  return first;
}

std::vector<CCastHit> CQuestions::CastAll(const Vector2& from, const Vector2& to, float radius,
                                          const CFilter& filter) const {
  const CWay way(from, to, radius);
  std::vector<CCastHit> hits;
  m_cTree.Visit([&](const CAabb2D& box) { return way.Meets(box, 1.0); },
                [&](std::uint32_t k) {
                  if (!DoMeet(m_stdItems[k].m_cFilter, filter)) return;
                  if (const auto hit = CastAt(m_stdItems[k], way)) hits.push_back(*hit);
                });
  std::sort(hits.begin(), hits.end(), IsBefore);
  return hits;
}

// The spot of an item closest to p, if it is closer than `reach`. Of a circle about p less than its radius
// away is what overlaps it: as a disc that touches, it would not fit into a small arc, and so not touch that.
bool CQuestions::FindAt(const CItem& item, const Vector2d& p, double reach, CClosestHit& hit) const {
  const CBallArrays& b = m_cState.m_cBalls;
  CImpact impact;
  double gap;
  if (item.m_pEntry != nullptr) {
    CShapeGeometry geometry = GeometryOf(*item.m_pEntry);
    geometry.m_eSides = eSides::Both;
    FailIf(!Geometry::Near(geometry, At(p, 0.0), 0.0, reach, impact, gap));
  } else {
    FailIf(!Geometry::NearBallBall(At(b.m_stdPos[item.m_nBall].cast<double>(), b.m_stdRadius[item.m_nBall]),
                                   At(p, 0.0), reach, impact, gap));
  }
  hit = {item.m_cId, static_cast<float>(gap), impact.m_vPOI.cast<float>(), impact.m_vNorm.cast<float>()};
  return true;
}

std::optional<CClosestHit> CQuestions::FindClosest(const Vector2& p, float reach,
                                                   const CFilter& filter) const {
  const Vector2d place = p.cast<double>();
  std::optional<CClosestHit> closest;
  // Nearby first: what is found there spares a look at most of the others.
  double least = std::min(static_cast<double>(reach), m_fSpacing);
  const auto search = [&] {
    m_cTree.Visit(
        [&](const CAabb2D& box) { return Widened(box, 0.0).exteriorDistance(place) <= std::max(least, 0.0); },
        [&](std::uint32_t k) {
          CClosestHit hit;
          if (!DoMeet(m_stdItems[k].m_cFilter, filter) ||
              !FindAt(m_stdItems[k], place, std::nextafter(least, reach), hit))
            return;
          const bool isCloser = !closest || std::tie(hit.m_fDistance, hit.m_cShape) <
                                                std::tie(closest->m_fDistance, closest->m_cShape);
          if (!isCloser) return;
          closest = hit;
          least = static_cast<double>(hit.m_fDistance);
        });
  };
  search();
  if (closest || least == static_cast<double>(reach)) return closest;
  least = reach;
  search();
  return closest;
}

template <class F>
void CQuestions::ForEachInBox(const CAabb2D& box, const CFilter& filter, const F& f) const {
  const CAabb2D padded = Padded(box);
  m_cTree.Visit([&](const CAabb2D& other) { return other && padded; },
                [&](std::uint32_t k) {
                  if (DoMeet(m_stdItems[k].m_cFilter, filter)) f(m_stdItems[k]);
                });
}

std::vector<CShapeId> CQuestions::FindInCircle(const Vector2& center, float radius,
                                               const CFilter& filter) const {
  std::vector<CShapeId> found;
  ForEachInBox(BoxOfBall(center, radius), filter, [&](const CItem& item) {
    CClosestHit hit;
    if (FindAt(item, center.cast<double>(), static_cast<double>(radius), hit)) found.push_back(item.m_cId);
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<CShapeId> CQuestions::FindInBox(const CAabb2D& box, const CFilter& filter) const {
  const CBallArrays& b = m_cState.m_cBalls;
  const CBox2d exact = Widened(box, 0.0);
  std::vector<CShapeId> found;
  ForEachInBox(box, filter, [&](const CItem& item) {
    const bool isIn = item.m_pEntry != nullptr
                          ? Geometry::HasPointIn(GeometryOf(*item.m_pEntry), exact)
                          : exact.exteriorDistance(b.m_stdPos[item.m_nBall].cast<double>()) <=
                                static_cast<double>(b.m_stdRadius[item.m_nBall]);
    if (isIn) found.push_back(item.m_cId);
  });
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace Shapes
