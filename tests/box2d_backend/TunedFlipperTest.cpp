// SPDX-License-Identifier: MIT
// A flipper meets every ball in its way and kicks it as hard as its surface moves there.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nSeed = 45;

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
  CRandom random(g_nSeed);
  CFlipperResult result;
  for (int k = 0; k < 2000; ++k)
    Sweep(profile, MakeCase(random), result);
  EXPECT_GT(result.m_stdKickErrors.size(), 1000u); // or the kicks say nothing
  return result;
}

TEST(TunedFlipperTest, EveryBallIsMetAndKickedAsItShouldBe) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nSeed);
  const CFlipperResult result = Sweeps(eProfile::Tuned);
  EXPECT_EQ(result.m_nMissed, 0);
  EXPECT_EQ(result.m_nBehind, 0);
  EXPECT_LE(Quantile(result.m_stdKickErrors, 1), 0.05);
}

TEST(TunedFlipperTest, AShippedFlipperMissesSome) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nSeed);
  const CFlipperResult result = Sweeps(eProfile::Shipped);
  EXPECT_GT(result.m_nMissed, 0);
  EXPECT_GT(result.m_nBehind, 0);
  EXPECT_GT(Quantile(result.m_stdKickErrors, 1), 0.1);
}

} // namespace
} // namespace Shapes::Tests
