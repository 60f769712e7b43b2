// SPDX-License-Identifier: MIT
// The pair kernels of the native engine, and the closest point of a circle.
#include "Generators.h"
#include "Moved.h"
#include "Properties.h"

#include "native/narrowphase/Collide.h"

namespace Shapes::Properties {
namespace {

using Native::CBall;
using Native::CHit;

struct CPair {
  CAnyShapeDesc m_cShape;
  CBall m_cBall;
};

bool Meets(const CPair& pair, CHit& hit) {
  return std::visit(
      [&](const auto& d) {
        using T = std::decay_t<decltype(d)>;
        if constexpr (std::is_same_v<T, CPointDesc>) return CollidePointCircle(CPoint(d), pair.m_cBall, hit);
        if constexpr (std::is_same_v<T, CLineSegDesc>)
          return CollideLineSegCircle(CLineSeg(d), pair.m_cBall, hit);
        if constexpr (std::is_same_v<T, CCircleDesc>)
          return CollideCircleCircle(CCircle(d), pair.m_cBall, hit);
        if constexpr (std::is_same_v<T, CArcDesc>) return CollideCircleArc(CArc(d), pair.m_cBall, hit);
        if constexpr (std::is_same_v<T, CDynamicCircleDesc>)
          return CollideBallBall({d.m_vPos, d.m_vPos, d.m_vVel, d.m_fRadius}, pair.m_cBall, hit);
      },
      pair.m_cShape);
}

CPair Moved(const CPair& pair, const CMap& map) {
  const CBall& b = pair.m_cBall;
  return {Moved(pair.m_cShape, map),
          {map.Pt(b.m_vPos), map.Pt(b.m_vPrevPos), map.Way(b.m_vVel), map.m_fScale * b.m_fRadius}};
}

enum class eKind { Point, LineSeg, Circle, Arc, Ball };

// A gap for a ball of radius r: any, almost touching, almost none.
float Gap(float r) { return r * *rc::gen::oneOf(Between(0.0f, 1.2f), NearOne(), Small(24, 1)); }

// A shape and a ball that almost touches it, or overlaps.
CPair Pair(eKind kind) {
  const auto ball = [](const Vector2& p, float r) { return CBall{p, p, *Way(*AnySize()), r}; };
  if (kind == eKind::LineSeg) {
    const CLineSegDesc seg = *Segment();
    const Vector2 v = seg.GetEndPt1() - seg.GetEndPt0();
    const float r = *Scale(6) * Length(v), side = *rc::gen::element(1.0f, -1.0f);
    const float share = *Between(-0.1f, 1.1f), gap = side * Gap(r);
    return {seg, ball(seg.GetEndPt0() + share * v + gap * seg.GetNormal(), r)};
  }
  const CCircleDesc ring = *Ring();
  const Vector2& c = ring.m_vPos;
  const float R = ring.m_fRadius, r = R * *rc::gen::oneOf(Scale(8), NearOne());
  if (kind == eKind::Point) return {CPointDesc(c), ball(c + *Way(Gap(r)), r)};
  if (kind == eKind::Ball) {
    const Vector2 v = *Way(*AnySize());
    return {CDynamicCircleDesc(c, R, v), ball(c + *Way(Gap(R + r)), r)};
  }
  const float side = *rc::gen::element(1.0f, -1.0f), away = std::abs(R + side * Gap(r));
  if (kind == eKind::Circle) return {ring, ball(c + *Way(away), r)};
  const float a0 = *Angle(), a1 = *Angle(), share = *Between(-0.1f, 1.1f);
  const CArcDesc arc(c, R, a0, a1);
  return {arc, ball(c + away * AngleToVector(arc.GetAngle0() + share * CArc(arc).GetSpan()), r)};
}

using CMeets = std::function<bool(const CPair&, CHit&)>;

// The closest point of a circle, whether the ball is there or not.
bool FindClosest(const CPair& pair, CHit& hit) {
  hit = {CCircle(std::get<CCircleDesc>(pair.m_cShape)).ClosestPt(pair.m_cBall.m_vPos), Vector2::Zero(), 0.0f};
  return true;
}

const struct {
  eKind m_eKind;
  CMeets m_stdMeets;
} g_stdQuestions[] = {{eKind::Point, Meets}, {eKind::LineSeg, Meets}, {eKind::Circle, Meets},
                      {eKind::Arc, Meets},   {eKind::Ball, Meets},    {eKind::Circle, FindClosest}};

void ExpectSameBits(const CPair& pair, const CMap& map, const CMeets& meets) {
  CHit is, should;
  const bool got = meets(pair, should);
  RC_ASSERT(meets(Moved(pair, map), is) == got);
  if (!got) return;
  RC_ASSERT(is.m_vNorm == map.m_pTurn(should.m_vNorm));
  RC_ASSERT(is.m_fSetback == map.m_fScale * should.m_fSetback);
  RC_ASSERT(is.m_vPOI == map.Pt(should.m_vPOI));
}

// A power of two is exact for what is not denormal, then or now. So small are the coordinates of arcs that
// end next to an axis.
bool IsPlain(float f) { return f == 0.0f || std::abs(f) > 1e-30f; }
bool IsPlain(const Vector2& v) { return IsPlain(v.x()) && IsPlain(v.y()); }
bool IsPlain(const CPair& pair) {
  const auto* pArc = std::get_if<CArcDesc>(&pair.m_cShape);
  if (pArc != nullptr && !(IsPlain(pArc->GetAngle0()) && IsPlain(pArc->GetAngle1()))) return false;
  CHit hit;
  return IsPlain(pair.m_cBall.m_vPos) && (!Meets(pair, hit) || (IsPlain(hit.m_vPOI) && IsPlain(hit.m_vNorm)));
}

TEST(KernelProperties, APowerOfTwoScalesTheBits) {
  for (const auto& question : g_stdQuestions)
    ExpectHolds(false, true, 5000, [&](bool epsilon) {
      CMap map;
      map.m_fScale = std::ldexp(1.0f, *Whole(20));
      const CPair pair = Pair(question.m_eKind);
      RC_PRE(IsPlain(pair));
      // The control does not find what is closer than a millimetre.
      const CMeets meets = [&](const CPair& p, CHit& hit) {
        return question.m_stdMeets(p, hit) && !(epsilon && (hit.m_vPOI - p.m_cBall.m_vPos).norm() < 1e-3f);
      };
      ExpectSameBits(pair, map, meets);
    });
}

// Where the order of the ends is kept, and where the centre is off the shape: there are fallbacks that are
// up, or the front.
bool IsSymmetric(const CPair& pair, const CMap& map) {
  CHit hit;
  const Vector2& p = pair.m_cBall.m_vPos;
  if (Meets(pair, hit) && hit.m_vPOI == p) return false;
  const auto* pSeg = std::get_if<CLineSegDesc>(&pair.m_cShape);
  if (pSeg == nullptr) return std::visit([&](const auto& d) { return d.m_vPos != p; }, pair.m_cShape);
  const CAnyShapeDesc moved = Moved(pair.m_cShape, map);
  return std::get<CLineSegDesc>(moved).GetEndPt0() == map.Pt(pSeg->GetEndPt0());
}

TEST(KernelProperties, AQuarterTurnAndAMirrorKeepTheBits) {
  for (const auto& question : g_stdQuestions) {
    if (question.m_eKind == eKind::Arc) continue; // whose angles are not exact otherwise
    ExpectHolds(false, true, 5000, [&](bool naive) {
      const CPair pair = Pair(question.m_eKind);
      CMap turned, mirrored, away;
      turned.m_pTurn = Quarter;
      mirrored.m_pTurn = MirrorY;
      // The control moves both away from the origin, to the right and up, before it looks.
      if (naive) away.m_vShift = Vector2(0.5f, 0.25f) * pair.m_cBall.m_fRadius;
      const CMeets meets = [&](const CPair& p, CHit& hit) {
        FailIf(!question.m_stdMeets(Moved(p, away), hit));
        hit.m_vPOI -= away.m_vShift;
        return true;
      };
      for (const CMap& map : {turned, mirrored})
        if (IsSymmetric(pair, map)) ExpectSameBits(pair, map, meets);
    });
  }
}

} // namespace
} // namespace Shapes::Properties
