// SPDX-License-Identifier: MIT
// Shots at each kind of shape on the native engine with Continuous, held against the exact reference. ctest
// shoots a part of what docs/effects.md reports; SHAPES_SHOTS=1000000 shoots all of it and prints the
// figures.
#include "../../src/Tolerances.h"
#include "../native/NativeTesting.h"
#include "ReferenceTesting.h"

#include <iostream>

namespace Shapes::Compare {
namespace {

enum class eTarget { Point, LineSeg, LineSegEnd, Circle, Ring, ArcOutside, ArcInside, ArcEnd, Ball };

/// How the target moves, and whether gravity pulls the balls.
struct CMoves {
  const char* m_sName;
  bool m_bTurns, m_bMoves, m_bFalls;
};
constexpr CMoves g_stdMoves[] = {{"", false, false, false},
                                 {"Turning", true, false, false},
                                 {"Moving", false, true, false},
                                 {"MovingTurning", true, true, false},
                                 {"FallingOnto", false, false, true},
                                 {"FallingOntoTurning", true, false, true},
                                 {"FallingOntoMovingTurning", true, true, true}};
constexpr std::pair<const char*, eTarget> g_stdTargets[] = {
    {"Point", eTarget::Point},         {"LineSeg", eTarget::LineSeg}, {"LineSegEnd", eTarget::LineSegEnd},
    {"Circle", eTarget::Circle},       {"Ring", eTarget::Ring},       {"ArcOutside", eTarget::ArcOutside},
    {"ArcInside", eTarget::ArcInside}, {"ArcEnd", eTarget::ArcEnd},   {"Ball", eTarget::Ball}};

struct CCase {
  std::string m_sName;
  eTarget m_eTarget;
  CMoves m_cMoves;
};

std::vector<CCase> MakeCases() {
  std::vector<CCase> cases;
  for (const CMoves& moves : g_stdMoves)
    for (const auto& [pName, target] : g_stdTargets)
      if (target != eTarget::Ball || !(moves.m_bTurns || moves.m_bMoves))
        cases.push_back({std::string(moves.m_sName) + pName, target, moves});
  return cases;
}

// From where it touches the target with the normal n there, the ball goes back by a random part of a step.
CDynamicCircleDesc MakeBall(CRandom& random, const Vector2& poi, const Vector2& n, float r, float way) {
  // An incidence of up to 89 degrees.
  const float angle = random.Uniform(-1.55f, 1.55f);
  const Vector2 v = RotatePt(-n, Vector2::Zero(), angle) * (way / g_fDt);
  const float part = random.Uniform(0.0f, 1.0f);
  return {poi + r * n - v * (part * g_fDt), r, v, random.Scale(-3, 3)};
}

CSceneDesc MakeShot(CRandom& random, const CCase& what) {
  const float r = random.Scale(-4, 0);
  const float ratio = std::exp(random.Uniform(std::log(0.01f), std::log(1e4f)));
  const Vector2 c = random.InSquare(2.0f);
  const float a = random.Uniform(0.0f, g_fTwoPi), R = r * random.Scale(-2, 4),
              length = r * random.Scale(-2, 6);
  const Vector2 u = AngleToVector(a);
  const bool isBall = what.m_eTarget == eTarget::Ball;
  CAnyShapeDesc target;
  // Where the ball is to touch, and from where.
  Vector2 poi = c, n = u;
  switch (what.m_eTarget) {
  case eTarget::Ball: break;
  case eTarget::Point: target = CPointDesc(c); break;
  case eTarget::LineSeg:
    target = CLineSegDesc(c, c + length * perp(u));
    poi = c + random.Uniform(0.0f, 1.0f) * length * perp(u);
    break;
  case eTarget::LineSegEnd:
    target = CLineSegDesc(c, c + length * perp(u));
    n = RotatePt(u, Vector2::Zero(), random.Uniform(-1.5f, 0.0f));
    break;
  case eTarget::Circle:
  case eTarget::Ring:
  case eTarget::ArcOutside:
  case eTarget::ArcInside: {
    const bool isInside = what.m_eTarget == eTarget::Ring || what.m_eTarget == eTarget::ArcInside;
    const float radius = isInside ? r * (1.0f + random.Scale(-3, 5)) : R;
    target = CCircleDesc(c, radius);
    if (what.m_eTarget == eTarget::ArcOutside || what.m_eTarget == eTarget::ArcInside) {
      const float before = random.Uniform(0.0f, 3.0f), after = random.Uniform(0.01f, 3.0f);
      target = CArcDesc(c, radius, a - before, a + after);
    }
    poi = c + radius * u;
    if (isInside) n = -u;
    break;
  }
  case eTarget::ArcEnd:
    target = CArcDesc(c, R, a, a + random.Uniform(0.01f, 6.0f));
    poi = c + R * u;
    n = RotatePt(u, Vector2::Zero(), random.Uniform(-2.0f, 0.0f)); // seen from before the end
    break;
  }
  CSceneDesc shot;
  shot.m_stdBalls = {MakeBall(random, poi, n, r, ratio * r)};
  if (isBall) {
    // Both move; the other one is on its way, too.
    const float R1 = r * random.Scale(-3, 3);
    const Vector2 v = random.VectorOfLength(0.0f, ratio * r / g_fDt);
    const float part = random.Uniform(0.0f, 1.0f);
    shot.m_stdBalls.emplace_back(c - R1 * u - v * (part * g_fDt), R1, v, random.Scale(-3, 3));
    const float back = part * g_fDt; // both at the same time
    shot.m_stdBalls[0].m_vPos = c + r * u - shot.m_stdBalls[0].m_vVel * back;
  }
  CDynamicCircleDesc& ball = shot.m_stdBalls[0];
  const CMoves& moves = what.m_cMoves;
  if (moves.m_bTurns || moves.m_bMoves)
    std::visit(
        [&](auto& desc) {
          desc.m_eMotionType = eMotion::Kinematic;
          const Vector2 away = random.VectorOfLength(0.0f, 4.0f * r);
          desc.m_vRotCenter = random.Coin() ? Vector2(c + away) : c;
          if (moves.m_bTurns) desc.m_fRotSpeed = random.SignedScale(-3, 5); // up to a whole turn in a step
          if (moves.m_bMoves) desc.m_vVel = random.VectorOfLength(0.0f, 50.0f * r / g_fDt);
          ball.m_vVel += desc.m_vVel; // seen from there the ball comes as it did
        },
        target);
  if (moves.m_bFalls) {
    Vector2& g = shot.m_cWorld.m_vGravity;
    g = random.VectorOfLength(0.0f, std::min(10.0f, ratio) * r / (g_fDt * g_fDt));
    // Two that fall together come to each other as they did; one comes about there, about then.
    const float back = random.Uniform(0.0f, 1.0f) * g_fDt;
    if (!isBall) {
      ball.m_vVel -= g * back;
      ball.m_vPos += g * (0.5f * back * back);
    }
  }
  if (!isBall) shot.m_stdShapes = {target};
  return shot;
}

class ContinuousShotsTest : public testing::TestWithParam<CCase> {
protected:
  struct CResult {
    int m_nHits = 0;     // that the reference sees, and that are not ambiguous
    int m_nTunneled = 0; // of them without a response, or with one on the wrong side
    int m_nUndecided = 0;
    int m_nGhosts = 0; // responses where the reference sees nothing
    // Errors of the outgoing direction where there was one impact, by the decade of v dt / r.
    std::array<std::vector<double>, 6> m_stdErrors;
  };

