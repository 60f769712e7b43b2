// SPDX-License-Identifier: MIT
// The exact reference against published collision counts, conservation laws and cases with known answers.
#include "Random.h"
#include "ReferenceTesting.h"

#include <stdexcept>

namespace Shapes::Compare::Tests {
namespace {

using Shapes::Tests::CRandom;

TEST(Reference, ResponseKeepsTheTangentialPart) { // and reverses e of the normal one: e = 0, 1, 2, 1/4
  const struct {
    float m_fShape, m_fBall;
    CVec2d m_vAfter;
  } cases[] = {{0, 1, {3, 0}}, {1, 1, {3, 4}}, {2, 1, {3, 8}}, {.5f, .5f, {3, 1}}};
  for (const auto& c : cases) {
    CExact reference =
        Make({Wall({-10, 0}, {10, 0}, c.m_fShape)}, {CDynamicCircleDesc({0, 1}, .5f, {3, -4}, 1, c.m_fBall)});
    const CEvents events = Carry(reference, 0.25);
    ASSERT_EQ(events.size(), 1u);
    EXPECT_NEAR((reference.GetBall(0).m_vVel - c.m_vAfter).norm(), 0, 1e-15 * 5);
    EXPECT_NEAR(events[0].m_fTime, 0.125, 1e-15);
    EXPECT_EQ(events[0].m_ePart, ePart::Front);
    EXPECT_EQ(events[0].m_vVelBefore, CVec2d(3, -4));
    EXPECT_EQ(events[0].m_vVelAfter, reference.GetBall(0).m_vVel);
    EXPECT_NEAR((events[0].m_vCenter - CVec2d(.375, .5)).norm(), 0, 1e-15);
    EXPECT_NEAR((events[0].m_vPOI - CVec2d(.375, 0)).norm(), 0, 1e-15);
  }
}

TEST(Reference, MeetsWhatTheFiltersLetMeet) {
  for (const bool meet : {true, false}) {
    CLineSegDesc wall = Wall({1, -1}, {1, 1});
    CBalls balls = {CDynamicCircleDesc({-1, 0}, .1f, {4, 0}), CDynamicCircleDesc({0, 0}, .1f)};
    wall.m_cFilter = {1, 2};
    balls[0].m_cFilter = {4, 2};
    balls[1].m_cFilter = {2, meet ? CFilter().m_nMask : std::uint16_t{2}};
    CExact reference = Make({wall}, balls);
    // The first one gives its speed to the second one, which comes back with it.
    EXPECT_EQ(Carry(reference, 1).size(), meet ? 3u : 0u);
    EXPECT_NEAR(reference.GetBall(0).m_vVel.x(), meet ? -4 : 4, 1e-12);
  }
}

TEST(Reference, FrameOfTheSurface) { // whatever the place: v_n' = V + e (V - v_n), the tangential part kept
  CRandom random(58);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE("seed 58 trial " + std::to_string(i));
    const Vector2 p = random.InSquare(1.5f), v = random.InSquare(20);
    const float e = random.Uniform(0, 2), revs = random.Uniform(-10, 10);
    CExact reference =
        Make({Kinematic(Wall({0, 0}, {1, 0}, e), {0, 0}, revs)}, {CDynamicCircleDesc(p, .1f, v)});
    for (const CExactEvent<double>& event : Carry(reference, 1.0 / 60)) {
      ++hits;
      const CVec2d& n = event.m_vNorm;
      const double vn = event.m_vVelBefore.dot(n), V = event.m_vSurface.dot(n);
      EXPECT_NEAR(event.m_vVelAfter.dot(n), V + static_cast<double>(e) * (V - vn), 1e-12 * 200);
      EXPECT_NEAR(Cross(event.m_vVelAfter, n), Cross(event.m_vVelBefore, n), 1e-12 * 200);
    }
    const double turned =
        std::remainder(reference.GetOrientation(0) - 2 * std::numbers::pi * static_cast<double>(revs) / 60,
                       2 * std::numbers::pi);
    EXPECT_NEAR(turned, 0, 1e-14);
  }
  EXPECT_GT(hits, 20);
}

TEST(Reference, CorneredBallReverses) { // both orders
  for (const bool swapped : {false, true}) {
    CShapes walls = {Wall({0, 0}, {4, 0}), Wall({0, 0}, {0, 4})};
    if (swapped) std::swap(walls[0], walls[1]);
    CExact reference = Make(walls, {CDynamicCircleDesc({2, 2}, .5f, {-1, -1})});
    EXPECT_EQ(Carry(reference, 4).size(), 2u);
    EXPECT_NEAR((reference.GetBall(0).m_vVel - CVec2d(1, 1)).norm(), 0, 1e-12);
    EXPECT_NEAR((reference.GetBall(0).m_vPos - CVec2d(3, 3)).norm(), 0, 1e-12);
  }
}

// Where no direction leads away the normal is against the velocity: one that leaves must not be taken for one
// that comes.
TEST(Reference, CentreExactlyOnAShapeIsMetOnce) {
  const CAnyShapeDesc shapes[] = {
      CPointDesc({0, 0}),           CLineSegDesc({0, -1}, {0, 1}),
      CLineSegDesc({0, 0}, {0, 1}), CCircleDesc({-1, 0}, 1),
      CArcDesc({-1, 0}, 1, 0, 0),   CCircleDesc({0, 0}, .125f)}; // into which the ball does not fit
  for (const CAnyShapeDesc& shape : shapes)
    for (const float vx : {1.0f, -1.0f})
      for (const float r : {.25f, 0.f}) {
        SCOPED_TRACE(testing::Message() << "shape " << &shape - shapes << ", v = " << vx << ", r = " << r);
        if (r == 0 && &shape == &shapes[5]) continue; // it fits
        CExact reference = Make({shape}, {CDynamicCircleDesc({0, 0}, r, {vx, 0})});
        EXPECT_EQ(Carry(reference, .25).size(), 1u);
        EXPECT_EQ(reference.GetBall(0).m_vVel, CVec2d(-vx, 0));
      }
}

TEST(Reference, BallsAtOnePlaceMeetOnce) {
  for (const float r : {.25f, 0.f}) {
    CExact reference = Make({}, {CDynamicCircleDesc({0, 0}, r, {1, 0}), CDynamicCircleDesc({0, 0}, r)});
    EXPECT_EQ(Carry(reference, .25).size(), 1u);
    EXPECT_EQ(reference.GetBall(0).m_vVel, CVec2d(0, 0));
    EXPECT_EQ(reference.GetBall(1).m_vVel, CVec2d(1, 0));
  }
}

TEST(Reference, BallWithoutRadiusBounces) { // at the origin too, where nothing has a size
  for (const float y : {0.f, 1.f, -700.3f}) {
    CExact reference =
        Make({Wall({-1, y}, {1, y}), CPointDesc({2, y})},
             {CDynamicCircleDesc({0, y + 1}, 0, {0, -1}), CDynamicCircleDesc({2, y + 1}, 0, {0, -1})});
    EXPECT_EQ(Carry(reference, 1.25).size(), 2u) << y;
    for (const std::size_t i : {0u, 1u})
      EXPECT_EQ(reference.GetBall(i).m_vVel, CVec2d(0, 1)) << y;
  }
}

TEST(Reference, GuardAtAnEndGivesOneResponse) {
  CExact reference =
      Make({CPointDesc({0, 0}), Wall({0, 0}, {1, 0})}, {CDynamicCircleDesc({-.3f, 2}, .5f, {0, -1})});
  EXPECT_EQ(Carry(reference, 2).size(), 1u);
  EXPECT_NEAR((reference.GetBall(0).m_vVel - CVec2d(-.96, .28)).norm(), 0, 1e-7); // -.3 is rounded to float
}

TEST(Reference, JointIsNoObstacle) { // two collinear segments are one mirror
  CRandom random(76);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE("seed 76 trial " + std::to_string(i));
    const double x = 1e-3 * (random.Unit() - .5), vx = 10 * (random.Unit() - .5), vy = -.01 - random.Unit();
    CExact reference =
        MakeOne({Wall({-4, 0}, {0, 0}), Wall({0, 0}, {4, 0})}, .25f, {x + vx * .5 / vy, .75}, {vx, vy});
    Carry(reference, 1 / -vy);
    EXPECT_NEAR((reference.GetBall(0).m_vVel - CVec2d(vx, -vy)).norm(), 0, 1e-12);
  }
}

TEST(Reference, ASpeedBeyondDoublesIsRefused) {
  const auto carry = [](float e) {
    CExact exact = Make(Box(1, e), {CDynamicCircleDesc({.1f, 0}, .25f, {1, 0})});
    Carry(exact, 2);
    return exact.GetBall(0).m_vVel.norm();
  };
  EXPECT_NEAR(carry(1), 1, 1e-12);
  // A thousand times as fast after each impact, and so a thousand times as early.
  EXPECT_THROW(carry(1000), std::runtime_error);
}

} // namespace
} // namespace Shapes::Compare::Tests
