// SPDX-License-Identifier: MIT
// Boxes, polylines and capsules: of which segments, guards and circles they consist, and that no ball gets
// into them, on every engine and in every mode.
#include "Backends.h"

namespace Shapes {
namespace {

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

TEST(Capsule, ConsistsOfItsEndsAndTheirTangentsWhichAreAllAlike) {
  CLineSegDesc like = Sided(Turning(CLineSegDesc(), 1), eSides::Front);
  like.m_fElasticity = 0.5f;
  const auto parts = MakeCapsule({1, 1}, 0.5f, {4, 5}, 0.25f, like);
  ASSERT_EQ(parts.size(), 4u);
  const auto& end0 = std::get<CCircleDesc>(parts[0]);
  const auto& end1 = std::get<CCircleDesc>(parts[1]);
  EXPECT_EQ(end0.m_vPos, Vector2(1, 1));
  EXPECT_EQ(end0.m_fRadius, 0.5f);
  EXPECT_EQ(end1.m_vPos, Vector2(4, 5));
  EXPECT_EQ(end1.m_fRadius, 0.25f);
  for (const std::size_t i : {2u, 3u}) {
    const auto& side = std::get<CLineSegDesc>(parts[i]);
    EXPECT_EQ(side.m_eSides, eSides::Both);
    for (const CCircleDesc& end : {end0, end1}) { // it touches the ends
      const float distance = side.GetNormal().dot(end.m_vPos - side.GetEndPt0());
      EXPECT_NEAR(std::abs(distance), end.m_fRadius, 12 * g_fUlp * 10);
      EXPECT_EQ(distance > 0, i == 2); // the right one first
    }
  }
  for (const CAnyShapeDesc& any : parts) {
    const CShapeDesc& base = std::visit([](const auto& desc) -> const CShapeDesc& { return desc; }, any);
    EXPECT_EQ(base.m_fElasticity, 0.5f);
    EXPECT_EQ(base.m_eMotionType, eMotion::Kinematic);
    EXPECT_EQ(base.m_fRotSpeed, 1.0f);
    EXPECT_NE(MakeShape(any), nullptr);
  }
}

TEST(Capsule, WhatIsNoneIsRefused) {
  const auto message = [](const Vector2& p0, float r0, const Vector2& p1, float r1) {
    return MessageOf<std::invalid_argument>([&] { MakeCapsule(p0, r0, p1, r1); });
  };
  EXPECT_EQ(message({0, 0}, 1, {1, 0}, 0.25f), "");
  EXPECT_EQ(message({0, 0}, 1, {0.5f, 0}, 0.25f),
            "p1 is (0.5, 0): expected a point farther from p0 than the radii differ");
  EXPECT_EQ(message({3, 4}, 1, {3, 4}, 1),
            "p1 is (3, 4): expected a point farther from p0 than the radii differ");
  EXPECT_EQ(message({0, 0}, 1, {1, 0}, 1e19f), "r1 is 1e+19: expected a number above 0, up to 1e+18");
  EXPECT_TRUE(message({0, 0}, g_fInf, {1, 0}, 1).starts_with("r0 is inf: "));
  EXPECT_TRUE(message({1e19f, 0}, 1, {1, 0}, 1).starts_with("p0 is (1e+19, 0): "));
  EXPECT_TRUE(message({0, 0}, 0, {1, 0}, 1).starts_with("r0 is 0: "));
  EXPECT_TRUE(message({0, 0}, 1, {1, 0}, -1).starts_with("r1 is -1: "));
  EXPECT_TRUE(message({g_fNan, 0}, 1, {1, 0}, 1).starts_with("p0 is (nan, 0): "));
  EXPECT_TRUE(message({0, 0}, 1, {g_fInf, 0}, 1).starts_with("p1 is (inf, 0): "));
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
        const auto ball = pWorld->Add(CDynamicCircleDesc(Vector2(1.3f, 1.3f) + aside, 0.1f, {-1.5f, -1.5f}));
        bool isIn = false;
        for (int i = 0; i < 60; ++i) {
          pWorld->Step();
          isIn |= pWorld->GetPos(ball).cwiseAbs().maxCoeff() < 1;
        }
        lost[guarded] += isIn;
      }
  EXPECT_EQ(lost[true], 0);
  EXPECT_EQ(lost[false] > 0, !IsBox2D()); // the control: Box2D's ends are round
}

// How deep p is in the capsule of these ends, in double: the least distance to what bounds it, negative
// outside. A cone of radii that change evenly along the way from end to end.
double DepthIn(const CCircleDesc& end0, const CCircleDesc& end1, const Vector2& p) {
  const Eigen::Vector2d a = end0.m_vPos.cast<double>(), way = end1.m_vPos.cast<double>() - a;
  const double length = way.norm(), shrunk = static_cast<double>(end0.m_fRadius) - end1.m_fRadius;
  const Eigen::Vector2d x = way / length, q = p.cast<double>() - a;
  const double along = q.dot(x), aside = std::abs(q.x() * x.y() - q.y() * x.x());
  const double tilt = shrunk / length, root = std::sqrt(1 - tilt * tilt);
  const double foot = (along + aside * tilt / root) / length; // of the perpendicular on the side
  if (foot <= 0) return end0.m_fRadius - q.norm();
  if (foot >= 1) return end1.m_fRadius - (q - way).norm();
  return end0.m_fRadius - tilt * along - root * aside;
}

// Shots from around at a capsule that lies, and at one that turns. The control leaves its sides out.
TEST_P(CPolylineContract, NoBallGetsIntoACapsule) {
  for (const bool turns : {false, true})
    for (const bool whole : {true, false}) {
      int in = 0, hits = 0;
      for (const CEffectChoice& choice : {g_cApproximate, g_cContinuous})
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
          SCOPED_TRACE(testing::Message() << "seed " << seed << (turns ? ", turning" : ", lying"));
          CRandom random(seed);
          const auto pWorld = Make(choice);
          auto parts = MakeCapsule({-1, 0}, 0.4f, {1, 0}, 0.25f);
          if (!whole) parts.resize(2);
          const auto ids = pWorld->AddCompound(parts, {-1, 0}, turns ? 0.5f : 0.0f);
          const Vector2 from = 3 * AngleToVector(random.Uniform(0, 2 * g_fPi));
          const Vector2 to{random.Uniform(-1, 1), random.Uniform(-0.2f, 0.2f)};
          const CShapeId ball = pWorld->Add(CDynamicCircleDesc(from, 0.1f, 2 * Normalize(to - from)));
          bool isIn = false, isHit = false;
          for (int i = 0; i < 150; ++i) {
            pWorld->Step();
            isHit |= !pWorld->GetContacts().empty();
            CCircleDesc ends[] = {std::get<CCircleDesc>(parts[0]), std::get<CCircleDesc>(parts[1])};
            for (std::size_t end = 0; end < 2; ++end)
              ends[end].m_vPos = pWorld->GetPos(ids[end]);
            isIn |= DepthIn(ends[0], ends[1], pWorld->GetPos(ball)) > 0;
          }
          in += isIn;
          hits += isHit;
        }
      EXPECT_EQ(in > 0, !whole) << in;
      EXPECT_GT(hits, 60);
    }
}

} // namespace
} // namespace Shapes
