// SPDX-License-Identifier: MIT
// How far and how fast a tuned world moves balls and flippers: fast, slow, and up again after a drop.
#include "TunedTesting.h"

namespace Shapes::Tests {
namespace {

/// A flipper of length 1 about the origin, and a ball at rest ahead of it.
struct CFlipperCase {
  CLineSegDesc m_cFlipper;
  CDynamicCircleDesc m_cBall;
};

CFlipperCase MakeCase(CRandom& random) {
  const auto revs = static_cast<float>(2 + 18 * random.Unit());
  const float e = random.Coin() ? 1 : 0.5f;
  const double start = 360 * g_fDegree * random.Unit(), r = 0.02 + 0.08 * random.Unit();
  const double nearest = std::max(0.15, 2 * r), distance = nearest + (0.95 - nearest) * random.Unit();
  const double clear = std::asin(r / distance) + 0.05, ahead = clear + (2.7 - clear) * random.Unit();
  const Vector2d tip = UnitVector(start), place = distance * UnitVector(start + ahead);
  return {Turning(CLineSegDesc({0, 0}, tip.cast<float>()), revs),
          CDynamicCircleDesc(place.cast<float>(), static_cast<float>(r), {0, 0}, 1, e)};
}

struct CFlipperResult {
  int m_nMissed = 0;                   // still at rest
  int m_nBehind = 0;                   // kicked, but seen behind the flipper
  std::vector<double> m_stdKickErrors; // relative; only where there is no second hit in the step of the first
};

/// Turns the flipper by 3 radians.
void Sweep(const CTuning& tuning, const CFlipperCase& c, CFlipperResult& result) {
  const double speed = g_fPi2 * Wide(c.m_cFlipper.m_fRotSpeed); // radians per second
  const CAnyShapeDesc shapes[] = {c.m_cFlipper};
  Compare::CReference<double> exact(shapes, std::array{c.m_cBall}, {0, 0});
  std::vector<Compare::CExactEvent<double>> hits;
  exact.Step(3 / speed, hits);
  const Vector2d kick = hits.at(0).m_vVelAfter;

  auto pWorld = MakeBox2D(tuning);
  const CShapeId flipper = pWorld->Add(c.m_cFlipper), ball = pWorld->Add(c.m_cBall);
  bool isMet = false, isBehind = false;
  const int steps = static_cast<int>(std::ceil(3 / (speed * g_fDt)));
  for (int i = 1; i <= steps; ++i) {
    pWorld->Step();
    const Vector2d v = Wide(pWorld->GetVel(ball)), p = Wide(pWorld->GetPos(ball));
    const double turnedSinceHit = (i * Wide(g_fDt) - hits[0].m_fTime) * speed;
    if (!isMet && v.norm() > 0) {
      isMet = true;
      if (turnedSinceHit < 0.7) result.m_stdKickErrors.push_back((v - kick).norm() / kick.norm());
    }
    const Vector2d along = Wide(RotatePt(c.m_cFlipper.GetEndPt1(), {0, 0}, pWorld->GetOrientation(flipper)));
    const bool withinReach = p.norm() < 0.9 && along.dot(p) > 0;
    isBehind = isBehind || (turnedSinceHit > 0 && withinReach && Cross(along, p) < 0);
  }
  result.m_nMissed += !isMet;
  result.m_nBehind += isMet && isBehind;
}

CFlipperResult Sweeps(const CTuning& tuning) {
  CRandom random(45);
  CFlipperResult result;
  for (int k = 0; k < 2000; ++k)
    Sweep(tuning, MakeCase(random), result);
  EXPECT_GT(result.m_stdKickErrors.size(), 1000u); // or the kicks say nothing
  return result;
}

TEST(TunedFlipperTest, EveryBallIsMetAndKickedAsItShouldBe) {
  const CFlipperResult result = Sweeps(g_cTuned);
  EXPECT_EQ(result.m_nMissed, 0);
  EXPECT_EQ(result.m_nBehind, 0);
  EXPECT_LE(Quantile(result.m_stdKickErrors, 1), 0.05);
  const CFlipperResult shipped = Sweeps(g_cShipped); // the control
  EXPECT_GT(shipped.m_nMissed, 0);
  EXPECT_GT(shipped.m_nBehind, 0);
  EXPECT_GT(Quantile(shipped.m_stdKickErrors, 1), 0.1);
}

TEST(TunedFlipperTest, AGuardedTipKicksAsANakedOneDoes) {
  // A point at the tip of a bar touches whatever the end of the bar touches. What is hit first is answered,
  // and the other one must not hold the ball back, though its surface moves as fast.
  float most = 0;
  int kicks = 0;
  ForEachCase(45, 400, [&](CRandom& random, int) {
    const auto start = static_cast<float>(360 * g_fDegree * random.Unit()),
               y = static_cast<float>(1.2 * random.Unit() - 0.6), x = static_cast<float>(-3 - random.Unit());
    Vector2 v[2];
    for (const bool guarded : {false, true}) {
      auto pWorld = MakeBox2D(g_cTuned);
      std::vector<CAnyShapeDesc> shapes{CLineSegDesc(Vector2(-1, 0), Vector2(1, 0))};
      if (guarded) shapes.insert(shapes.end(), {CPointDesc(Vector2(-1, 0)), CPointDesc(Vector2(1, 0))});
      for (const CShapeId id : pWorld->AddCompound(shapes, {0, 0}, 2))
        pWorld->SetOrientation(id, start);
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({x, y}, 0.1f, {8, 0}));
      for (int i = 0; i < 60 && pWorld->GetVel(ball).x() == 8; ++i)
        pWorld->Step();
      v[guarded] = pWorld->GetVel(ball);
    }
    kicks += v[0].x() != 8;
    most = std::max(most, (v[0] - v[1]).norm() / v[0].norm());
  });
  EXPECT_GT(kicks, 200);
  EXPECT_LE(most, 0.01f);
}

struct CFastBall {
  Vector2 m_vPos, m_vVel;
  CWorldStats m_cStats;
};

/// A ball after some steps with this speed, in an empty world or with a wall 20 away.
CFastBall Shoot(const CTuning& tuning, const Vector2& v, int steps = 6, bool wall = false) {
  auto pWorld = MakeBox2D(tuning);
  if (wall) pWorld->Add(CLineSegDesc({20, -5}, {20, 5}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, v));
  Steps(*pWorld, steps);
  return {pWorld->GetPos(ball), pWorld->GetVel(ball), pWorld->GetStats()};
}

// Steps are cut for what is fast, as often as it needs.

TEST(TunedClampTest, CutsLetAFastBallBeFast) {
  const Vector2 v(300, 400);
  const CFastBall fast = Shoot(g_cTuned, v, 100);
  EXPECT_EQ(fast.m_vVel, v); // bit for bit
  EXPECT_LE((fast.m_vPos - 100 * g_fDt * v).norm(), 1e-3f * 100 * g_fDt * 500);
  EXPECT_EQ(fast.m_cStats.m_nMovesClamped, 0u);
  EXPECT_LE((Shoot(g_cTuned, {500, 0}, 6, true).m_vVel - Vector2(-500, 0)).norm(), 500 * 1e-6f);
  const CFastBall slowed = Shoot(Without(&CTuning::m_bAdaptiveSubsteps), {500, 0});
  EXPECT_NEAR(slowed.m_vVel.norm(), b2_maxTranslation / g_cTuned.m_fScale / g_fDt, 1e-3f);
  EXPECT_GE(slowed.m_cStats.m_nMovesClamped, 1u); // and it is reported
  EXPECT_EQ(slowed.m_cStats.m_nEngineSteps, 6u);
}

TEST(TunedClampTest, CutsAreAsManyAsASpeedNeeds) {
  EXPECT_EQ(Shoot(g_cTuned, {5, 0}).m_cStats.m_nEngineSteps, 6u); // one for each substep
  for (const float speed : {60.0f, 500.0f, 1500.0f}) {
    const float parts = speed * g_fDt * g_cTuned.m_fScale / (g_fSafeMove * b2_maxTranslation);
    EXPECT_EQ(Shoot(g_cTuned, {speed, 0}).m_cStats.m_nEngineSteps, 6 * std::ceil(parts));
  }
  // There is a limit, beyond which a ball is slowed down even so.
  const CFastBall slowed = Shoot(g_cTuned, {1e5f, 0});
  EXPECT_GE(slowed.m_cStats.m_nMovesClamped, 1u);
  EXPECT_LT(slowed.m_vVel.norm(), 1e5f);
}

TEST(TunedClampTest, CutsAreAsManyAsATurnNeeds) {
  const auto count = [](float revsPerSecond, float reach) {
    auto pWorld = MakeBox2D(g_cTuned);
    pWorld->Add(Turning(CLineSegDesc(Vector2(0, 0), Vector2(reach, 0)), revsPerSecond));
    Steps(*pWorld, 6);
    EXPECT_EQ(pWorld->GetStats().m_nTurnsClamped, 0u);
    return pWorld->GetStats().m_nEngineSteps;
  };
  EXPECT_EQ(count(0, 0.1f), 6u);
  EXPECT_EQ(count(1, 0.1f), 6u); // .105 radians a step
  const float turn = g_fTwoPi * 30 * g_fDt;
  EXPECT_EQ(count(30, 0.1f), 6u * static_cast<unsigned>(std::ceil(turn / g_fLargestTurn)));
  EXPECT_GT(count(1, 20), 6u); // a long one sweeps far
}

// A ball that is dropped comes back to where its elasticity lets it, for as long as it bounces.

const CAnyShapeDesc g_cSegment = CLineSegDesc({-1, 0}, {1, 0}), g_cPoint = CPointDesc({0, 0});
const CAnyShapeDesc g_cGrounds[]{g_cSegment, g_cPoint, CCircleDesc({0, -0.5f}, 0.5f),
                                 CArcDesc({0, 6}, 6, g_fPi, g_fTwoPi)}; // so wide that the ball stays in it

/// Heights of the tops of a ball's way after a drop from a height of 2.
std::vector<double> Tops(const CTuning& tuning, const CAnyShapeDesc& ground, float rate, float elasticity,
                         float seconds) {
  auto pWorld = MakeBox2D(tuning, {0, -9.81f}, 1 / rate);
  pWorld->Add(ground);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 2.1f}, 0.1f, {0, 0}, 1, elasticity));
  std::vector<double> tops;
  double top = 0;
  bool rises = false;
  for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
    pWorld->Step();
    const double height = pWorld->GetPos(ball).y() - 0.1;
    const bool risesNow = pWorld->GetVel(ball).y() > 0;
    if (risesNow && !rises) top = 0;
    top = std::max(top, height);
    if (rises && !risesNow) tops.push_back(top);
    rises = risesNow;
  }
  return tops;
}

