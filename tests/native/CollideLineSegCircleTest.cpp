// SPDX-License-Identifier: MIT
#include "KernelTesting.h"

#include <Shapes/Shapes.h>

namespace Shapes::Native {
namespace {

CLineSeg Seg(const Vector2& p0, const Vector2& p1, eSides sides = eSides::Both) {
  CLineSegDesc desc(p0, p1);
  desc.m_eSides = sides;
  return CLineSeg(desc);
}

TEST(CollideLineSegCircle, MeetsBothSidesOfASegment) {
  const CLineSeg seg = Seg({-1.0f, 0.0f}, {1.0f, 0.0f});
  CHit hit;
  for (const float side : {1.0f, -1.0f}) {
    ASSERT_TRUE(CollideLineSegCircle(seg, Ball({0.25f, side * 0.4f}, 0.5f), hit));
    EXPECT_EQ(hit.m_vPOI, Vector2(0.25f, 0.0f));
    EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, side));
    EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
  }
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({0.25f, 0.5f}, 0.5f), hit)); // touching
}

TEST(CollideLineSegCircle, EndsAreOpen) {
  const CLineSeg seg = Seg({0.0f, 0.0f}, {1.0f, 0.0f});
  CHit hit;
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({-0.3f, 0.1f}, 0.5f), hit));
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({1.001f, 0.1f}, 0.5f), hit));
  EXPECT_TRUE(CollideLineSegCircle(seg, Ball({0.0f, 0.1f}, 0.5f), hit)); // exactly above an end is above it
  EXPECT_TRUE(CollideLineSegCircle(seg, Ball({1.0f, 0.1f}, 0.5f), hit));
}

TEST(CollideLineSegCircle, OneWithoutLengthIsAPoint) {
  const CLineSeg seg = Seg({1.0f, 1.0f}, {1.0f, 1.0f});
  CHit hit, point;
  for (const Vector2& p :
       {Vector2(1.0f, 1.4f), Vector2(0.6f, 1.0f), Vector2(1.2f, 0.8f), Vector2(1.0f, 1.5f)}) {
    const bool expected = CollidePt({1.0f, 1.0f}, Ball(p, 0.5f), point);
    ASSERT_EQ(CollideLineSegCircle(seg, Ball(p, 0.5f), hit), expected) << p.transpose();
    if (!expected) continue;
    EXPECT_EQ(hit.m_vNorm, point.m_vNorm);
    EXPECT_EQ(hit.m_fSetback, point.m_fSetback);
  }
}

