// SPDX-License-Identifier: MIT
// Where a surface is to a ball that bounces off it head-on, seen from the way it takes afterwards.
#include <gtest/gtest.h>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

constexpr std::uint64_t g_nTunedWallSeed = 44;

enum class ePair { Point, Face, End, Circle, ArcOutside, ArcInside, Balls };
struct CNamedPair {
  ePair m_ePair;
  const char* m_sName;
};
constexpr CNamedPair g_stdPairs[]{
    {ePair::Point, "point"},   {ePair::Face, "face of a segment"},  {ePair::End, "end of a segment"},
    {ePair::Circle, "circle"}, {ePair::ArcOutside, "arc, outside"}, {ePair::ArcInside, "arc, inside"},
    {ePair::Balls, "ball"}};

struct CTarget {
  double m_fContact;               // distance of the ball's centre from the origin when it touches, r = .1
  std::optional<CShapeId> m_cBall; // the target if it is a ball
};

/// Adds a shape about the origin that is met by a ball on the axis u.
CTarget AddTarget(CWorld& world, ePair pair, const Vector2d& u) {
  const Vector2 side = Perp(u).cast<float>();
  switch (pair) {
  case ePair::Point: world.Add(CPointDesc({0, 0})); return {0.1, {}};
  case ePair::Face: world.Add(CLineSegDesc(side, -side)); return {0.1, {}};
  case ePair::End: world.Add(CLineSegDesc(Vector2::Zero(), (-u).cast<float>())); return {0.1, {}};
  case ePair::Circle: world.Add(CCircleDesc({0, 0}, 0.5f)); return {0.6, {}};
  case ePair::ArcOutside: world.Add(CArcDesc({0, 0}, 1, 0, 0)); return {1.1, {}};
  case ePair::ArcInside: world.Add(CArcDesc({0, 0}, 1, 0, 0)); return {0.9, {}};
  case ePair::Balls: return {0.2, world.Add(CDynamicCircleDesc({0, 0}, 0.1f))};
  }
  return {};
}

/// How far the surface is out of place, towards the ball: half of the shift of the outgoing way against the
/// exact one; infinity if there was no bounce. Of two balls in their relative motion.
double Offset(eProfile profile, ePair pair, double speed, double phase, double angle) {
  auto pWorld = MakeBox2D(profile);
  const Vector2d u = UnitVector(angle);
  const Vector2d n = pair == ePair::ArcInside ? Vector2d(-u) : u;
  const CTarget target = AddTarget(*pWorld, pair, u);
  const Vector2d touching = target.m_fContact * u;
  const double dt = g_fDt, clear = std::floor(0.05 / (speed * dt)) + 1; // steps
  const CShapeId ball = pWorld->Add(CDynamicCircleDesc(
      (touching + (clear + phase) * speed * dt * n).cast<float>(), 0.1f, (-speed * n).cast<float>()));
  const double t = (pWorld->GetPos(ball).cast<double>() - touching).dot(n) / speed;
  const int steps = static_cast<int>(t / dt) + 1 + std::max(3, static_cast<int>(0.03 / speed / dt));
  for (int i = 0; i < steps; ++i)
    pWorld->Step();

  Vector2d p = pWorld->GetPos(ball).cast<double>(), v = pWorld->GetVel(ball).cast<double>();
  if (target.m_cBall) {
    p -= pWorld->GetPos(*target.m_cBall).cast<double>();
    v -= pWorld->GetVel(*target.m_cBall).cast<double>();
  }
  // A ball that goes on as if nothing were there is not shifted at all.
  if (!(n.dot(v) > 0.9 * speed)) return std::numeric_limits<double>::infinity();
  return 0.5 * n.dot(p - (steps * dt - t) * v - touching);
}

/// The median of 256 phases of the step.
double MedianOffset(eProfile profile, ePair pair, double speed) {
  CRandom random(g_nTunedWallSeed);
  std::vector<double> offsets;
  for (int i = 0; i < 256; ++i) {
    const double angle = 360 * g_fDegree * random.Unit();
    offsets.push_back(Offset(profile, pair, speed, (i + 0.5) / 256, angle));
  }
  return Quantile(offsets, 0.5);
}

TEST(TunedWallTest, SurfacesAreWhereTheyAre) {
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedWallSeed);
  for (const auto& [pair, name] : g_stdPairs)
    for (const double speed : {0.1, 1.0, 10.0}) {
      SCOPED_TRACE(testing::Message() << name << " at " << speed);
      EXPECT_LE(std::abs(MedianOffset(eProfile::Tuned, pair, speed)), g_fTunedOffset);
    }
}

TEST(TunedWallTest, ShippedSurfacesAreFurtherAtOneSpeedAtLeast) { // the control
  SCOPED_TRACE(testing::Message() << "seed " << g_nTunedWallSeed);
  for (const auto& [pair, name] : g_stdPairs) {
    SCOPED_TRACE(name);
    double most = 0;
    for (const double speed : {0.1, 1.0, 10.0})
      most = std::max(most, std::abs(MedianOffset(eProfile::Shipped, pair, speed)));
    EXPECT_GT(most, 5 * g_fTunedOffset);
  }
}

} // namespace
} // namespace Shapes::Tests
