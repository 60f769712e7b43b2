// SPDX-License-Identifier: MIT
#include "../Descs.h"
#include "../GameClock.h"
#include "../Numbers.h"
#include "Bytes.h"
#include "Fuzz.h"

#include "Tolerances.h"

#include <Shapes/Shapes.h>

#include "geometry/TimeOfImpact.h"
#include "native/narrowphase/Collide.h"
#include "traps/Traps.h"

#include <algorithm>
#include <memory>
#include <numbers>

namespace Shapes::Fuzz {
namespace {

using namespace Native;
using namespace Geometry;

double Largest(const Vector2d& v) { return v.cwiseAbs().maxCoeff(); }

// ---- The pair --------------------------------------------------------------------------------------------

template <class TDesc>
std::unique_ptr<CShape> Make(CBytes& bytes, const TDesc& desc) {
  if (!bytes.Flag()) return Shapes::MakeShape(desc);
  const float revsPerSecond = bytes.Number();
  auto pShape = Shapes::MakeShape(Turning(desc, revsPerSecond, bytes.Vector()));
  pShape->SetOrientation(bytes.Number());
  return pShape;
}

std::unique_ptr<CShape> MakeShape(CBytes& bytes) {
  const eSides sides = bytes.OneOf({eSides::Both, eSides::Front, eSides::Back});
  const unsigned type = bytes.Byte() % 4;
  const Vector2 p = bytes.Vector();
  if (type == 0) return Make(bytes, CPointDesc(p));
  if (type == 1) return Make(bytes, Sided(CLineSegDesc(p, bytes.Vector()), sides));
  const float r = bytes.Number();
  if (type == 2) return Make(bytes, CCircleDesc(p, r));
  const float a0 = bytes.Number(), a1 = bytes.Number();
  return Make(bytes, Sided(CArcDesc(p, r, a0, a1), sides));
}

std::unique_ptr<CDynamicCircle> MakeBall(CBytes& bytes) {
  const Vector2 p = bytes.Vector(), v = bytes.Vector();
  const float r = bytes.Number();
  return std::make_unique<CDynamicCircle>(CDynamicCircleDesc(p, r, v));
}

CBall ToBall(const CDynamicCircle& ball) {
  return {ball.GetPos(), ball.GetPrevPos(), ball.GetVel(), ball.GetRadius()};
}

// ---- The kernels of the approximate way ------------------------------------------------------------------

/// Of a shape, and of another ball.
struct CExtent {
  double m_fSize;         // largest coordinate
  double m_fRadius = 0.0; // of what is round
  bool m_bOneSided = false;
};

CExtent ExtentOf(const CShape& shape) {
  const CAabb2D& box = shape.GetAABB();
  CExtent extent{std::max(Largest(Wide(box.GetTopLeft())), Largest(Wide(box.GetBottomRt())))};
  // The centre of an arc may be far out of its box.
  extent.m_fSize = std::max(extent.m_fSize, Largest(Wide(shape.GetPos())));
  if (const auto* pCircle = dynamic_cast<const CCircle*>(&shape))
    extent.m_fRadius = Wide(pCircle->GetRadius());
  if (const auto* pArc = dynamic_cast<const CArc*>(&shape))
    extent.m_bOneSided = pArc->GetSides() != eSides::Both;
  if (const auto* pSeg = dynamic_cast<const CLineSeg*>(&shape))
    extent.m_bOneSided = pSeg->GetSides() != eSides::Both;
  return extent;
}

/// An error of some roundings of everything involved; the last term is for denormal numbers.
double Bound(const CExtent& extent, const CBall& ball) {
  return 32.0 * 0x1p-23 *
             (extent.m_fSize + extent.m_fRadius + Largest(Wide(ball.m_vPos)) + Wide(ball.m_fRadius)) +
         1e-43;
}

/// How far p is from the curve of the shape.
double DistanceTo(const CShape& shape, const Vector2d& p) {
  if (const auto* pSeg = dynamic_cast<const CLineSeg*>(&shape)) {
    const Vector2d p0 = Wide(pSeg->GetEndPt0()), p1 = Wide(pSeg->GetEndPt1()),
                   t = Unit(p1 - p0, Vector2d::UnitX());
    const double along = std::clamp((p - p0).dot(t), 0.0, Norm(p1 - p0));
    return Norm(p - (p0 + along * t));
  }
  const double R = ExtentOf(shape).m_fRadius;
  return std::abs(Norm(p - Wide(shape.GetPos())) - R);
}

void RequireHit(const CHit& hit, const CBall& ball, const CExtent& extent) {
  const double bound = Bound(extent, ball), r = Wide(ball.m_fRadius);
  Require(hit.m_vPOI.allFinite(), "a POI is finite", hit.m_vPOI.transpose());
  Require(IsUnit(hit.m_vNorm), "a normal is a unit vector", hit.m_vNorm.transpose());
  const double setback = Wide(hit.m_fSetback);
  Require(setback >= 0.0, "a setback is at least 0", setback);
  // A ball that comes through the solid side is set back across; one that does not fit into a ring is
  // outside, however deep.
  const double most = extent.m_bOneSided ? 2.0 * r : r + extent.m_fRadius;
  Require(setback <= most + bound, "a setback is no longer than the overlap", setback, most);
  const Vector2d n = Wide(hit.m_vNorm), d = Wide(ball.m_vPos) - Wide(hit.m_vPOI);
  Require(std::abs(d.dot(n) + setback - r) <= bound, "the setback leaves the ball touching", d.dot(n),
          setback, r);
  Require(std::abs(Cross(d, n)) <= bound, "the POI is along the normal", Cross(d, n), bound);
}

void TryDetect(const CShape& shape, const CBall& ball) {
  CHit hit;
  for (int i = 0; i < 3; ++i) {
    const CWithoutTraps onPurpose;
    CBall nowhere = ball;
    float* const numbers[] = {&nowhere.m_vPos.x(), &nowhere.m_vPos.y(), &nowhere.m_fRadius};
    *numbers[i] = g_fNan;
    Require(!Collide(shape, nowhere, hit), "a place or a radius that is no number meets nothing", i);
  }
  if (!Collide(shape, ball, hit)) return;
#ifdef SHAPES_PLANTED_FAULT
  // As in a textbook: the direction from the POI to the centre, whatever it is where both are one.
  if (shape.GetShapeType() == eShape::Point) hit.m_vNorm = (ball.m_vPos - hit.m_vPOI).normalized();
#endif
  const CExtent extent = ExtentOf(shape);
  RequireHit(hit, ball, extent);
  const double off = DistanceTo(shape, Wide(hit.m_vPOI));
  Require(off <= Bound(extent, ball), "the POI is on the shape", off, Bound(extent, ball));
}

// ---- The sweeps ------------------------------------------------------------------------------------------

/// The error bound of Sweep.h, as a gap; touching included.
double SweepBound(double size, const CMotion& motion, double turn) {
  const double way = Norm(motion.m_vVel) * motion.m_fDuration;
  return (2.0 * g_nSweepRoundings + 16.0) * 0x1p-52 *
         (size + Largest(motion.m_vPos) + 2.0 * motion.m_fRadius + way) * (1.0 + turn);
}

void RequireImpact(const CImpact& impact, double most) {
  Require(impact.m_fTime >= 0.0 && impact.m_fTime <= most, "an impact is on the motion", impact.m_fTime,
          most);
  Require(impact.m_vPOI.allFinite() && impact.m_vSurface.allFinite(), "an impact has a finite place",
          impact.m_vPOI.transpose(), impact.m_vSurface.transpose());
  Require(std::abs(impact.m_vNorm.norm() - 1.0) <= 64.0 * 0x1p-52, "the normal of an impact is a unit vector",
          impact.m_vNorm.transpose());
  Require(std::isfinite(impact.m_fCurve) && impact.m_fCurve >= 0.0, "a curve is at least 0", impact.m_fCurve);
}

void RequireTouching(const CImpact& impact, const CMotion& motion, bool overlapped, double bound) {
  const Vector2d p = motion.m_vPos + motion.m_vVel * impact.m_fTime;
  const double reach = (p - impact.m_vPOI).dot(impact.m_vNorm);
  Require(reach <= motion.m_fRadius + bound, "at an impact the ball has come to the shape", reach,
          motion.m_fRadius);
  Require(overlapped || reach >= motion.m_fRadius - bound, "at an impact the ball overlaps by rounding only",
          reach, motion.m_fRadius);
}

/// The end of the motion as the approximate way sees it.
CBall AtEnd(const CBall& ball, const CMotion& motion) {
  CBall end = ball;
  end.m_vPos = (motion.m_vPos + motion.m_vVel * motion.m_fDuration).cast<float>();
  return end;
}

/// Where the kernel finds an overlap above the bound, so does the sweep. The approximate mode, with open
/// ends, sees a part of the impacts that the sweeps see.
void RequireSameOverlap(const CHit& hit, bool overlaps, double depth, double bound) {
  if (!(Wide(hit.m_fSetback) > bound)) return;
  Require(overlaps, "who is detected overlaps", hit.m_fSetback, hit.m_vNorm.transpose());
  Require(std::abs(depth - Wide(hit.m_fSetback)) <= bound, "setback and depth agree", hit.m_fSetback, depth,
          hit.m_vNorm.transpose());
}

void RequireClear(const CHit& hit, double bound) {
  Require(Wide(hit.m_fSetback) <= bound, "who meets nothing on the way is clear at its end", hit.m_fSetback,
          bound);
}

void TrySweep(const CShape& shape, const CBall& ball, const CMotion& motion) {
  const double turnSpeed = 2.0 * std::numbers::pi * Wide(shape.GetRotSpeed());
  const CShapeGeometry geometry = MakeShapeGeometry(shape, turnSpeed);
  CImpact impact;
  double depth = 0.0;
  const bool overlaps = Overlap(geometry, motion, 0.0, impact, depth);
  if (overlaps) {
    RequireImpact(impact, 0.0);
    Require(depth > 0.0 && std::isfinite(depth), "an overlap has a depth", depth);
  }
  const eSweep found = Sweep(geometry, motion, 0.0, impact);
  const double bound =
      SweepBound(geometry.m_fSize, motion, std::abs(geometry.m_fTurnSpeed) * motion.m_fDuration);
  if (found == eSweep::OutOfIterations)
    Require(impact.m_fTime >= 0.0 && impact.m_fTime <= motion.m_fDuration, "what is unknown is on the motion",
            impact.m_fTime);
  const CExtent extent = ExtentOf(shape);
  const double detectBound = Bound(extent, ball) + bound, r = motion.m_fRadius;
  // A ball that does not fit into an arc goes out of it, whatever it overlaps.
  const double out = Norm(motion.m_vPos - geometry.m_vCenter) - geometry.m_fRadius;
  const bool isUnfit = shape.GetShapeType() == eShape::Arc && r >= geometry.m_fRadius && out <= detectBound;
  if (found == eSweep::Impact) {
    RequireImpact(impact, motion.m_fDuration);
    // The ends of one-sided shapes let go whatever overlaps them, which the face meets later.
    RequireTouching(impact, motion, overlaps || isUnfit || extent.m_bOneSided, bound);
  }

  if (extent.m_bOneSided) return;
  CHit hit;
  // Right on an arc rounding says on which side the ball is.
  if (!(isUnfit && out >= -detectBound) && Collide(shape, ball, hit))
    RequireSameOverlap(hit, overlaps, depth, detectBound);
  const CBall end = AtEnd(ball, motion);
  if (found != eSweep::None || overlaps || isUnfit || turnSpeed != 0.0 || !end.m_vPos.allFinite()) return;
  if (Collide(shape, end, hit)) RequireClear(hit, Bound(extent, end) + bound);
}

// ---- Two balls -------------------------------------------------------------------------------------------

void TryBalls(const CBall& other, const CBall& ball, const CMotion& otherMotion, const CMotion& motion) {
  const CExtent extent{Largest(Wide(other.m_vPos)), Wide(other.m_fRadius)};
  CHit hit;
  const bool detected = CollideBallBall(other, ball, hit);
  if (detected) RequireHit(hit, ball, extent);

  CImpact impact, swapped;
  double depth = 0.0;
  const bool overlaps = OverlapBallBall(otherMotion, motion, impact, depth);
  if (overlaps) Require(depth > 0.0 && std::isfinite(depth), "an overlap has a depth", depth);
  const double otherWay = Norm(otherMotion.m_vVel) * motion.m_fDuration;
  const double bound = SweepBound(extent.m_fSize + 2.0 * extent.m_fRadius + otherWay, motion, 0.0);
  if (detected) RequireSameOverlap(hit, overlaps, depth, Bound(extent, ball) + bound);
  const eSweep found = ImpactBallBall(otherMotion, motion, impact);
  Require(found != eSweep::OutOfIterations, "two balls are always known");
  Require(ImpactBallBall(motion, otherMotion, swapped) == found, "swapped balls meet where they met");
  if (found == eSweep::Impact) {
    RequireImpact(impact, motion.m_fDuration);
    RequireTouching(impact, motion, overlaps, bound);
    Require(swapped.m_fTime == impact.m_fTime, "swapped balls meet when they met", swapped.m_fTime,
            impact.m_fTime);
    const bool areApart = motion.m_vPos + motion.m_vVel * impact.m_fTime !=
                          otherMotion.m_vPos + otherMotion.m_vVel * impact.m_fTime;
    Require(!areApart || swapped.m_vNorm == -impact.m_vNorm, "swapping balls turns the normal",
            swapped.m_vNorm.transpose(), impact.m_vNorm.transpose());
    return;
  }
  const CBall end = AtEnd(ball, motion), otherEnd = AtEnd(other, otherMotion);
  if (overlaps || !end.m_vPos.allFinite() || !otherEnd.m_vPos.allFinite()) return;
  const CExtent endExtent{Largest(Wide(otherEnd.m_vPos)), extent.m_fRadius};
  if (CollideBallBall(otherEnd, end, hit)) RequireClear(hit, Bound(endExtent, end) + bound);
}

// ---- Box2D -----------------------------------------------------------------------------------------------

void TryBox2D(CShape& shape, CDynamicCircle& ball) {
  const CBackend* pBox2D = GetBackend(eBackend::Box2D);
  if (pBox2D == nullptr) return;
  // Thousands of chords, each swept in dozens of parts, take seconds.
  if (shape.GetShapeType() == eShape::Arc && static_cast<const CArc&>(shape).GetRadius() > 100.0f) return;
  CContactDesc c(&shape, &ball);
  if (!pBox2D->CollisionDetected(c)) return;
  RequireSoundContact(c);
  ball.CollisionResponse(c);
  Require(ball.GetPos().allFinite() && ball.GetVel().allFinite(), "a response leaves numbers",
          ball.GetPos().transpose(), ball.GetVel().transpose());
}

} // namespace

void FuzzPairs(std::span<const std::uint8_t> data) {
  CBytes bytes(data);
  const bool isBall = bytes.Byte() % 5 == 4;
  const float durations[] = {1.0f / 60.0f, 0.0f, 1.0f, 1e-30f, 1e6f};
  const float dt = bytes.OneOf(durations);
  std::unique_ptr<CShape> pShape;
  std::unique_ptr<CDynamicCircle> pOther, pBall;
  try {
    pBall = MakeBall(bytes);
    if (isBall)
      pOther = MakeBall(bytes);
    else
      pShape = MakeShape(bytes);
  } catch (const std::invalid_argument&) {
    return; // there is no such pair
  }
  const auto toLeg = [&](const CDynamicCircle& ball) {
    return CMotion{Wide(ball.GetPos()), Wide(ball.GetVel()), Wide(ball.GetRadius()), Wide(dt)};
  };
  // Where it was is somewhere else than now in half of the cases.
  CGameClock::Set(dt, 0.0f);
  if (bytes.Flag()) pBall->move();
  if (pOther) {
    TryBalls(ToBall(*pOther), ToBall(*pBall), toLeg(*pOther), toLeg(*pBall));
  } else {
    TryDetect(*pShape, ToBall(*pBall));
    TrySweep(*pShape, ToBall(*pBall), toLeg(*pBall));
    TryBox2D(*pShape, *pBall);
  }
  CGameClock::Set(1.0f / 60.0f, 0.0f);
}

} // namespace Shapes::Fuzz
