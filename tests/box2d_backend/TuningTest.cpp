// SPDX-License-Identifier: MIT
// What each switch of the tuned profile does: a world that has all of them, and one that lacks just this one.
#include "box2d_backend/world/Tuning.h"

#include "TunedTesting.h"

namespace Shapes::Tests {
namespace {

using Box2D::CTuning;
using Box2D::g_cTuned;

/// The tuned profile with one switch turned off.
CTuning Without(bool CTuning::*pSwitch) {
  CTuning tuning = g_cTuned;
  tuning.*pSwitch = false;
  return tuning;
}

/// Whether two balls of .02 that come at each other with 60 m/s pass through each other.
double Passes(const CTuning& tuning) {
  auto pWorld = MakeBox2D(tuning);
  const CShapeId left = pWorld->Add(CDynamicCircleDesc({-0.8f, 0}, 0.02f, {60, 0}));
  const CShapeId right = pWorld->Add(CDynamicCircleDesc({0.9f, 0}, 0.02f, {-60, 0}));
  Steps(*pWorld, 3);
  return pWorld->GetPos(left).x() > pWorld->GetPos(right).x();
}

/// How many of 500 balls that meet a floor of two fixtures, within .15 of where they join, are off by more
/// than .01 radians.
double CountWrongAtJoint(const CTuning& tuning) {
  CRandom random(66);
  CRange range(MakeBox2D(tuning), {CLineSegDesc({-1, 0}, {0, 0}), CLineSegDesc({0, 0}, {1, 0})}, 0.1f);
  const std::vector<double> errors = range.Errors(500, [&] {
    const double x = EitherSign(random, 0.15), incidence = EitherSign(random, 85 * g_fDegree);
    return CAim{{x, 0}, {0, 1}, incidence, 1 + 19 * random.Unit(), random.Unit()};
  });
  return static_cast<double>(std::count_if(errors.begin(), errors.end(), [](double e) { return e > 0.01; }));
}

/// By how much the height to which an elastic ball comes a minute after it was dropped from 2 has changed.
double HeightChange(const CTuning& tuning) {
  auto pWorld = MakeBox2D(tuning, {0, -9.81f});
  pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 2.1f}, 0.1f));
  float highest = 0;
  for (int i = 0; i < 3600; ++i) {
    pWorld->Step();
    if (i >= 3500) highest = std::max(highest, pWorld->GetPos(ball).y() - 0.1f);
  }
  return std::abs(highest - 2);
}

struct CFastBall {
  Vector2 m_vPos, m_vVel;
  CWorldStats m_cStats;
};

/// After some steps with this speed.
CFastBall Shoot(const CTuning& tuning, const Vector2& v, int steps = 6) {
  auto pWorld = MakeBox2D(tuning);
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, v));
  Steps(*pWorld, steps);
  return {pWorld->GetPos(ball), pWorld->GetVel(ball), pWorld->GetStats()};
}

TEST(TuningTest, CutsLetAFastBallBeFast) {
  const Vector2 v(300, 400);
  const CFastBall fast = Shoot(g_cTuned, v, 100);
  EXPECT_EQ(fast.m_vVel, v); // bit for bit
  EXPECT_LE((fast.m_vPos - 100 * g_fDt * v).norm(), 1e-3f * 100 * g_fDt * 500);
  EXPECT_EQ(fast.m_cStats.m_nMovesClamped, 0u);
  const CFastBall slowed = Shoot(Without(&CTuning::m_bAdaptiveSubsteps), {500, 0});
  EXPECT_NEAR(slowed.m_vVel.norm(), b2_maxTranslation / g_cTuned.m_fScale / g_fDt, 1e-3f);
  EXPECT_GE(slowed.m_cStats.m_nMovesClamped, 1u); // and it is reported
  EXPECT_EQ(slowed.m_cStats.m_nEngineSteps, 6u);
}

TEST(TuningTest, CutsAreAsManyAsASpeedNeeds) {
  EXPECT_EQ(Shoot(g_cTuned, {5, 0}).m_cStats.m_nEngineSteps, 6u); // one for each substep
  for (const float speed : {60.0f, 500.0f, 1500.0f}) {
    const float parts = speed * g_fDt * g_cTuned.m_fScale / (g_fSafeMove * b2_maxTranslation);
    EXPECT_EQ(Shoot(g_cTuned, {speed, 0}).m_cStats.m_nEngineSteps,
              6u * static_cast<unsigned>(std::ceil(parts)));
  }
  // There is a limit, beyond which a ball is slowed down even so.
  const CFastBall slowed = Shoot(g_cTuned, {1e5f, 0});
  EXPECT_GE(slowed.m_cStats.m_nMovesClamped, 1u);
  EXPECT_LT(slowed.m_vVel.norm(), 1e5f);
}

TEST(TuningTest, CutsAreAsManyAsATurnNeeds) {
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

/// The largest direction error of 300 shots from the inside of a half circle of 1, radians.
double WorstInBowl(const CTuning& tuning) {
  CRandom random(66);
  CRange range(MakeBox2D(tuning), {CArcDesc({0, 0}, 1, g_fPi, g_fTwoPi)}, 0.1f);
  const auto aim = [&] {
    const Vector2d u = UnitVector((195 + 150 * random.Unit()) * g_fDegree);
    return CAim{u, -u, EitherSign(random, 60 * g_fDegree), 10, random.Unit()};
  };
  return Quantile(range.Errors(300, aim), 1);
}

/// How far from a wall, at most of 20 phases, a ball of .1 m/s turns round, by its ways there and back.
double WorstPlace(const CTuning& tuning) {
  const float speed = 0.1f;
  float worst = 0;
  for (int k = 0; k < 20; ++k) {
    auto pWorld = MakeBox2D(tuning);
    pWorld->Add(CLineSegDesc({0, -1}, {0, 1}));
    const float start = 0.2f + speed * g_fDt * static_cast<float>(k) / 20;
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({start, 0}, 0.1f, {-speed, 0}));
    int steps = 0;
    for (; steps < 200 && pWorld->GetVel(ball).x() < 0; ++steps)
      pWorld->Step();
    const float turned =
        0.5f * (start + pWorld->GetPos(ball).x() - speed * g_fDt * static_cast<float>(steps));
    worst = std::max(worst, std::abs(turned - 0.1f));
  }
  return worst;
}

TEST(TuningTest, EachSwitchDoesWhatItIsFor) {
  struct CRow {
    const char* m_sName;
    CTuning m_cWithout;
    double (*m_fnMeasure)(const CTuning&);
    double m_fMost, m_fLeastWithout;
  };
  CTuning unscaled = g_cTuned;
  unscaled.m_fScale = 1;
  for (const CRow& row : {
           CRow{"bullets let no ball through another", Without(&CTuning::m_bBullets), Passes, 0, 0},
           {"ghost vertices make one floor of two", Without(&CTuning::m_bGhostVertices), CountWrongAtJoint, 0,
            0},
           {"parabolas keep the height of a drop", Without(&CTuning::m_bParabolas), HeightChange, 0.02, 0.02},
           {"exact contacts make arcs round", Without(&CTuning::m_bExactContacts), WorstInBowl, 0.02, 0.05},
           {"the scale puts walls where they are for slow balls", unscaled, WorstPlace, g_fTunedOffset,
            g_fTunedOffset},
       }) {
    SCOPED_TRACE(row.m_sName);
    EXPECT_LE(row.m_fnMeasure(g_cTuned), row.m_fMost);
    EXPECT_GT(row.m_fnMeasure(row.m_cWithout), row.m_fLeastWithout);
  }
}

} // namespace
} // namespace Shapes::Tests
