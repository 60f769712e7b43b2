// SPDX-License-Identifier: MIT
// The search of a sweep through the features of a shape. It is written once for each shape, in the file of
// the pair, for all ways to look at a motion: CLinearMotion, CParabolicMotion, CCurvedMotion, and
// CStandingMotion of the first and the last.
#pragma once

#include "CurvedMotion.h"
#include "LinearMotion.h"
#include "ParabolicMotion.h"

namespace Shapes::Geometry {

/// Only the beginning of a motion: TimeOfImpact finds overlaps, and the gap stands for the time, so that the
/// deepest is the first.
template <class TMotion>
class CStandingMotion : public TMotion {
public:
  explicit CStandingMotion(const TMotion& motion) : TMotion(motion) {}

  CBallAt At(double) const { return TMotion::At(0.0); }

  template <class TFeature, class F>
  eSweep TimeOfImpact(const TFeature& feature, double deepest, const F& counts, double& t) const {
    const CBallAt ball = TMotion::At(0.0);
    const double gap = feature.GetGap(ball);
    if (!(gap < t && gap >= -deepest && counts(ball.m_vPos))) return eSweep::None;
    t = gap;
    return eSweep::Impact;
  }
  double GetClosing(const CSpot& spot, double) const { return TMotion::GetClosing(spot, 0.0); }
};

template <class TMotion>
inline constexpr bool g_bStands = false;
template <class TMotion>
inline constexpr bool g_bStands<CStandingMotion<TMotion>> = true;

template <class TMotion>
class CImpactSearch {
public:
  /// Up to the time `end`. The shape and the impact are in the frame of the motion. All three have to stay.
  CImpactSearch(const CShapeGeometry& shape, const TMotion& motion, double end, CImpact& impact)
      : m_cShape(shape), m_cMotion(motion), m_cImpact(impact), m_fEnd(end) {
    impact.m_fTime = end;
  }

  const CShapeGeometry& GetShape() const { return m_cShape; }
  const TMotion& GetMotion() const { return m_cMotion; }
  double GetBallRadius() const { return m_cMotion.GetMotion().m_fRadius; }
  eSweep GetFound() const { return m_eFound; }
  /// How deep a ball may be in an end, where one side is solid, to meet it. One that stands there, and is to
  /// be found from some distance, may have been put there in floats.
  double GetEndDepth() const {
    const double touch = m_cMotion.GetTouch();
    const double rounding = touch * (static_cast<double>(g_fTouchRounding) / CRoundings::g_fShare);
    return g_bStands<TMotion> ? std::clamp(m_fEnd, touch, rounding) : touch;
  }
  /// Whether the centre is in front of a face that was found: of a standing motion, ends are not closer then.
  bool HasFace() const { return g_bStands<TMotion> && m_eFound != eSweep::None; }

  /// Keeps the first. `counts` says where the centre has to be; a ball that overlaps by more than `deepest`
  /// is ignored until it is clear.
  template <class TFeature, class F>
  void KeepEarliest(const TFeature& feature, double deepest, const F& counts) {
    double t = m_cImpact.m_fTime;
    const eSweep found = m_cMotion.TimeOfImpact(feature, deepest, counts, t);
    if (found == eSweep::None || (m_eFound != eSweep::None && !(t < m_cImpact.m_fTime))) return;
    m_eFound = found;
    const CSpot spot = GetSpot(feature, m_cMotion.At(t));
    m_cImpact = {t,
                 spot.m_vPOI,
                 spot.m_vNorm,
                 Vector2d::Zero(),
                 m_cMotion.GetCurve(feature, spot),
                 m_cMotion.GetClosing(spot, t),
                 spot.m_fRadius};
  }
  /// Wherever the centre is, and however deep.
  template <class TFeature>
  void KeepEarliest(const TFeature& feature) {
    KeepEarliest(feature, std::numeric_limits<double>::infinity(), [](const Vector2d&) { return true; });
  }

private:
  template <class TFeature>
  CSpot GetSpot(const TFeature& feature, const CBallAt& ball) const {
    return feature.At(ball);
  }
  // One that leaves the face in front of which it is has met an end that it touches as well.
  CSpot GetSpot(const CSegment& feature, const CBallAt& ball) const {
    CSpot spot = feature.At(ball);
    if (g_bStands<TMotion> || spot.Rate(ball) < 0.0) return spot;
    for (const Vector2d& end : {feature.m_vPt0, feature.m_vPt1}) {
      CSpot atEnd = CDisk{end, 0.0}.At(ball);
      if (atEnd.m_fGap <= m_cMotion.GetTouch() && atEnd.Rate(ball) < 0.0) return atEnd;
    }
    return spot;
  }

  const CShapeGeometry& m_cShape;
  const TMotion& m_cMotion;
  CImpact& m_cImpact;
  eSweep m_eFound = eSweep::None;
  double m_fEnd; // of the search: a time, or the gap of a standing motion
};

template <class TMotion>
void ImpactPointCircle(CImpactSearch<TMotion>& search);
template <class TMotion>
void ImpactLineSegCircle(CImpactSearch<TMotion>& search);
template <class TMotion>
void ImpactCircleCircle(CImpactSearch<TMotion>& search);
template <class TMotion>
void ImpactCircleArc(CImpactSearch<TMotion>& search);

/// At the end of each of these files.
#define SHAPES_IMPACTS_FOR_ALL_MOTIONS(ImpactPair)                                                           \
  template void ImpactPair(CImpactSearch<CLinearMotion>&);                                                   \
  template void ImpactPair(CImpactSearch<CParabolicMotion>&);                                                \
  template void ImpactPair(CImpactSearch<CCurvedMotion>&);                                                   \
  template void ImpactPair(CImpactSearch<CStandingMotion<CLinearMotion>>&);                                  \
  template void ImpactPair(CImpactSearch<CStandingMotion<CCurvedMotion>>&);

} // namespace Shapes::Geometry
