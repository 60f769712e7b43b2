// SPDX-License-Identifier: MIT
#include <Shapes/Point.h>

#include "../Numbers.h"
#include "../Random.h"

#include <gtest/gtest.h>

namespace Shapes {
namespace {

using Tests::CRandom;

TEST(Point, IsWhatItsDescriptorSays) {
  const CPointDesc empty;
  EXPECT_EQ(empty.m_eShapeType, eShape::Point);
  EXPECT_EQ(empty.m_vPos, Vector2::Zero());
  EXPECT_EQ(empty.m_fElasticity, 1.0f);

  const CPoint point(CPointDesc({2.0f, 3.0f}, 0.5f));
  EXPECT_EQ(point.GetShapeType(), eShape::Point);
  EXPECT_EQ(point.GetMotionType(), eMotion::Static);
  EXPECT_EQ(point.GetPos(), Vector2(2.0f, 3.0f));
  EXPECT_EQ(point.GetElasticity(), 0.5f);
}

TEST(Point, BoxIsThePoint) {
  CPoint point(CPointDesc({2.0f, 3.0f}));
  EXPECT_EQ(point.GetAABB().GetTopLeft(), Vector2(2.0f, 3.0f));
  EXPECT_EQ(point.GetAABB().GetBottomRt(), Vector2(2.0f, 3.0f));
  point.SetPos({-1.0f, 7.0f});
  EXPECT_EQ(point.GetAABB().GetTopLeft(), Vector2(-1.0f, 7.0f));
  EXPECT_EQ(point.GetAABB().GetBottomRt(), Vector2(-1.0f, 7.0f));
}

TEST(KinematicPoint, TurnsFromItsPoseAtConstruction) {
  CKinematicPoint point(CPointDesc({3.0f, 1.0f}));
  EXPECT_EQ(point.GetMotionType(), eMotion::Kinematic);
  for (int i = 0; i < 3; ++i) { // the same every time: not cumulative
    point.Rotate({1.0f, 1.0f}, g_fPi / 2);
    EXPECT_LE((point.GetPos() - Vector2(1.0f, 3.0f)).norm(), 3 * g_fUlp * 4);
    EXPECT_EQ(point.GetAABB().GetTopLeft(), point.GetPos());
  }
}

TEST(KinematicPoint, ResetIsBitForBitAfterAnyRotations) {
  CRandom random(41);
  for (int i = 0; i < 200; ++i) {
    const Vector2 p = random.InSquare(100.0f);
    CKinematicPoint point{CPointDesc(p)};
    for (int k = 0; k < 20; ++k) {
      const Vector2 centre = random.InSquare(50.0f);
      point.Rotate(centre, random.Uniform(-20.0f, 20.0f));
    }
    point.Reset();
    EXPECT_EQ(point.GetPos(), p) << "seed " << random.GetSeed();
    EXPECT_EQ(point.GetOrientation(), 0.0f);
    EXPECT_EQ(point.GetAABB().GetTopLeft(), p);
  }
}

TEST(Point, AStaticPointIsNotTurned) {
  CPoint point(CPointDesc({3.0f, 1.0f}));
  point.Rotate({0.0f, 0.0f}, 1.0f);
  point.Reset();
  EXPECT_EQ(point.GetPos(), Vector2(3.0f, 1.0f));
  EXPECT_EQ(point.GetOrientation(), 0.0f);
}

} // namespace
} // namespace Shapes