/// The largest relative error of the first ten tops.
double DecayError(const CTuning& tuning, const CAnyShapeDesc& ground, float rate) {
  const std::vector<double> tops = Tops(tuning, ground, rate, 0.9f, 10);
  EXPECT_GE(tops.size(), 10u);
  double most = 0, exact = 2;
  for (std::size_t k = 0; k < std::min<std::size_t>(10, tops.size()); ++k) {
    exact *= 0.9 * 0.9;
    most = std::max(most, std::abs(tops[k] / exact - 1));
  }
  return most;
}

TEST(TunedDropTest, EachBounceKeepsTheSquareOfTheElasticity) {
  for (const CAnyShapeDesc& ground : g_cGrounds)
    for (const float rate : {60.0f, 120.0f, 240.0f}) {
      SCOPED_TRACE(testing::Message() << "ground " << &ground - g_cGrounds << ", " << rate << " Hz");
      const float seconds = &ground == g_cGrounds ? 300 : 60;
      const std::vector<double> tops = Tops(g_cTuned, ground, rate, 1, seconds);
      const double periods = seconds / (2 * std::sqrt(2 * 2 / 9.81));
      ASSERT_FALSE(tops.empty());
      EXPECT_NEAR(static_cast<double>(tops.size()), periods, 0.02 * periods + 1);
      EXPECT_GE(Quantile(tops, 0), 0.99 * 2);
      EXPECT_LE(Quantile(tops, 1), 1.01 * 2);
      EXPECT_LE(DecayError(g_cTuned, ground, rate), 0.02);
      EXPECT_GT(DecayError(g_cShipped, ground, rate), 0.1); // the control
    }
  EXPECT_GT(Tops(g_cShipped, g_cSegment, 120, 1, 300).back(), 3); // the control: it climbs
  EXPECT_GT(Tops(Without(&CTuning::m_bParabolas), g_cSegment, 120, 1, 300).back(), 1.01 * 2);
}

