// SPDX-License-Identifier: MIT
// The pair kernels of the native engine, and responses.
#include "Generators.h"
#include "Moved.h"
#include "Properties.h"

#include "native/narrowphase/Collide.h"
#include "shapes/Response.h"

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

constexpr eKind g_eKinds[] = {eKind::Point, eKind::LineSeg, eKind::Circle, eKind::Arc, eKind::Ball};
constexpr eKind g_eWithoutAngles[] = {eKind::Point, eKind::LineSeg, eKind::Circle, eKind::Ball};

// The control of what depends on nothing but the geometry: a ball that has come closer than 0.001.
bool MeetsWithAnEpsilon(const CPair& pair, CHit& hit) { return Meets(pair, hit) && hit.m_fSetback > 1e-3f; }
// And a setback that was found by squares of coordinates.
bool MeetsBySquares(const CPair& pair, CHit& hit) {
  FailIf(!Meets(pair, hit));
  const Vector2 &p = pair.m_cBall.m_vPos, &q = hit.m_vPOI;
  hit.m_fSetback =
      pair.m_cBall.m_fRadius - std::sqrt(std::max(0.0f, p.squaredNorm() - 2.0f * p.dot(q) + q.squaredNorm()));
  return true;
}

using CMeets = bool (*)(const CPair&, CHit&);

void ExpectSameBits(const CPair& pair, const CMap& map, CMeets meets, bool withPOI) {
  CHit is, should;
  const bool got = meets(pair, should);
  RC_ASSERT(meets(Moved(pair, map), is) == got);
  if (!got) return;
  RC_ASSERT(is.m_vNorm == map.m_pTurn(should.m_vNorm));
  RC_ASSERT(is.m_fSetback == map.m_fScale * should.m_fSetback);
  if (withPOI) RC_ASSERT(is.m_vPOI == map.Pt(should.m_vPOI));
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
  for (const eKind kind : g_eKinds)
    ExpectHolds(Meets, MeetsWithAnEpsilon, 5000, [=](CMeets meets) {
      CMap map;
      map.m_fScale = std::ldexp(1.0f, *Whole(20));
      const CPair pair = Pair(kind);
      RC_PRE(IsPlain(pair));
      ExpectSameBits(pair, map, meets, true);
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
  for (const eKind kind : g_eWithoutAngles)
    ExpectHolds(false, true, 5000, [=](bool naive) {
      const CPair pair = Pair(kind);
      CMap turned, mirrored;
      turned.m_pTurn = Quarter;
      mirrored.m_pTurn = MirrorY;
      // The control moves both away from the origin, to the right and up, before it looks.
      const CMeets meets = naive ? CMeets([](const CPair& p, CHit& hit) {
        CMap away;
        away.m_vShift = Vector2(0.5f, 0.25f) * p.m_cBall.m_fRadius;
        FailIf(!Meets(Moved(p, away), hit));
        hit.m_vPOI -= away.m_vShift;
        return true;
      })
                                 : CMeets(Meets);
      for (const CMap& map : {turned, mirrored})
        if (IsSymmetric(pair, map)) ExpectSameBits(pair, map, meets, true);
    });
}

// Coordinates that are multiples of 2^-8 up to 2^6 keep their differences when they are moved by less than
// 2^15: what is computed from those has the same bits.
TEST(KernelProperties, AMoveAmongRepresentablePlacesKeepsTheBits) {
  for (const eKind kind : g_eWithoutAngles)
    ExpectHolds(Meets, MeetsBySquares, 5000, [=](CMeets meets) {
      const auto place = [](float unit) {
        const int x = *Whole(1 << 14), y = *Whole(1 << 14);
        return Vector2(unit * Vector2(static_cast<float>(x), static_cast<float>(y)));
      };
      const Vector2 p = place(0x1p-8f), q = place(0x1p-8f), c = place(0x1p-8f);
      const float r = std::ldexp(static_cast<float>(*rc::gen::inRange(1, 1 << 14)), -8),
                  R = std::ldexp(static_cast<float>(*rc::gen::inRange(1, 1 << 14)), -8);
      CPair pair{CPointDesc(p), {c, c, *Way(1.0f), r}};
      if (kind == eKind::LineSeg) pair.m_cShape = CLineSegDesc(p, q);
      if (kind == eKind::Circle) pair.m_cShape = CCircleDesc(p, R);
      if (kind == eKind::Ball) pair.m_cShape = CDynamicCircleDesc(p, R, *Way(1.0f));
      CMap map;
      map.m_vShift = place(1.0f);
      ExpectSameBits(pair, map, meets, false);
    });
}

TEST(ResponseProperties, AQuarterTurnAMirrorAndAPowerOfTwoKeepTheBits) {
  ExpectHolds(false, true, 5000, [](bool epsilon) {
    const auto velocity = [] { return *rc::gen::mapcat(AnySize(), [](float speed) { return Way(speed); }); };
    // That of the surface is any other or almost the same.
    const Vector2 n = Normalize(*Way(1.0f)), v = velocity(), p = *Place(1.0f);
    const Vector2 surface = *rc::gen::arbitrary<bool>() ? velocity() : Vector2(*NearOne() * v);
    const float e = *Between(0.0f, 2.0f), setback = *AnySize();
    const float s = std::ldexp(1.0f, *Whole(20));
    const auto respond = [=](const Vector2& nn, float back, const Vector2& ss, Vector2 pp, Vector2 vv) {
      // The control takes slow ones for resting.
      if (epsilon && (vv - ss).norm() < 1e-3f) return std::pair(pp, ss);
      RespondKinematic(nn, back, e, ss, pp, vv);
      return std::pair(pp, vv);
    };
    const auto [p1, v1] = respond(n, setback, surface, p, v);
    const auto turned = respond(perp(n), setback, perp(surface), perp(p), perp(v));
    RC_ASSERT(turned.first == perp(p1) && turned.second == perp(v1));
    const auto mirrored = respond(MirrorY(n), setback, MirrorY(surface), MirrorY(p), MirrorY(v));
    RC_ASSERT(mirrored.first == MirrorY(p1) && mirrored.second == MirrorY(v1));
    const auto scaled = respond(n, s * setback, s * surface, s * p, s * v);
    RC_ASSERT(scaled.first == Vector2(s * p1) && scaled.second == Vector2(s * v1));
  });
}

} // namespace
} // namespace Shapes::Properties