TEST(CollideLineSegCircle, OneWhoseLengthSquaredUnderflowsGivesNoNan) {
  CHit hit;
  ASSERT_TRUE(
      CollideLineSegCircle(Seg({0.0f, 0.0f}, {1e-30f, 0.0f}), Ball({0.0f, 0.4f}, 0.5f, {0.0f, -1.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.1, 4 * g_fUlp);
}

TEST(CollideLineSegCircle, ACentreOnTheSegmentGoesBackToTheSideItCameFrom) {
  const CLineSeg seg = Seg({-1.0f, 0.0f}, {1.0f, 0.0f});
  CHit hit;
  ASSERT_TRUE(CollideLineSegCircle(seg, {{0.0f, 0.0f}, {-1.0f, 1.0f}, {1.0f, -1.0f}, 0.5f}, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f)); // by where it was
  ASSERT_TRUE(CollideLineSegCircle(seg, {{0.0f, 0.0f}, {-1.0f, -1.0f}, {1.0f, 1.0f}, 0.5f}, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, -1.0f));
  ASSERT_TRUE(CollideLineSegCircle(seg, Ball({0.0f, 0.0f}, 0.5f, {1.0f, -1.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f)); // by where it goes
  ASSERT_TRUE(CollideLineSegCircle(seg, Ball({0.0f, 0.0f}, 0.5f, {1.0f, 1.0f}), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, -1.0f));
  ASSERT_TRUE(CollideLineSegCircle(seg, Ball({0.0f, 0.0f}, 0.5f), hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f)); // at rest: the front
}

TEST(CollideLineSegCircle, OneSidedSegmentsLetTheOtherSideThrough) {
  const Vector2 a(-1.0f, 0.0f), b(1.0f, 0.0f);
  const CBall falling{{0.0f, 0.1f}, {0.0f, 0.6f}, {0.0f, -5.0f}, 0.5f};
  const CBall rising{{0.0f, -0.1f}, {0.0f, -0.6f}, {0.0f, 5.0f}, 0.5f};
  CHit hit;
  EXPECT_TRUE(CollideLineSegCircle(Seg(a, b, eSides::Front), falling, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_FALSE(CollideLineSegCircle(Seg(a, b, eSides::Front), rising, hit));
  EXPECT_TRUE(CollideLineSegCircle(Seg(a, b, eSides::Back), rising, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, -1.0f));
  EXPECT_FALSE(CollideLineSegCircle(Seg(a, b, eSides::Back), falling, hit));
  // Giving the ends the other way round does not turn the front downward: they are put in order.
  EXPECT_TRUE(CollideLineSegCircle(Seg(b, a, eSides::Front), falling, hit));
  EXPECT_FALSE(CollideLineSegCircle(Seg(b, a, eSides::Front), rising, hit));
}

TEST(CollideLineSegCircle, AOneSidedSegmentPushesBackAcrossIfTheBallCameFromItsSolidSide) {
  const CBall past{{0.0f, -0.2f}, {0.0f, 0.6f}, {0.0f, -48.0f}, 0.5f};
  CHit hit;
  ASSERT_TRUE(CollideLineSegCircle(Seg({-1.0f, 0.0f}, {1.0f, 0.0f}, eSides::Front), past, hit));
  EXPECT_EQ(hit.m_vNorm, Vector2(0.0f, 1.0f));
  EXPECT_NEAR(hit.m_fSetback, 0.7, 4 * g_fUlp);
  // On the way through from the open side it is let go until it is out.
  const CBall through{{0.0f, 0.2f}, {0.0f, -0.1f}, {0.0f, 5.0f}, 0.5f};
  EXPECT_FALSE(CollideLineSegCircle(Seg({-1.0f, 0.0f}, {1.0f, 0.0f}, eSides::Front), through, hit));
}

TEST(CollideLineSegCircle, NanInPositionOrRadiusIsNoContact) {
  const CWithoutTraps onPurpose;
  const CLineSeg seg = Seg({-1.0f, 0.0f}, {1.0f, 0.0f});
  CHit hit;
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({g_fNan, 0.1f}, 0.5f), hit));
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({0.0f, g_fNan}, 0.5f), hit));
  EXPECT_FALSE(CollideLineSegCircle(seg, Ball({0.0f, 0.1f}, g_fNan), hit));
}

TEST(CollideLineSegCircle, AgreesWithTheDistanceAndSetsBackToTouching) {
  CRandom random(202);
  int hits = 0;
  for (int i = 0; i < 50000; ++i) {
    const Vector2 p0 = random.Vector(-4, 8);
    const Vector2 p1 = p0 + random.Vector(-4, 6);
    const CLineSeg seg = Seg(p0, p1);
    const float r = random.Scale(-6, 4);
    const Vector2 on = p0 + random.Uniform(-0.2f, 1.2f) * (p1 - p0);
    const Vector2 p = on + r * random.Uniform(-1.5f, 1.5f) * seg.GetNormal();
    const CBall ball = Ball(p, r, random.Direction());
    const Vector2d t = (Wide(seg.GetEndPt1()) - Wide(seg.GetEndPt0())).normalized();
    const double along0 = (Wide(ball.m_vPos) - Wide(seg.GetEndPt0())).dot(t);
    const double along1 = (Wide(ball.m_vPos) - Wide(seg.GetEndPt1())).dot(t);
    const Vector2d u = Wide(ball.m_vPos) - Wide(seg.GetEndPt0());
    const double d = std::abs(t.x() * u.y() - t.y() * u.x());
    const double bound = 8 * g_fUlp * (Wide(ball.m_vPos).norm() + u.norm() + static_cast<double>(r));
    const double gap = std::max({d - static_cast<double>(r), -along0, along1});
    CHit hit;
    const bool got = CollideLineSegCircle(seg, ball, hit);
    if (std::abs(gap) > bound) {
      ASSERT_EQ(got, gap < 0.0) << "seed " << random.GetSeed() << " trial " << i;
    }
    if (!got) continue;
    ++hits;
    ASSERT_NEAR(Wide(hit.m_vNorm).norm(), 1.0, 2 * g_fUlp) << "seed " << random.GetSeed();
    ASSERT_GE(hit.m_fSetback, 0.0f);
    ASSERT_NEAR(hit.m_fSetback, static_cast<double>(r) - d, bound);
    ASSERT_LE((Wide(ball.m_vPos) - Wide(hit.m_vPOI)).norm(), d + bound) << "the closest point";
    CBall back = ball;
    back.m_vPos += hit.m_fSetback * hit.m_vNorm;
    if (CollideLineSegCircle(seg, back, hit)) {
      ASSERT_LE(hit.m_fSetback, bound) << "seed " << random.GetSeed();
    }
  }
  EXPECT_GT(hits, 10000);
}

TEST(CollideLineSegCircle, MirrorsAndSwappedEndsGiveTheSame) {
  CRandom random(203);
  for (int i = 0; i < 5000; ++i) {
    const Vector2 p0 = random.InSquare(2.0f), p1 = random.InSquare(2.0f), q = random.InSquare(2.0f);
    const CBall ball = Ball(q, 0.5f, random.Direction());
    CHit a, b, m;
    const bool got = CollideLineSegCircle(Seg(p0, p1), ball, a);
    ASSERT_EQ(CollideLineSegCircle(Seg(p1, p0), ball, b), got) << "seed " << random.GetSeed();
    const auto mirror = [](const Vector2& v) { return Vector2(v.x(), -v.y()); };
    CBall mirrored = Ball(mirror(q), 0.5f, mirror(ball.m_vVel));
    ASSERT_EQ(CollideLineSegCircle(Seg(mirror(p0), mirror(p1)), mirrored, m), got);
    if (!got) continue;
    ASSERT_EQ(a.m_vNorm, b.m_vNorm);
    ASSERT_EQ(a.m_fSetback, b.m_fSetback);
    ASSERT_EQ(m.m_vNorm, mirror(a.m_vNorm));
    ASSERT_EQ(m.m_fSetback, a.m_fSetback);
  }
}

// A ball that comes down on the end of a segment, with and without a guard point, whichever was added first.
TEST(GuardPoint, IsMetBeforeTheSegmentItGuards) {
  const auto bounce = [](bool guarded, bool segmentFirst) {
    CWorldDesc desc;
    desc.m_fTimeStep = 0.01f;
    desc.m_cEffects = g_cApproximate;
    const std::unique_ptr<CWorld> pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
    const CLineSegDesc seg({0.0f, 0.0f}, {1.0f, 0.0f});
    if (segmentFirst) pWorld->Add(seg);
    if (guarded) pWorld->Add(CPointDesc({0.0f, 0.0f}));
    if (!segmentFirst) pWorld->Add(seg);
    // After the step the centre is at (.05, .2): over the segment, but the end is nearly as close.
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-0.05f, 0.3f}, 0.25f, {10.0f, -10.0f}));
    pWorld->Step();
    return pWorld->GetVel(ball);
  };
  const Vector2 guarded = bounce(true, false);
  EXPECT_EQ(bounce(true, true), guarded);
  EXPECT_LE((bounce(false, false) - Vector2(10.0f, 10.0f)).norm(), 32 * g_fUlp * 10); // the segment alone
  // Off the point first, about n = (.05, .2) / |..|: v - 2 (v.n) n with v.n = -7.27607.
  EXPECT_LE((guarded - Vector2(10.0f + 3.529412f, -10.0f + 14.117647f)).norm(), 64 * g_fUlp * 10);
}

} // namespace
} // namespace Shapes::Native
