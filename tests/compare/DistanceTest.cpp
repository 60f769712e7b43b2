// SPDX-License-Identifier: MIT
// Distances against the nearest of many points of the figure.
#include "reference/Distance.h"

#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom;

constexpr int g_nPoints = 4000;

// The figure as points, neighbours at most `apart` from each other.
double NearestPoint(const CShapeGeometry<double>& f, double a0, double span, const CVec2d& p, double& apart) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= g_nPoints; ++i) {
    const double t = static_cast<double>(i) / g_nPoints;
    CVec2d q = f.m_vCenter;
    if (f.m_eShapeType == eShape::LineSeg) q = f.m_vPt0 + t * (f.m_vPt1 - f.m_vPt0);
    if (f.m_eShapeType == eShape::Circle || f.m_eShapeType == eShape::Arc)
      q += f.m_fRadius * CVec2d(std::cos(a0 + t * span), std::sin(a0 + t * span));
    least = std::min(least, Norm(CVec2d(p - q)));
  }
  apart = (f.m_eShapeType == eShape::LineSeg ? Norm(CVec2d(f.m_vPt1 - f.m_vPt0)) : f.m_fRadius * span) /
          g_nPoints;
  return least;
}

TEST(DistanceTest, IsThatOfTheNearestPoint) {
  CRandom random(17);
  SCOPED_TRACE("seed " + std::to_string(random.GetSeed()));
  for (int i = 0; i < 400; ++i) {
    const Vector2 c = random.InSquare(1), a = random.InSquare(1), b = random.InSquare(1);
    const float r = random.Uniform(0.01f, 1), a0 = random.Uniform(0, 6.28f), a1 = random.Uniform(0, 6.28f);
    const CVec2d p = ToDouble(random.InSquare(2));
    const auto expect = [&](const CAnyShapeDesc& desc, double from, double span) {
      const CShapeGeometry<double> f = MakeShapeGeometry(desc);
      double apart = 0;
      const double nearest = NearestPoint(f, from, span, p, apart);
      EXPECT_LE(Distance(f, p), nearest + 1e-6); // the points are those of the angles in float
      EXPECT_GE(Distance(f, p), nearest - apart - 1e-6);
    };
    expect(CPointDesc(c), 0, 0);
    expect(CLineSegDesc(a, b), 0, 0);
    expect(CCircleDesc(c, r), 0, 2 * std::numbers::pi);
    double span = static_cast<double>(a1) - static_cast<double>(a0);
    if (span < 0) span += 2 * std::numbers::pi;
    expect(CArcDesc(c, r, a0, a1), static_cast<double>(a0), span);
  }
}

TEST(DistanceTest, OfSpecialPlaces) {
  const CShapeGeometry<double> seg = MakeShapeGeometry(CLineSegDesc({0, 0}, {4, 0})),
                               spot = MakeShapeGeometry(CLineSegDesc({1, 1}, {1, 1}));
  EXPECT_EQ(Distance(seg, CVec2d(2, 0)), 0.0);
  EXPECT_EQ(Distance(seg, CVec2d(2, -3)), 3.0);
  EXPECT_EQ(Distance(seg, CVec2d(7, 4)), 5.0);
  EXPECT_EQ(Distance(spot, CVec2d(4, 5)), 5.0);
  EXPECT_EQ(Distance(MakeShapeGeometry(CCircleDesc({1, 0}, 2)), CVec2d(1, 0)), 2.0);   // the centre
  EXPECT_EQ(Distance(MakeShapeGeometry(CCircleDesc({1, 0}, 2)), CVec2d(1, 0.5)), 1.5); // inside: a ring
  const CShapeGeometry<double> upper = MakeShapeGeometry(CArcDesc({0, 0}, 1, 0, g_fPi));
  EXPECT_NEAR(Distance(upper, CVec2d(0, 3)), 2.0, 1e-15);
  EXPECT_NEAR(Distance(upper, CVec2d(0, -3)), std::sqrt(10.0), 1e-6); // to an end
}

} // namespace
} // namespace Shapes::Compare::Tests
