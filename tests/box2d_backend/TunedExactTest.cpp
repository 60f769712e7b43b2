// SPDX-License-Identifier: MIT
// The exact answers that tuned worlds are held against, held against the native engine in tiny steps.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedExactSeed = 40;
constexpr unsigned g_nSubsteps = 250;

std::unique_ptr<CWorld> MakeNative() {
  CWorldDesc desc;
  desc.m_fTimeStep = g_fDt;
  desc.m_nSubsteps = g_nSubsteps;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

/// The largest direction error of 50 shots of 10 m/s, up to 60 degrees from the normal, at `surface`
/// u (u is a random unit vector above the x axis).
double MostError(const CAnyShapeDesc& shape, double surface, bool inside) {
  CRange range(MakeNative(), {shape}, 0.1f);
  CRandom random(g_nTunedExactSeed);
  double most = 0;
  for (int k = 0; k < 50;) {
    const Vector2d u = UnitVector((20 + 140 * random.Unit()) * g_fDegree);
    const double incidence = EitherSign(random, 60 * g_fDegree), phase = random.Unit();
    const auto shot = range.Aim({surface * u, inside ? Vector2d(-u) : u, incidence, 10, phase});
    if (!shot) continue;
    ++k;
    most = std::max(most, range.DirectionError(*shot));
  }
  return most;
}

TEST(TunedExactTest, TheNativeEngineInTinyStepsAgrees) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedExactSeed);
  // A ball is late by a substep at most; the normal turns by that way, seen from the centre of curvature of
  // the way of its centre, and the direction by twice as much. Half of that again for the rounding of floats.
  const auto bound = [](double radius) { return 1.5 * 2 * (10.0 * g_fDt / g_nSubsteps) / radius; };
  EXPECT_LE(MostError(CPointDesc({0, 0}), 0, false), bound(0.1));
  EXPECT_LE(MostError(CCircleDesc({0, 0}, 0.5f), 0.5, false), bound(0.6));
  EXPECT_LE(MostError(CArcDesc({0, 0}, 1, 0, g_fPi), 1, false), bound(1.1));
  EXPECT_LE(MostError(CArcDesc({0, 0}, 1, 0, g_fPi), 1, true), bound(0.9));
}

TEST(TunedExactTest, TheNativeEngineAgreesAtSegments) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedExactSeed);
  CRandom random(g_nTunedExactSeed);
  for (int k = 0; k < 50; ++k) {
    const Vector2 along = random.Direction();
    CRange range(MakeNative(), {CLineSegDesc(-along, along)}, 0.1f);
    const double s = EitherSign(random, 0.8), incidence = EitherSign(random, 80 * g_fDegree);
    const Vector2d t = along.cast<double>().normalized();
    const auto shot = range.Aim({s * t, Perp(t), incidence, 10, random.Unit()});
    ASSERT_TRUE(shot);
    EXPECT_LE(range.DirectionError(*shot), 1e-5);
  }
}

} // namespace
} // namespace Shapes::Tests
