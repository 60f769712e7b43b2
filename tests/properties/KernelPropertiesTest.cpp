// SPDX-License-Identifier: MIT
// The pair kernels of the native engine, and the closest point of a circle.
#include "../bounds/Pairs.h"
#include "Drawn.h"
#include "Moved.h"
#include "Properties.h"

namespace Shapes::Properties {
namespace {

using Bounds::CPair, Bounds::eKind, Bounds::Meets;
using Native::CBall, Native::CHit;

CPair Moved(const CPair& pair, const CMap& map) {
  const CBall& b = pair.m_cBall;
  return {Moved(pair.m_cShape, map),
          {map.Pt(b.m_vPos), map.Pt(b.m_vPrevPos), map.Way(b.m_vVel), map.m_fScale * b.m_fRadius}};
}

// A pair that RapidCheck tells of if the property fails: with all digits, in hexadecimal.
CPair DrawPair(eKind kind) {
  const CPair pair = Bounds::AnyPair(g_cDrawn, kind);
  const CBall& ball = pair.m_cBall;
  std::ostringstream text;
  text << std::hexfloat << "ball at " << ball.m_vPos.transpose() << ", radius " << ball.m_fRadius
       << ", velocity " << ball.m_vVel.transpose() << "; shape ";
  const auto tell = [&]<class TDesc>(const TDesc& d) {
    if constexpr (std::is_same_v<TDesc, CLineSegDesc>)
      text << d.GetEndPt0().transpose() << " to " << d.GetEndPt1().transpose();
    else
      text << "at " << d.m_vPos.transpose();
    if constexpr (std::is_base_of_v<CCircleDesc, TDesc>) text << ", radius " << d.m_fRadius;
    if constexpr (std::is_same_v<TDesc, CArcDesc>) text << ", " << d.GetAngle0() << " to " << d.GetAngle1();
  };
  std::visit(tell, pair.m_cShape);
  RC_LOG() << text.str();
  return pair;
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
      map.m_fScale = std::ldexp(1.0f, g_cDrawn.Whole(-20, 20));
      const CPair pair = DrawPair(question.m_eKind);
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
      const CPair pair = DrawPair(question.m_eKind);
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
