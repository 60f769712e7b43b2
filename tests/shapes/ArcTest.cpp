// SPDX-License-Identifier: MIT
// Arcs: their ends, full circles, and which points are in their sector.
#include <Shapes/Arc.h>

#include "../Testing.h"

namespace Shapes {
namespace {

CArc Arc(const Vector2& p, float r, float a0, float a1) { return CArc(CArcDesc(p, r, a0, a1)); }
float Degrees(float a) { return a * g_fPi / 180.0f; }

TEST(Arc, IsWhatItsDescriptorSays) {
  CArcDesc desc({1.0f, 2.0f}, 3.0f, 0.5f, 7.0f);
  desc.m_eSides = eSides::Front;
  const CArc arc(desc);
  EXPECT_EQ(arc.GetRadius(), 3.0f);
  EXPECT_EQ(arc.GetAngle0(), 0.5f);
  EXPECT_NEAR(desc.GetAngle1(), 7.0 - g_fPi2, g_fUlp);
  EXPECT_EQ(arc.GetSides(), eSides::Front);
}

TEST(Arc, EqualAnglesAreTheFullCircle) {
  for (const float a : {0.0f, 1.0f, 3.0f, 6.0f}) {
    const CArc arc = Arc({0.0f, 0.0f}, 1.0f, a, a);
    EXPECT_TRUE(arc.IsFullCircle());
    EXPECT_NEAR(arc.GetSpan(), g_fPi2, 4 * g_fUlp);
    EXPECT_EQ(arc.GetAngle1(), arc.GetAngle0());
    for (int k = 0; k < 360; ++k)
      EXPECT_TRUE(arc.PtInSector(AngleToVector(Degrees(static_cast<float>(k)))));
    EXPECT_EQ(arc.GetAABB().GetTopLeft(), Vector2(-1.0f, 1.0f));
    EXPECT_EQ(arc.GetAABB().GetBottomRt(), Vector2(1.0f, -1.0f));
  }
}

TEST(Arc, AnglesAWholeTurnApartAreTheFullCircle) {
  // Reduced one by one they would leave an arc of 1.7e-7: the float next to 2 pi is above it by that.
  EXPECT_GT(NormalizeAngle(g_fTwoPi), 1e-7f);
  for (const auto& [a0, a1] : {std::pair(0.0f, g_fTwoPi), std::pair(g_fTwoPi, 0.0f), std::pair(-g_fPi, g_fPi),
                               std::pair(1.0f, 1.0f + g_fTwoPi), std::pair(0.0f, -g_fTwoPi)})
    EXPECT_TRUE(Arc({0.0f, 0.0f}, 1.0f, a0, a1).IsFullCircle()) << a0 << " to " << a1;
  // A slit that is above the rounding of its angles stays one.
  EXPECT_FALSE(Arc({0.0f, 0.0f}, 1.0f, 1e-5f, g_fTwoPi - 1e-5f).IsFullCircle());
  EXPECT_FALSE(Arc({0.0f, 0.0f}, 1.0f, 0.0f, g_fTwoPi - 1e-5f).IsFullCircle());
}

TEST(Arc, ClosestPtOfTheCentreIsItsFirstEnd) {
  const CArc arc = Arc({0.0f, 0.0f}, 2.0f, Degrees(45), Degrees(135));
  EXPECT_EQ(arc.ClosestPt({0.0f, 0.0f}), arc.GetEndPt0());
}

TEST(Arc, SetPosTakesTheEndsAlong) {
  CArc arc = Arc({0.0f, 0.0f}, 2.0f, 0.0f, Degrees(90));
  arc.SetPos({8.0f, 16.0f});
  EXPECT_EQ(arc.GetEndPt0(), Vector2(10.0f, 16.0f));
  EXPECT_LE((arc.GetEndPt1() - Vector2(8.0f, 18.0f)).norm(), 4 * g_fUlp * 20);
  EXPECT_EQ(arc.GetAABB().GetBottomRt().x(), 10.0f);
  EXPECT_TRUE(arc.PtInSector({9.0f, 17.0f}));
  EXPECT_FALSE(arc.PtInSector({7.0f, 15.0f}));
}

TEST(ArcSector, IsBetweenItsEnds) {
  struct CRow {
    CArc m_cArc;
    std::vector<Vector2> m_stdInside, m_stdOutside;
  };
  const float quarter = g_fPi / 4, next = std::nextafter(quarter, 1.0f);
  const CRow rows[] = {
      // Both ends round to the same float, or the span is below the rounding of a cross product.
      {Arc({1000, 1000}, 1, 0, 1e-5f), {{1001, 1000}}, {{999, 1000}, {998, 1000}}},
      {Arc({0, 0}, 1, quarter, next), {{0, 0}}, {-AngleToVector(quarter)}},
      {Arc({0, 0}, 1, 0, 1e-7f), {{1.09f, 0}}, {{-1.09f, 0}, {0, 1}}},
      // A slit.
      {Arc({0, 0}, 1, 1e-3f, g_fTwoPi - 1e-3f), {{-1, 0}, {1, 0.002f}, {1, -0.002f}, {0, 0}}, {{1, 0}}},
      // Across the angle 0.
      {Arc({0, 0}, 1, Degrees(350), Degrees(10)), {{2, 0}, {2, 1e-9f}, {2, -1e-9f}}, {{-2, 0}, {0, 2}}}};
  for (const auto& [arc, inside, outside] : rows) {
    SCOPED_TRACE(testing::Message() << arc.GetAngle0() << " to " << arc.GetAngle1());
    EXPECT_FALSE(arc.IsFullCircle());
    for (const Vector2& p : inside)
      EXPECT_TRUE(arc.PtInSector(p)) << p.transpose();
    for (const Vector2& p : outside)
      EXPECT_FALSE(arc.PtInSector(p)) << p.transpose();
  }
  EXPECT_LE(rows[0].m_cArc.GetAABB().GetWidth(), 1e-4f);
}

} // namespace
} // namespace Shapes