  // Coordinates and radii of all that is there.
  static double GetSize(const CExact& exact) {
    double size = 0.0;
    for (std::size_t i = 0; i < exact.GetBallCount(); ++i)
      size += exact.GetBall(i).GetExtent();
    if (exact.GetShapeCount() == 0) return size;
    const CShapeGeometry<double> f = exact.GetGeometry(0);
    for (const CVec2d* p : {&f.m_vCenter, &f.m_vPt0, &f.m_vPt1})
      size += p->cwiseAbs().maxCoeff();
    return size + f.m_fRadius;
  }

  static CResult Shoot(const CEffectChoice& choice, int shots, std::uint64_t seed) {
    CRandom random(seed);
    CResult result;
    for (int i = 0; i < shots; ++i) {
      const CSceneDesc shot = MakeShot(random, GetParam());
      CExact exact = Make(shot.m_stdShapes, shot.m_stdBalls, shot.m_cWorld.m_vGravity);
      if (GetGap(exact, 0) < 0) continue; // it would be set back: that is no shot
      CEvents events;
      try {
        exact.Step(g_fDt, events);
      } catch (const std::runtime_error&) { // the reference cannot decide
        ++result.m_nUndecided;
        continue;
      }

      const auto pWorld = MakeNative(choice);
      pWorld->SetGravity(shot.m_cWorld.m_vGravity);
      shot.AddTo(*pWorld);
      pWorld->Step();
      const auto contacts = pWorld->GetContacts();
      if (events.empty()) {
        // A ball that meets a shape along its surface slides on it, without an event.
        const bool touches = exact.GetNearMissCount() + exact.GetSlideCount() > 0;
        result.m_nGhosts += !contacts.empty() && !touches;
        continue;
      }
      const CExactEvent<double>& first = events[0];
      // A touch within the roundings of floats may be answered a step later; a factor of 2.
      const double size = GetSize(exact);
      const double approach = (first.m_vSurface - first.m_vVelBefore).dot(first.m_vNorm);
      if (first.m_bGraze || first.m_bOverlapped || first.m_bSimultaneous ||
          approach * (static_cast<double>(g_fDt) - first.m_fTime) < 2.0 * g_fTouchRounding * size)
        continue;
      ++result.m_nHits;
      if (contacts.empty() || contacts[0].m_vNorm.cast<double>().dot(first.m_vNorm) <= 0.0) {
        ++result.m_nTunneled;
        continue;
      }
      if (events.size() != 1) continue;
      const Vector2d v = pWorld->GetBallVelocities()[0].cast<double>(), w = exact.GetBall(0).m_vVel;
      const double ratio =
          static_cast<double>(shot.m_stdBalls[0].m_vVel.norm() * g_fDt / shot.m_stdBalls[0].m_fRadius);
      const auto decade = static_cast<std::size_t>(std::clamp(std::floor(std::log10(ratio)) + 2.0, 0.0, 5.0));
      result.m_stdErrors[decade].push_back(AngleBetween(v, w));
    }
    return result;
  }
};

TEST_P(ContinuousShotsTest, NoneTunnelsAtAnySpeed) {
  constexpr std::uint64_t seed = 20;
  const int shots = static_cast<int>(HowMany("SHAPES_SHOTS", 10000)); // of each kind
  CResult result = Shoot(g_cContinuous, shots, seed);
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::cout << GetParam().m_sName << ": " << shots << " shots, " << result.m_nHits << " hits, "
            << result.m_nTunneled << " tunneled, " << result.m_nGhosts << " ghosts, " << result.m_nUndecided
            << " undecided, p95 by decade";
  EXPECT_GT(result.m_nHits, shots / 4);
  EXPECT_EQ(result.m_nTunneled, 0);
  EXPECT_EQ(result.m_nGhosts, 0);
  EXPECT_LE(result.m_nUndecided, shots / 5000);
  for (std::size_t decade = 0; decade < result.m_stdErrors.size(); ++decade) {
    std::vector<double>& errors = result.m_stdErrors[decade];
    if (errors.size() < 20) continue;
    std::sort(errors.begin(), errors.end());
    const double p95 = errors[errors.size() * 95 / 100];
    std::cout << " " << p95 << " (" << errors.back() << ")";
    // Both start from the same floats; the velocity is rounded to floats in the end.
    EXPECT_LT(p95, 1e-6) << "v dt / r up to 1e" << static_cast<int>(decade) - 1;
  }
  std::cout << "\n";
}

TEST_P(ContinuousShotsTest, WhichTheApproximateWayDoes) {
  const CResult result = Shoot(g_cApproximate, 2000, 21);
  EXPECT_GT(result.m_nTunneled, result.m_nHits / 5);
}

INSTANTIATE_TEST_SUITE_P(, ContinuousShotsTest, testing::ValuesIn(MakeCases()),
                         [](const auto& sample) { return sample.param.m_sName; });

} // namespace
} // namespace Shapes::Compare
