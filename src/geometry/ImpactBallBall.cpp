// SPDX-License-Identifier: MIT
#include "ImpactSearch.h"

namespace Shapes::Geometry {
namespace {

// The ball as the other one sees it, which is a disc about the origin then. As in Sweep it is not smaller
// than what is touching.
struct CRelativeMotion {
  CRoundings m_cRoundings;
  CMotion m_cMotion;

  CRelativeMotion(const CMotion& other, const CMotion& ball)
      : m_cRoundings(std::max(other.m_vPos.cwiseAbs().maxCoeff(), ball.m_vPos.cwiseAbs().maxCoeff()) +
                         (other.m_fRadius + ball.m_fRadius),
                     Norm(other.m_vVel) + Norm(ball.m_vVel)),
        m_cMotion{ball.m_vPos - other.m_vPos, ball.m_vVel - other.m_vVel,
                  std::max(ball.m_fRadius, 0.5 * m_cRoundings.m_fTouch - other.m_fRadius),
                  std::min(other.m_fDuration, ball.m_fDuration), ball.m_vAcc - other.m_vAcc} {}
};

// The other one is in the middle of the frame, and does not turn in it.
const CShapeGeometry g_cDisc;

template <class TMotion>
eSweep KeepEarliest(const CMotion& other, const TMotion& motion, double end, CImpact& impact) {
  CImpactSearch<TMotion> search(g_cDisc, motion, end, impact);
  search.KeepEarliest(CDisk{Vector2d::Zero(), other.m_fRadius});
  impact.m_vSurface = other.VelAt(impact.m_fTime);
  return search.GetFound();
}

} // namespace

eSweep ImpactBallBall(const CMotion& other, const CMotion& ball, CImpact& impact) {
  const CRelativeMotion relative(other, ball);
  const double end = relative.m_cMotion.m_fDuration;
  const eSweep found =
      relative.m_cMotion.m_vAcc.isZero(0.0)
          ? KeepEarliest(other, CLinearMotion(relative.m_cMotion, relative.m_cRoundings), end, impact)
          : KeepEarliest(other, CParabolicMotion(g_cDisc, relative.m_cMotion, relative.m_cRoundings), end,
                         impact);
  if (found == eSweep::Impact) impact.m_vPOI += other.PosAt(impact.m_fTime);
  return found;
}

bool NearBallBall(const CMotion& other, const CMotion& ball, double reach, CImpact& impact, double& gap) {
  const double far = (1.0 + g_fBoxPadding) * (other.m_fRadius + ball.m_fRadius + reach);
  FailIf((ball.m_vPos - other.m_vPos).squaredNorm() > far * far); // most of those that are asked for
  const CRelativeMotion relative(other, ball);
  const CLinearMotion motion(relative.m_cMotion, relative.m_cRoundings);
  FailIf(KeepEarliest(other, CStandingMotion(motion), reach, impact) != eSweep::Impact);
  // Subtract the radius inflation.
  gap = impact.m_fTime + (relative.m_cMotion.m_fRadius - ball.m_fRadius);
  FailIf(!(gap < reach));
  impact.m_fTime = 0.0;
  impact.m_vSurface = other.m_vVel;
  impact.m_vPOI += other.m_vPos;
  return true;
}

bool OverlapBallBall(const CMotion& other, const CMotion& ball, CImpact& impact, double& depth) {
  FailIf(!NearBallBall(other, ball, 0.0, impact, depth));
  depth = -depth;
  return true;
}

} // namespace Shapes::Geometry
