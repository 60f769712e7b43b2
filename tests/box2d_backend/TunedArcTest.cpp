// SPDX-License-Identifier: MIT
// Arcs are chords to Box2D. A tuned world bounces off the arc all the same, without more chords.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedArcSeed = 41;

constexpr std::uint64_t g_nMostPiecesOfHalf = 16;

/// Direction errors of 4,000 shots, half of them at a full circle and half at half circles, r = .1, R = 1,
/// 10 m/s, up to 80 degrees from the normal.
std::vector<double> ShootAtArcs(eProfile profile, bool inside) {
  std::vector<double> errors;
  CRandom random(g_nTunedArcSeed);
  for (int k = 0; k < 5; ++k) {
    const bool isFull = k == 4;
    const double a0 = isFull ? 0 : k * 90 * g_fDegree, span = (isFull ? 360 : 180) * g_fDegree;
    const double margin = isFull ? 0 : 0.15; // the ends are another matter
    const CArcDesc arc({0, 0}, 1, static_cast<float>(a0), isFull ? 0 : static_cast<float>(a0 + span));
    CRange range(MakeBox2D(profile), {arc}, 0.1f);
    EXPECT_LE(range.World().GetStats().m_nArcPieces, (isFull ? 2 : 1) * g_nMostPiecesOfHalf);
    const std::size_t enough = errors.size() + (isFull ? 2000 : 500);
    while (errors.size() < enough) {
      const Vector2d u = UnitVector(a0 + margin + (span - 2 * margin) * random.Unit());
      const double incidence = EitherSign(random, 80 * g_fDegree), phase = random.Unit();
      const auto shot = range.Aim({u, inside ? Vector2d(-u) : u, incidence, 10, phase});
      if (shot) errors.push_back(range.DirectionError(*shot));
    }
  }
  return errors;
}

TEST(TunedArcTest, DirectionsAreExactToMilliradians) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedArcSeed);
  for (const bool inside : {true, false}) {
    SCOPED_TRACE(inside ? "inside" : "outside");
    const std::vector<double> errors = ShootAtArcs(eProfile::Tuned, inside);
    EXPECT_LE(Quantile(errors, 0.5), 0.004);
    EXPECT_LE(Quantile(errors, 0.95), 0.016);
    EXPECT_LE(Quantile(errors, 1), 0.1); // none is lost
  }
}

TEST(TunedArcTest, ShippedDirectionsAreThoseOfTheChords) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedArcSeed);
  for (const bool inside : {true, false}) {
    SCOPED_TRACE(inside ? "inside" : "outside");
    const std::vector<double> errors = ShootAtArcs(eProfile::Shipped, inside);
    EXPECT_GT(Quantile(errors, 0.5), 0.05);
    EXPECT_GT(Quantile(errors, 0.95), 0.15);
  }
}

} // namespace
} // namespace Shapes::Tests
