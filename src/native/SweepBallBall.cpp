// SPDX-License-Identifier: MIT
#include "Search.h"

namespace Shapes::Native {
namespace {

// The ball as the other one sees it, which is a disc about the origin then. As in Sweep it is not smaller
// than what is touching.
CStraightLeg Relative(const CLeg& other, const CLeg& ball) {
  const double size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                      (other.m_fRadius + ball.m_fRadius);
  const CRoundings roundings(size, Norm(other.m_vVel) + Norm(ball.m_vVel));
  const double r = std::max(ball.m_fRadius, 0.5 * roundings.m_fTouch - other.m_fRadius);
  return {{ball.m_vPos - other.m_vPos, ball.m_vVel - other.m_vVel, r,
           std::min(other.m_fDuration, ball.m_fDuration)},
          roundings};
}

template <class TLeg>
bool Meet(const CLeg& other, const TLeg& leg, double end, CImpact& impact) {
  const COutline disc;
  CSearch<TLeg> search(disc, leg, end, impact);
  search.Meet(CRoundPart{Vector2d::Zero(), other.m_fRadius});
  impact.m_vSurface = other.m_vVel;
  return search.GetFound() == eSweep::Impact;
}

} // namespace

eSweep SweepBallBall(const CLeg& other, const CLeg& ball, CImpact& impact) {
  const CStraightLeg leg = Relative(other, ball);
  if (!Meet(other, leg, leg.GetLeg().m_fDuration, impact)) return eSweep::None;
  impact.m_vPOI += other.m_vPos + other.m_vVel * impact.m_fTime;
  return eSweep::Impact;
}

bool OverlapBallBall(const CLeg& other, const CLeg& ball, CImpact& impact, double& depth) {
  const CStraightLeg leg = Relative(other, ball);
  FailIf(!Meet(other, CStanding(leg), 0.0, impact));
  // What it is seen larger by is no overlap.
  depth = -impact.m_fTime - (leg.GetLeg().m_fRadius - ball.m_fRadius);
  FailIf(!(depth > 0.0));
  impact.m_fTime = 0.0;
  impact.m_vPOI += other.m_vPos;
  return true;
}

} // namespace Shapes::Native
