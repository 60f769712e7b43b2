// SPDX-License-Identifier: MIT
// All input that the library accepts is answered by finite numbers, and without a floating point exception on
// the way: coordinates, radii and speeds from denormal floats to 1e18 and beyond, no speed, no time, no
// extent.
#include "geometry/TimeOfImpact.h"

#include "../Testing.h"

#include <cfenv>

namespace Shapes::Geometry {
namespace {

// Of any size, and often a special one.
float AnySize(CRandom& random) {
  const float sizes[] = {0.0f, 1e-45f, 1e-38f, 1.0f, 1e18f, random.Scale(-126, 58), random.Scale(-4, 4)};
  return sizes[random.Below(7)];
}
Vector2 AnyPlace(CRandom& random) {
  const float x = AnySize(random), y = AnySize(random);
  return {random.Coin() ? x : -x, random.Coin() ? y : -y};
}

std::unique_ptr<CShape> AnyShape(CRandom& random) {
  const eSides sides[] = {eSides::Both, eSides::Front, eSides::Back};
  const Vector2 p = AnyPlace(random), q = AnyPlace(random), center = random.Coin() ? p : AnyPlace(random);
  const float R = AnySize(random);
  const auto make = [&](const auto& desc) { return MakeShape(Turning(desc, 0, center)); };
  switch (random.Below(4)) {
  case 0: return make(CPointDesc(p));
  case 1: return make(Sided(CLineSegDesc(p, q), sides[random.Below(3)]));
  case 2: return make(CCircleDesc(p, R));
  default: {
    const float a0 = random.Uniform(0.0f, 6.28f);
    const CArcDesc desc(p, R, a0, random.Below(3) == 0 ? a0 : random.Uniform(0.0f, 6.28f));
    return make(Sided(desc, sides[random.Below(3)]));
  }
  }
}

CMotion AnyLeg(CRandom& random) {
  const double durations[] = {0.0, 1e-45, 1.0 / 60.0, 1.0, 1e6};
  const Vector2d p = AnyPlace(random).cast<double>();
  const double faster = random.Below(4) == 0 ? 1e10 : 1.0;
  const Vector2d v = AnyPlace(random).cast<double>() * faster;
  const double r = static_cast<double>(AnySize(random));
  return {p, v, r, durations[random.Below(5)]};
}

void ExpectFinite(const CImpact& impact, const CMotion& motion) {
  EXPECT_TRUE(impact.m_fTime >= 0.0 && impact.m_fTime <= motion.m_fDuration) << impact.m_fTime;
  EXPECT_TRUE(impact.m_vPOI.allFinite() && impact.m_vSurface.allFinite());
  EXPECT_NEAR(impact.m_vNorm.norm(), 1.0, 16.0 * 0x1p-52);
  EXPECT_TRUE(std::isfinite(impact.m_fCurve) && impact.m_fCurve >= 0.0) << impact.m_fCurve;
}

class CSweepExtremes : public testing::Test {
protected:
  void SetUp() override { std::feclearexcept(FE_ALL_EXCEPT); }
  static bool Raised() { return std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != 0; }
};

TEST_F(CSweepExtremes, ShapesAreAnsweredByNumbers) {
  int met = 0, unknown = 0, overlaps = 0;
  ForEachCase(18, 40000, [&](CRandom& random, int) {
    const std::unique_ptr<CShape> shape = AnyShape(random);
    const double speeds[] = {0.0, 0.0, 1e-30, 10.0, 1e3, 6.3e9};
    const double speed = speeds[random.Below(6)], start = random.Coin() ? 0.0 : 1e6 * random.Unit();
    const CMotion motion = AnyLeg(random);
    std::feclearexcept(FE_ALL_EXCEPT);
    const CShapeGeometry geometry = MakeShapeGeometry(*shape, speed);
    CImpact impact;
    double depth = 0.0;
    const eSweep found = Sweep(geometry, motion, start, impact);
    if (found == eSweep::Impact) ExpectFinite(impact, motion);
    if (found == eSweep::OutOfIterations) {
      EXPECT_TRUE(impact.m_fTime >= 0.0 && impact.m_fTime <= motion.m_fDuration);
    }
    met += found == eSweep::Impact;
    unknown += found == eSweep::OutOfIterations;
    if (Overlap(geometry, motion, start, impact, depth)) {
      ++overlaps;
      ExpectFinite(impact, motion);
      EXPECT_TRUE(depth > 0.0 && std::isfinite(depth));
    }
    EXPECT_FALSE(Raised());
  });
  EXPECT_GT(met, 4000);
  EXPECT_GT(overlaps, 1000);
  RecordProperty("unknown", unknown);
}

TEST_F(CSweepExtremes, BallsAreAnsweredByNumbers) {
  int met = 0;
  ForEachCase(19, 40000, [&](CRandom& random, int) {
    const CMotion other = AnyLeg(random), ball = AnyLeg(random);
    std::feclearexcept(FE_ALL_EXCEPT);
    CImpact impact;
    double depth = 0.0;
    if (ImpactBallBall(other, ball, impact) == eSweep::Impact) {
      ++met;
      ExpectFinite(impact, ball);
    }
    if (OverlapBallBall(other, ball, impact, depth)) {
      ExpectFinite(impact, ball);
      EXPECT_TRUE(depth > 0.0 && std::isfinite(depth));
    }
    EXPECT_FALSE(Raised());
  });
  EXPECT_GT(met, 4000);
}

// The control: the textbook's root of the quadratic, on the same trials.
TEST_F(CSweepExtremes, TheTextbookRaisesExceptions) {
  int raised = 0;
  ForEachCase(19, 1000, [&](CRandom& random, int) {
    const CMotion other = AnyLeg(random), ball = AnyLeg(random);
    std::feclearexcept(FE_ALL_EXCEPT);
    const Vector2d d = ball.m_vPos - other.m_vPos, v = ball.m_vVel - other.m_vVel;
    const double R = other.m_fRadius + ball.m_fRadius, b = d.dot(v), a = v.squaredNorm();
    [[maybe_unused]] volatile double t = (-b - std::sqrt(b * b - a * (d.squaredNorm() - R * R))) / a;
    raised += Raised();
  });
  EXPECT_GT(raised, 100);
}

} // namespace
} // namespace Shapes::Geometry
