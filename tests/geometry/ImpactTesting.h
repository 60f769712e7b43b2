// SPDX-License-Identifier: MIT
// Parts that the tests of the sweeps share: trials, of which some seek the hard region, and what to hold them
// against: the exact reference, and a search.
#pragma once

#include "geometry/TimeOfImpact.h"

#include "../Testing.h"

#include "compare/SweepOracle.h"
#include "reference/Scalar.h"
#include "reference/Sweep.h"

namespace Shapes::Geometry {

using Compare::CFifty;

inline constexpr eShape g_eTypes[] = {eShape::Point, eShape::LineSeg, eShape::Circle, eShape::Arc};

/// A motion, and the shape that it may meet.
struct CTrial {
  CShapeGeometry m_cShape;
  CMotion m_cMotion;
};

/// One of this kind, static unless it `turns`, at a random place. Coordinates up to 2.
CShapeGeometry RandomOutline(CRandom& random, eShape type, eSides sides, bool turns);
/// Against such a shape: ways of 0.01 to 10,000 radii, at random, or grazing, or from almost touching, or
/// from exactly on the shape, or right at an end.
CTrial RandomTrial(CRandom& random, eShape type, eSides sides, bool turns = false);
/// Of a ball that is clear of the shape at the beginning, on a path that goes near it: straight, or a
/// parabola if it `falls`.
CTrial ClearTrial(CRandom& random, eShape type, eSides sides, bool turns, bool falls = false);

/// So many trials of a kind: the rows of a test.
struct CTrials {
  eShape m_eShapeType;
  bool m_bOneSided; ///< On one side or the other.
  bool m_bTurns;
  int m_nTrials;
  bool m_bFalls = false; ///< Under an acceleration of any direction.

  std::uint64_t GetSeed() const {
    constexpr std::uint64_t seeds[] = {20248, 20264, 20272, 20280};
    return seeds[static_cast<std::size_t>(m_eShapeType)] + m_bOneSided * 2 + m_bTurns + m_bFalls * 1000;
  }
  eSides GetSides(CRandom& random) const {
    return !m_bOneSided ? eSides::Both : random.Coin() ? eSides::Front : eSides::Back;
  }
};
std::string Name(const CTrials& trials);
inline void PrintTo(const CTrials& trials, std::ostream* pOut) { *pOut << Name(trials); }

/// The error bound of Sweep.h as a gap: of the time it is this divided by the approach speed.
double GapBound(const CTrial& trial);

/// Whether the ball is within a ring or the sector of an arc, and overlaps its inside. The reference lets
/// such a ball go for good if its way does not lead inward by as much as it overlaps.
bool OverlapsInside(const CTrial& trial);

inline Compare::CShapeGeometry<double> ForReference(const CShapeGeometry& o) {
  return {o.m_eShapeType, o.m_eSides, o.m_bFull, o.m_bWide, o.m_vCenter, o.m_vPt0, o.m_vPt1, o.m_fRadius};
}
template <class T>
Compare::CVec<T> To(const Vector2d& v) {
  return {T(v.x()), T(v.y())};
}
/// The ball of the reference, larger by `more`.
template <class T>
Compare::CSweptBall<T> BallOf(const CMotion& motion, double more = 0.0) {
  return {To<T>(motion.m_vPos), To<T>(motion.m_vVel), T(motion.m_fRadius) + T(more), To<T>(motion.m_vAcc)};
}
/// Distances by closest points and angles alone, in long double.
inline Compare::Tests::CSweepOracle MakeOracle(const CShapeGeometry& o, const CMotion& motion) {
  return {ForReference(o), {o.m_vRotCenter, o.m_fTurnSpeed}, BallOf<double>(motion), motion.m_fDuration};
}
/// The reference, the radius of the ball being larger by `more`.
template <class T>
bool SweepExactly(const CTrial& trial, Compare::CHit<T>& hit, double more = 0.0) {
  const CShapeGeometry& o = trial.m_cShape;
  return Compare::Sweep<T>(ForReference(o).template Cast<T>(), {To<T>(o.m_vRotCenter), T(o.m_fTurnSpeed)},
                           BallOf<T>(trial.m_cMotion, more), T(trial.m_cMotion.m_fDuration), hit);
}

} // namespace Shapes::Geometry
