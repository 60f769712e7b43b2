// SPDX-License-Identifier: MIT
// An end beyond which another shape goes on is no corner. A ball that is in that one by a rounding or, in a
// pile, by a little more is hit by the end of one that moves as it passes by, with that share of its speed
// that is the root of the overlap in radii. At shapes that rest it is too slow for that, and ways over joints
// are more exact with all ends.
#include "Continuous.h"

#include "Rounding.h"

namespace Shapes::Native {

// The shape without the end that an impact is on; nothing unless another one that moves with it has an end
// there, too, and is as close to the ball with its face. What the ball may meet has been found.
std::optional<CShapeGeometry> CContinuous::WithoutSharedEnd(std::uint32_t order, const CMotion& motion,
                                                            double start, const CImpact& impact) const {
  const CShapeGeometry& o = m_pShapes->GetGeometry(order);
  if (impact.m_fRadius != 0.0 || o.m_vPt0 == o.m_vPt1) return std::nullopt;
  const double time = start + impact.m_fTime, rounding = Rounding(o.m_fSize);
  const CMotion there{motion.PosAt(impact.m_fTime), motion.VelAt(impact.m_fTime), motion.m_fRadius, 0.0};
  const double reach = Norm(there.m_vPos - impact.m_vPOI) - motion.m_fRadius + rounding;
  const auto isThere = [&](const Vector2d& end) {
    return Norm(end + time * o.m_vVel - impact.m_vPOI) <= rounding;
  };
  for (const std::uint32_t k : m_stdShapesFound) {
    const CShapeGeometry& other = m_pShapes->GetGeometry(k);
    if (k == order || !other.MovesAs(o) || !m_pShapes->Get(k).m_pShape->GetCanCollide()) continue;
    const CShapeGeometry turned = RotatedFor(other, time);
    if (!isThere(turned.m_vPt0) && !isThere(turned.m_vPt1)) continue;
    CImpact closest;
    double gap;
    if (!Near(other, there, time, reach, closest, gap) || closest.m_fRadius == 0.0) continue;
    CShapeGeometry without = o;
    (isThere(RotatedFor(o, time).m_vPt0) ? without.m_bHasEnd0 : without.m_bHasEnd1) = false;
    return without;
  }
  return std::nullopt;
}

eSweep CContinuous::SweepShape(std::uint32_t order, const CMotion& motion, double start,
                               CImpact& impact) const {
  const CShapeGeometry& o = m_pShapes->GetGeometry(order);
  const eSweep found = Sweep(o, motion, start, impact);
  if (found != eSweep::Impact || !o.IsMoving()) return found;
  const auto without = WithoutSharedEnd(order, motion, start, impact);
  return without ? Sweep(*without, motion, start, impact) : found;
}

bool CContinuous::IsNearShape(std::uint32_t order, const CMotion& motion, double start, double reach,
                              CImpact& impact, double& gap) const {
  const CShapeGeometry& o = m_pShapes->GetGeometry(order);
  if (!Near(o, motion, start, reach, impact, gap)) return false;
  if (!o.IsMoving()) return true;
  const auto without = WithoutSharedEnd(order, motion, start, impact);
  return !without || Near(*without, motion, start, reach, impact, gap);
}

} // namespace Shapes::Native
