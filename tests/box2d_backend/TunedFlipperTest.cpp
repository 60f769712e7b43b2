// SPDX-License-Identifier: MIT
// A flipper meets every ball in its way and kicks it as hard as its surface moves there.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedFlipperSeed = 45;

/// A flipper of length 1 about the origin, and a ball at rest ahead of it.
struct CFlipperCase {
  double m_fRevs, m_fElasticity;
  double m_fStart;                         // radians
  double m_fRadius, m_fDistance, m_fAhead; // of the ball: its place in polar coordinates from the flipper

  double Omega() const { return 2 * std::numbers::pi * m_fRevs; }
  /// When the face meets the ball, and the velocity that the ball has then.
  double HitTime() const { return (m_fAhead - std::asin(m_fRadius / m_fDistance)) / Omega(); }
  Vector2d Kick() const {
    const double s = std::sqrt(m_fDistance * m_fDistance - m_fRadius * m_fRadius); // along the flipper
    return (1 + m_fElasticity) * Omega() * s * Perp(UnitVector(m_fStart + Omega() * HitTime()));
  }
};

CFlipperCase MakeCase(CRandom& random) {
  CFlipperCase c{};
  c.m_fRevs = 2 + 18 * random.Unit();
  c.m_fElasticity = random.Coin() ? 1 : 0.5;
  c.m_fStart = 360 * g_fDegree * random.Unit();
  c.m_fRadius = 0.02 + 0.08 * random.Unit();
  const double nearest = std::max(0.15, 2 * c.m_fRadius);
  c.m_fDistance = nearest + (0.95 - nearest) * random.Unit();
  const double clear = std::asin(c.m_fRadius / c.m_fDistance) + 0.05;
  c.m_fAhead = clear + (2.7 - clear) * random.Unit();
  return c;
}

struct CFlipperResult {
  int m_nMissed = 0;                   // still at rest
  int m_nBehind = 0;                   // kicked, but seen behind the flipper
  std::vector<double> m_stdKickErrors; // relative; only where there is no second hit in the step of the first
};

/// Turns the flipper by 3 radians.
void Sweep(eProfile profile, const CFlipperCase& c, CFlipperResult& result) {
  auto pWorld = MakeBox2D(profile);
  CLineSegDesc desc(Vector2::Zero(), UnitVector(c.m_fStart).cast<float>());
  desc.m_eMotionType = eMotion::Kinematic;
  desc.m_fRotSpeed = static_cast<float>(c.m_fRevs);
  const CShapeId flipper = pWorld->Add(desc);
  const Vector2d place = c.m_fDistance * UnitVector(c.m_fStart + c.m_fAhead);
  const CShapeId ball =
      pWorld->Add(CDynamicCircleDesc(place.cast<float>(), static_cast<float>(c.m_fRadius), Vector2::Zero(), 1,
                                     static_cast<float>(c.m_fElasticity)));
  bool isMet = false, isBehind = false;
  const int steps = static_cast<int>(std::ceil(3 / (c.Omega() * g_fDt)));
  for (int i = 1; i <= steps; ++i) {
    pWorld->Step();
    const Vector2d v = pWorld->GetVel(ball).cast<double>(), p = pWorld->GetPos(ball).cast<double>();
    const double turnedSinceHit = (i * static_cast<double>(g_fDt) - c.HitTime()) * c.Omega();
    if (!isMet && v.norm() > 0) {
      isMet = true;
      if (turnedSinceHit < 0.7) result.m_stdKickErrors.push_back((v - c.Kick()).norm() / c.Kick().norm());
    }
    const Vector2d along = UnitVector(c.m_fStart + pWorld->GetOrientation(flipper));
    const bool withinReach = p.norm() < 0.9 && along.dot(p) > 0;
    isBehind = isBehind || (turnedSinceHit > 0 && withinReach && Cross(along, p) < 0);
  }
  result.m_nMissed += !isMet;
  result.m_nBehind += isMet && isBehind;
}

CFlipperResult Sweeps(eProfile profile) {
  CRandom random(g_nTunedFlipperSeed);
  CFlipperResult result;
  for (int k = 0; k < 2000; ++k)
    Sweep(profile, MakeCase(random), result);
  EXPECT_GT(result.m_stdKickErrors.size(), 1000u); // or the kicks say nothing
  return result;
}

TEST(TunedFlipperTest, EveryBallIsMetAndKickedAsItShouldBe) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedFlipperSeed);
  const CFlipperResult result = Sweeps(eProfile::Tuned);
  EXPECT_EQ(result.m_nMissed, 0);
  EXPECT_EQ(result.m_nBehind, 0);
  EXPECT_LE(Quantile(result.m_stdKickErrors, 1), 0.05);
}

TEST(TunedFlipperTest, AShippedFlipperMissesSome) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedFlipperSeed);
  const CFlipperResult result = Sweeps(eProfile::Shipped);
  EXPECT_GT(result.m_nMissed, 0);
  EXPECT_GT(result.m_nBehind, 0);
  EXPECT_GT(Quantile(result.m_stdKickErrors, 1), 0.1);
}

TEST(TunedFlipperTest, AGuardedTipKicksAsANakedOneDoes) {
  // A point at the tip of a bar touches whatever the end of the bar touches. What is hit first is answered,
  // and the other one must not hold the ball back, though its surface moves as fast.
  CRandom random(g_nTunedFlipperSeed);
  double most = 0;
  int kicks = 0;
  for (int k = 0; k < 400; ++k) {
    SCOPED_TRACE(testing::Message() << "seed " << g_nTunedFlipperSeed << ", case " << k);
    const double start = 360 * g_fDegree * random.Unit(), y = 1.2 * random.Unit() - 0.6,
                 x = -3 - random.Unit();
    Vector2 v[2];
    for (const bool guarded : {false, true}) {
      auto pWorld = MakeBox2D(eProfile::Tuned);
      std::vector<CAnyShapeDesc> shapes{CLineSegDesc(Vector2(-1, 0), Vector2(1, 0))};
      if (guarded) shapes.insert(shapes.end(), {CPointDesc(Vector2(-1, 0)), CPointDesc(Vector2(1, 0))});
      for (const CShapeId id : pWorld->AddCompound(shapes, {0, 0}, 2))
        pWorld->SetOrientation(id, static_cast<float>(start));
      const CShapeId ball =
          pWorld->Add(CDynamicCircleDesc({static_cast<float>(x), static_cast<float>(y)}, 0.1f, {8, 0}));
      for (int i = 0; i < 60 && pWorld->GetVel(ball).x() == 8; ++i)
        pWorld->Step();
      v[guarded] = pWorld->GetVel(ball);
    }
    kicks += v[0].x() != 8;
    most = std::max(most, static_cast<double>((v[0] - v[1]).norm() / v[0].norm()));
  }
  EXPECT_GT(kicks, 200);
  EXPECT_LE(most, 0.01);
}

} // namespace
} // namespace Shapes::Tests
