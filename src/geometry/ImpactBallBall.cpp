// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {
namespace {

// The ball as the other one sees it, which is a disc about the origin then. As in Sweep it is not smaller
// than what is touching.
CLinearMotion Relative(const CMotion& other, const CMotion& ball) {
  const double size = std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                      (other.m_fRadius + ball.m_fRadius);
  const CRoundings roundings(size, Norm(other.m_vVel) + Norm(ball.m_vVel));
  const double r = std::max(ball.m_fRadius, 0.5 * roundings.m_fTouch - other.m_fRadius);
  return {{ball.m_vPos - other.m_vPos, ball.m_vVel - other.m_vVel, r,
           std::min(other.m_fDuration, ball.m_fDuration)},
          roundings};
}

template <class TMotion>
bool KeepEarliest(const CMotion& other, const TMotion& motion, double end, CImpact& impact) {
  const CShapeGeometry disc;
  CImpactSearch<TMotion> search(disc, motion, end, impact);
  search.KeepEarliest(CDisk{Vector2d::Zero(), other.m_fRadius});
  impact.m_vSurface = other.m_vVel;
  return search.GetFound() == eSweep::Impact;
}

} // namespace

eSweep ImpactBallBall(const CMotion& other, const CMotion& ball, CImpact& impact) {
  const CLinearMotion motion = Relative(other, ball);
  if (!KeepEarliest(other, motion, motion.GetMotion().m_fDuration, impact)) return eSweep::None;
  impact.m_vPOI += other.m_vPos + other.m_vVel * impact.m_fTime;
  return eSweep::Impact;
}

bool OverlapBallBall(const CMotion& other, const CMotion& ball, CImpact& impact, double& depth) {
  const CLinearMotion motion = Relative(other, ball);
  FailIf(!KeepEarliest(other, CStandingMotion(motion), 0.0, impact));
  // Subtract the radius inflation.
  depth = -impact.m_fTime - (motion.GetMotion().m_fRadius - ball.m_fRadius);
  FailIf(!(depth > 0.0));
  impact.m_fTime = 0.0;
  impact.m_vPOI += other.m_vPos;
  return true;
}

} // namespace Shapes::Geometry