// Slow balls bounce too: neither profile has a speed below which they stop.

/// The velocity along y of a ball that comes down on the shape's top at the origin.
float Rebound(const CTuning& tuning, const CAnyShapeDesc& shape, float speed) {
  auto pWorld = MakeBox2D(tuning);
  pWorld->Add(shape);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0.1f + 0.0331f}, 0.1f, {0, -speed}));
  const int steps = static_cast<int>(2 * 0.0331f / speed / g_fDt) + 10;
  for (int i = 0; i < steps && pWorld->GetVel(ball).y() < 0; ++i)
    pWorld->Step();
  return pWorld->GetVel(ball).y();
}

TEST(TunedSlowTest, ASlowBallReboundsAtItsSpeed) {
  const CArcDesc hill({0, -1}, 1, 0, 0), bowl({0, 1}, 1, 0, 0);
  const std::vector<CAnyShapeDesc> shapes{g_cPoint, g_cSegment, CCircleDesc({0, -1}, 1), hill, bowl};
  for (const bool tuned : {false, true})
    for (std::size_t k = 0; k < (tuned ? 5u : 3u); ++k)
      for (const float speed : {0.99f, 0.1f, 0.01f}) {
        SCOPED_TRACE(testing::Message() << "tuned " << tuned << ", shape " << k);
        EXPECT_NEAR(Rebound(tuned ? g_cTuned : g_cShipped, shapes[k], speed), speed, 1e-5f);
      }
  // The control: two chords of the shipped bowl join at its bottom, and the ball gains speed there.
  EXPECT_GT(std::abs(Rebound(g_cShipped, bowl, 0.99f) - 0.99f), 0.01f);
}

} // namespace
} // namespace Shapes::Tests
