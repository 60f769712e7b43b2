// SPDX-License-Identifier: MIT
// Boxes and polylines: which segments and guards they are made of, and that no ball gets past a corner, on
// every engine and in every mode.
#include "Backends.h"

namespace Shapes {
namespace {

using Tests::CRandom;

std::size_t CountPoints(const std::vector<CAnyShapeDesc>& descs) {
  std::size_t n = 0;
  for (const CAnyShapeDesc& desc : descs)
    n += std::holds_alternative<CPointDesc>(desc);
  return n;
}

TEST(Polyline, EndsAndCornersAreGuardedAndSmoothJointsAreNot) {
  const Vector2 way[] = {{0, 0}, {1, 0}, {2, 0.001f}, {2, 0.001f}, {3, 1}, {3, 2}};
  const auto open = MakePolyline(way);
  EXPECT_EQ(open.size(), 4u + 4u); // (1, 0) is smooth
  EXPECT_EQ(CountPoints(open), 4u);
  EXPECT_EQ(CountPoints(MakePolyline(way, true)), 4u);
  EXPECT_EQ(MakePolyline(way, true).size(), 5u + 4u);
  const Vector2 loop[] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
  EXPECT_EQ(MakePolyline(loop, true).size(), 3u + 3u);
  EXPECT_EQ(MakePolyline(loop, true, Sensor(CLineSegDesc())).size(), 3u);
}

TEST(Polyline, AllAreAlikeAndTheirFrontIsLeftOfTheWay) {
  CLineSegDesc like = Sided(Turning(CLineSegDesc(), 1), eSides::Front);
  like.m_fElasticity = 0.5f;
  like.m_cFilter = {2, 3};
  for (const CAnyShapeDesc& any : MakeBox({5, 6}, {2, 1}, 0.3f, like)) {
    const CShapeDesc& base = std::visit([](const auto& desc) -> const CShapeDesc& { return desc; }, any);
    EXPECT_EQ(base.m_fElasticity, 0.5f);
    EXPECT_EQ(base.m_cFilter, like.m_cFilter);
    EXPECT_EQ(base.m_eMotionType, eMotion::Kinematic);
    EXPECT_EQ(base.m_fRotSpeed, 1.0f);
    const auto* pSeg = std::get_if<CLineSegDesc>(&any);
    if (pSeg == nullptr) continue;
    const Vector2 front = pSeg->m_eSides == eSides::Front ? pSeg->GetNormal() : Vector2(-pSeg->GetNormal());
    EXPECT_GT(front.dot(Vector2(5, 6) - pSeg->m_vPos), 0.4f); // inwards
  }
}

TEST(Polyline, WhatIsNoWayIsRefused) {
  const Vector2 one[] = {{1, 1}, {1, 1}}, bad[] = {{1, 1}, {g_fNan, 1}};
  EXPECT_THROW(MakePolyline(one), std::invalid_argument);
  EXPECT_THROW(MakePolyline({}), std::invalid_argument);
  EXPECT_THROW(MakePolyline(bad), std::invalid_argument);
  EXPECT_THROW(MakeBox({0, 0}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(MakeBox({0, 0}, {1, 1}, g_fInf), std::invalid_argument);
}

class CPolylineContract : public CEveryBackend {};
SHAPES_ON_EVERY_BACKEND(CPolylineContract);

// Slow balls that come straight at a corner along its diagonal, and a bit aside. Without the guards the
// approximate mode lets some in.
TEST_P(CPolylineContract, NoBallGetsIntoABoxPastItsCorners) {
  int lost[2] = {0, 0};
  for (const bool guarded : {true, false})
    for (const CEffectChoice& choice : {g_cApproximate, g_cContinuous})
      for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        CRandom random(seed);
        const auto pWorld = Make(choice);
        for (const CAnyShapeDesc& desc : MakeBox({0, 0}, {2, 2}))
          if (guarded || !std::holds_alternative<CPointDesc>(desc)) pWorld->Add(desc);
        const Vector2 aside = random.InSquare(0.02f);
        const CShapeId ball =
            pWorld->Add(CDynamicCircleDesc(Vector2(1.3f, 1.3f) + aside, 0.1f, {-1.5f, -1.5f}));
        bool isIn = false;
        for (int i = 0; i < 60; ++i) {
          pWorld->Step();
          isIn |= pWorld->GetPos(ball).cwiseAbs().maxCoeff() < 1;
        }
        lost[guarded] += isIn;
      }
  EXPECT_EQ(lost[true], 0);
  EXPECT_EQ(lost[false] > 0, IsNative()); // the control: Box2D's ends are round
}

} // namespace
} // namespace Shapes
