// SPDX-License-Identifier: MIT
// The search of a sweep through the parts of a shape. It is written once for each shape, in the file of the
// pair, for all ways to look at a leg: CStraightLeg, CTurningLeg, and CStanding of these.
#pragma once

#include "StraightLeg.h"
#include "TurningLeg.h"

namespace Shapes::Native {

/// Only the beginning of a leg: When finds overlaps, and the gap stands for the time, so that the deepest is
/// the first.
template <class TLeg>
class CStanding {
public:
  explicit CStanding(const TLeg& leg) : m_cLeg(leg) {}

  const CLeg& GetLeg() const { return m_cLeg.GetLeg(); }
  double GetTouch() const { return m_cLeg.GetTouch(); }
  CSeenBall At(double) const { return m_cLeg.At(0.0); }

  template <class TPart, class F>
  eSweep When(const TPart& part, double deepest, const F& counts, double& t) const {
    const CSeenBall ball = m_cLeg.At(0.0);
    const double gap = part.At(ball).m_fGap;
    if (!(gap < t && gap >= -deepest && counts(ball.m_vPos))) return eSweep::None;
    t = gap;
    return eSweep::Impact;
  }
  template <class TPart>
  double GetCurve(const TPart& part, const CSpot& spot) const {
    return m_cLeg.GetCurve(part, spot);
  }

private:
  TLeg m_cLeg;
};

template <class TLeg>
class CSearch {
public:
  /// Up to the time `end`. The shape and the impact are in the frame of the leg.
  CSearch(const COutline& shape, const TLeg& leg, double end, CImpact& impact)
      : m_cShape(shape), m_cLeg(leg), m_cImpact(impact) {
    impact.m_fTime = end;
  }

  const COutline& GetShape() const { return m_cShape; }
  const TLeg& GetLeg() const { return m_cLeg; }
  double GetBallRadius() const { return m_cLeg.GetLeg().m_fRadius; }
  eSweep GetFound() const { return m_eFound; }

  /// Keeps the first. `counts` says where the centre has to be; a ball that overlaps by more than `deepest`
  /// is let go until it is clear.
  template <class TPart, class F>
  void Meet(const TPart& part, double deepest, const F& counts) {
    double t = m_cImpact.m_fTime;
    const eSweep found = m_cLeg.When(part, deepest, counts, t);
    if (found == eSweep::None || (m_eFound != eSweep::None && !(t < m_cImpact.m_fTime))) return;
    m_eFound = found;
    const CSpot spot = part.At(m_cLeg.At(t));
    m_cImpact = {t, spot.m_vPOI, spot.m_vNorm, Vector2d::Zero(), m_cLeg.GetCurve(part, spot)};
  }
  /// Wherever the centre is, and however deep.
  template <class TPart>
  void Meet(const TPart& part) {
    Meet(part, std::numeric_limits<double>::infinity(), [](const Vector2d&) { return true; });
  }

private:
  const COutline& m_cShape;
  TLeg m_cLeg;
  CImpact& m_cImpact;
  eSweep m_eFound = eSweep::None;
};

template <class TLeg>
void SweepPointCircle(CSearch<TLeg>& search);
template <class TLeg>
void SweepLineSegCircle(CSearch<TLeg>& search);
template <class TLeg>
void SweepCircleCircle(CSearch<TLeg>& search);
template <class TLeg>
void SweepCircleArc(CSearch<TLeg>& search);

/// At the end of each of these files.
#define SHAPES_SWEEP_FOR_ALL_LEGS(SweepPair)                                                                 \
  template void SweepPair(CSearch<CStraightLeg>&);                                                           \
  template void SweepPair(CSearch<CTurningLeg>&);                                                            \
  template void SweepPair(CSearch<CStanding<CStraightLeg>>&);                                                \
  template void SweepPair(CSearch<CStanding<CTurningLeg>>&);

} // namespace Shapes::Native
