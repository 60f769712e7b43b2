// SPDX-License-Identifier: MIT
// A ball that is dropped comes back to where its elasticity lets it, for as long as it bounces.
#include <gtest/gtest.h>

#include <string>

#include "box2d_backend/TunedTesting.h"

namespace Shapes::Tests {
namespace {

enum class eGround { Segment, Point, Circle, Bowl };

/// Heights of the tops of a ball's way after a drop from a height of 2.
std::vector<double> Tops(eProfile profile, eGround ground, float rate, float elasticity, float seconds) {
  auto pWorld = MakeBox2D(profile, {0, -9.81f}, 1 / rate);
  switch (ground) {
  case eGround::Segment: pWorld->Add(CLineSegDesc({-1, 0}, {1, 0})); break;
  case eGround::Point: pWorld->Add(CPointDesc({0, 0})); break;
  case eGround::Circle: pWorld->Add(CCircleDesc({0, -0.5f}, 0.5f)); break;
  // So wide that the ball does not leave the middle.
  case eGround::Bowl: pWorld->Add(CArcDesc({0, 6}, 6, g_fPi, g_fTwoPi)); break;
  }
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

void ExpectSameHeight(eGround ground, float rate, float seconds) {
  const std::vector<double> tops = Tops(eProfile::Tuned, ground, rate, 1, seconds);
  const double period = 2 * std::sqrt(2 * 2 / 9.81);
  ASSERT_FALSE(tops.empty());
  EXPECT_NEAR(static_cast<double>(tops.size()), seconds / period, 0.02 * seconds / period + 1);
  EXPECT_GE(Quantile(tops, 0), 0.99 * 2);
  EXPECT_LE(Quantile(tops, 1), 1.01 * 2);
}

TEST(TunedDropTest, AnElasticBallComesBackForFiveMinutes) {
  for (const float rate : {60.0f, 120.0f, 240.0f}) {
    SCOPED_TRACE(rate);
    ExpectSameHeight(eGround::Segment, rate, 300);
  }
}

TEST(TunedDropTest, AnElasticBallComesBackFromEveryShape) {
  for (const eGround ground : {eGround::Point, eGround::Circle, eGround::Bowl})
    for (const float rate : {60.0f, 120.0f, 240.0f}) {
      SCOPED_TRACE(testing::Message() << "ground " << static_cast<int>(ground) << ", " << rate << " Hz");
      ExpectSameHeight(ground, rate, 60);
    }
}

TEST(TunedDropTest, AShippedElasticBallClimbs) { // the control
  EXPECT_GT(Tops(eProfile::Shipped, eGround::Segment, 120, 1, 300).back(), 3);
}

/// The largest relative error of the first ten tops.
double DecayError(eProfile profile, eGround ground, float rate) {
  const std::vector<double> tops = Tops(profile, ground, rate, 0.9f, 10);
  EXPECT_GE(tops.size(), 10u);
  double most = 0, exact = 2;
  for (std::size_t k = 0; k < std::min<std::size_t>(10, tops.size()); ++k) {
    exact *= 0.9 * 0.9;
    most = std::max(most, std::abs(tops[k] / exact - 1));
  }
  return most;
}

TEST(TunedDropTest, EachBounceKeepsTheSquareOfTheElasticity) {
  for (const eGround ground : {eGround::Segment, eGround::Point, eGround::Circle, eGround::Bowl})
    for (const float rate : {60.0f, 120.0f, 240.0f}) {
      SCOPED_TRACE(testing::Message() << "ground " << static_cast<int>(ground) << ", " << rate << " Hz");
      EXPECT_LE(DecayError(eProfile::Tuned, ground, rate), 0.02);
      EXPECT_GT(DecayError(eProfile::Shipped, ground, rate), 0.1); // the control
    }
}

} // namespace
} // namespace Shapes::Tests
