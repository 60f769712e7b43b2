// SPDX-License-Identifier: MIT
// Questions to a world: against a look at every shape by small steps, and with the same bits on every engine.
#include "Backends.h"

namespace Shapes {
namespace {

// Some of every kind in a square from -4 to 4, two-sided, after a few steps.
class CCrowd {
public:
  CCrowd(const CBackend& backend, std::uint64_t seed) : m_cRandom(seed) {
    m_pWorld = backend.MakeWorld(CWorldDesc());
    for (std::uint32_t i = 0; i < 40; ++i) {
      const Vector2 p = m_cRandom.InSquare(4);
      const float r = m_cRandom.Uniform(0.1f, 1);
      if (i % 5 == 4)
        Add(CDynamicCircleDesc(p, r, m_cRandom.Direction()));
      else
        WithAnyShape(m_cRandom, i % 5, p, 1, [this](const auto& desc) { Add(desc); });
    }
    Steps(*m_pWorld, 5);
  }

  CRandom m_cRandom;
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdIds; // solid
  CFilter m_cFilter{1, 1};        // that of those that are asked for

private:
  // One in eight is a sensor, one in eight of another group, one in eight turned off.
  template <class TDesc>
  void Add(TDesc desc) {
    const auto kind = m_cRandom.Below(8);
    desc.m_bIsSensor = kind == 0;
    if (kind == 1) desc.m_cFilter = {2, 2};
    const CShapeId id = m_pWorld->Add(desc);
    if (kind == 2) m_pWorld->SetCanCollide(id, false);
    if (kind > 2) m_stdIds.push_back(id);
  }
};

class CQuestionContract : public CEveryBackend {
protected:
  /// Asks 8 crowds n times each.
  void Ask(int n, const std::function<void(const CWorld&, CRandom&, const CCrowd&)>& ask) const {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      CCrowd crowd(Backend(), seed);
      for (int i = 0; i < n; ++i)
        ask(*crowd.m_pWorld, crowd.m_cRandom, crowd);
    }
  }
  std::unique_ptr<CWorld> m_pWorld = Backend().MakeWorld(CWorldDesc());
};
SHAPES_ON_EVERY_BACKEND(CQuestionContract);

TEST_P(CQuestionContract, TheClosestIsTheClosestOfAll) {
  Ask(100, [&](const CWorld& world, CRandom& random, const CCrowd& crowd) {
    const Vector2 p = random.InSquare(6);
    float least = g_fInf;
    for (const CShapeId id : crowd.m_stdIds)
      least = std::min(least, GetDistance(world, id, p));
    const auto hit = world.FindClosest(p, g_fInf, crowd.m_cFilter);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->m_fDistance, least, 1e-5f); // ClosestPt of float: 10 ulp of 8
    EXPECT_NEAR(GetDistance(world, hit->m_cShape, p), least, 1e-5f);
    EXPECT_NEAR(GetDistance(world, hit->m_cShape, hit->m_vPOI), 0, 1e-5f);
    EXPECT_NEAR((hit->m_vPOI + hit->m_fDistance * hit->m_vNorm - p).norm(), 0, 1e-5f);
    const auto within = world.FindClosest(p, 0.99f * std::max(least, 0.0f), crowd.m_cFilter);
    EXPECT_EQ(within.has_value(), least < 0);
  });
}

TEST_P(CQuestionContract, ACircleOverlapsWhatIsCloserThanItsRadius) {
  Ask(50, [&](const CWorld& world, CRandom& random, const CCrowd& crowd) {
    const Vector2 p = random.InSquare(5);
    const float r =
        random.Below(2) == 0 ? random.Uniform(0, 0.1f) : random.Uniform(0, 4); // also around rings
    const auto found = world.FindInCircle(p, r, crowd.m_cFilter);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (const CShapeId id : crowd.m_stdIds) {
      const float gap = GetDistance(world, id, p) - r;
      if (std::abs(gap) < 1e-5f) continue;
      EXPECT_EQ(std::binary_search(found.begin(), found.end(), id), gap < 0);
    }
    EXPECT_TRUE(std::includes(crowd.m_stdIds.begin(), crowd.m_stdIds.end(), found.begin(), found.end()));
  });
}

// Places all over a shape or a ball.
std::vector<Vector2> PointsOf(const CWorld& world, CShapeId id) {
  constexpr int n = 400;
  std::vector<Vector2> points;
  const Vector2 c = world.GetPos(id);
  const auto add = [&](float r, float from, float span) {
    for (int k = 0; k <= n; ++k)
      points.push_back(c + r * AngleToVector(from + span * static_cast<float>(k) / n));
  };
  if (world.GetMotionType(id) == eMotion::Dynamic) {
    for (int k = 0; k <= 20; ++k)
      add(world.GetRadius(id) * static_cast<float>(k) / 20.0f, 0, g_fTwoPi);
    return points;
  }
  const CShape& shape = world.GetShape(id);
  if (shape.GetShapeType() == eShape::LineSeg) {
    const auto& seg = static_cast<const CLineSeg&>(shape);
    for (int k = 0; k <= n; ++k)
      points.push_back(seg.GetEndPt0() + static_cast<float>(k) / n * (seg.GetEndPt1() - seg.GetEndPt0()));
  } else if (shape.GetShapeType() == eShape::Circle) {
    add(static_cast<const CCircle&>(shape).GetRadius(), 0, g_fTwoPi);
  } else if (shape.GetShapeType() == eShape::Arc) {
    const auto& arc = static_cast<const CArc&>(shape);
    add(arc.GetRadius(), arc.GetAngle0(), arc.GetSpan());
  } else {
    points.push_back(c);
  }
  return points;
}

// Of those places those are .016 apart at most; a ball has them at every 20th of its radius.
TEST_P(CQuestionContract, ABoxHasWhatHasAPointInIt) {
  int in = 0;
  Ask(20, [&](const CWorld& world, CRandom& random, const CCrowd& crowd) {
    const Vector2 p = random.InSquare(4), q = p + random.InSquare(1);
    const CAabb2D box(p, q);
    const Vector2 wide(0.06f, -0.06f), &a = box.GetTopLeft(), &b = box.GetBottomRt();
    const CAabb2D around(a - wide, b + wide);
    const auto found = world.FindInBox(box, crowd.m_cFilter);
    EXPECT_TRUE(std::includes(crowd.m_stdIds.begin(), crowd.m_stdIds.end(), found.begin(), found.end()));
    for (const CShapeId id : crowd.m_stdIds) {
      const auto points = PointsOf(world, id);
      const auto areIn = [&](const CAabb2D& where) {
        return std::any_of(points.begin(), points.end(), [&](const Vector2& x) { return where && x; });
      };
      const bool isFound = std::binary_search(found.begin(), found.end(), id);
      EXPECT_TRUE(isFound || !areIn(box) || !areIn(CAabb2D(a + 1e-4f * wide, b - 1e-4f * wide)));
      EXPECT_TRUE(!isFound || areIn(around));
      in += isFound;
    }
  });
  EXPECT_GT(in, 40);
}

// Of a circle that goes on its way by small steps: until it meets something nothing is closer than its
// radius.
TEST_P(CQuestionContract, ACastMeetsWhatComesFirst) {
  int met = 0;
  Ask(40, [&](const CWorld& world, CRandom& random, const CCrowd& crowd) {
    const Vector2 from = random.InSquare(5), to = random.InSquare(5);
    const float r = random.Coin() ? 0.0f : random.Uniform(0, 0.09f);
    const auto all = world.CastAll(from, to, r, crowd.m_cFilter);
    const auto first = world.Cast(from, to, r, crowd.m_cFilter);
    ASSERT_EQ(first.has_value(), !all.empty());
    std::set<CShapeId> once;
    for (const CCastHit& hit : all)
      EXPECT_TRUE(once.insert(hit.m_cShape).second);
    for (std::size_t k = 1; k < all.size(); ++k)
      EXPECT_LE(all[k - 1].m_fShare, all[k].m_fShare);
    if (first) {
      EXPECT_EQ(first->m_cShape, all[0].m_cShape);
      EXPECT_EQ(first->m_fShare, all[0].m_fShare);
    }
    // A circle that begins in a shape may leave it; and a shape that is grazed counts as one likes.
    if (!world.FindInCircle(from, r + 1e-4f, crowd.m_cFilter).empty()) return;
    if (first) {
      const Vector2 at = from + first->m_fShare * (to - from);
      EXPECT_NEAR(GetDistance(world, first->m_cShape, at), r, 2e-5f);
      EXPECT_NEAR((at - r * first->m_vNorm - first->m_vPOI).norm(), 0, 2e-5f);
      EXPECT_LT(first->m_vNorm.dot(to - from), 1e-4f);
    }
    const float end = first ? first->m_fShare : 1.0f;
    for (const CShapeId id : crowd.m_stdIds)
      for (int k = 0; k <= 200; ++k) {
        const Vector2 at = from + end * static_cast<float>(k) / 200.0f * (to - from);
        EXPECT_GT(GetDistance(world, id, at) - r, -1e-4f);
      }
    met += first.has_value();
  });
  EXPECT_GT(met, 100);
}

TEST_P(CQuestionContract, EveryEngineHasTheSameBits) {
  const auto ask = [](const CBackend& backend) {
    const auto pWorld = backend.MakeWorld(CWorldDesc());
    CRandom random(7);
    for (int i = 0; i < 30; ++i)
      pWorld->Add(CArcDesc{random.InSquare(3), 0.7f, random.Uniform(0, 6), random.Uniform(0, 6)});
    std::vector<float> answers;
    for (int i = 0; i < 100; ++i) {
      const Vector2 from = random.InSquare(3), to = random.InSquare(3);
      const auto hit = pWorld->Cast(from, to, 0.05f);
      const auto closest = pWorld->FindClosest(random.InSquare(3));
      answers.insert(answers.end(), {hit ? hit->m_fShare : -1.0f, closest->m_vPOI.x(), closest->m_fDistance});
    }
    return answers;
  };
  EXPECT_EQ(ask(Backend()), ask(GetDefaultBackend()));
}

// The next question sees each change.
TEST_P(CQuestionContract, TheAnswersAreThoseOfTheWorldAsItIsNow) {
  const auto hits = [&] { return m_pWorld->CastAll({-5, 0}, {5, 0}).size(); };
  EXPECT_EQ(hits(), 0u);
  const CShapeId id = m_pWorld->Add(Turning(CLineSegDesc({0, -1}, {0, 1})));
  EXPECT_EQ(hits(), 1u);
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({2, 0}, 0.1f, {0, 30}));
  EXPECT_EQ(hits(), 2u);
  const CSavedState saved = m_pWorld->SaveState();
  m_pWorld->Step();
  EXPECT_EQ(hits(), 1u);
  m_pWorld->SetPos(id, {0, 3});
  EXPECT_EQ(hits(), 0u);
  m_pWorld->Reset(id);
  EXPECT_EQ(hits(), 1u);
  m_pWorld->SetCanCollide(id, false);
  EXPECT_EQ(hits(), 0u);
  m_pWorld->SetCanCollide(id, true);
  m_pWorld->SetSensor(id, true);
  EXPECT_EQ(hits(), 0u);
  m_pWorld->SetSensor(id, false);
  m_pWorld->SetFilter(id, {2, 2});
  EXPECT_EQ(hits(), 0u);
  EXPECT_EQ(m_pWorld->CastAll({-5, 0}, {5, 0}, 0, {2, 2}).size(), 1u);
  m_pWorld->SetFilter(id, {});
  m_pWorld->Remove(id);
  EXPECT_EQ(hits(), 0u);
  m_pWorld->SetPos(ball, {2, 0.05f});
  EXPECT_EQ(hits(), 1u);
  m_pWorld->LoadState(saved);
  EXPECT_EQ(hits(), 2u);
}

TEST_P(CQuestionContract, OneSidedShapesLetThroughAndRingsAreMetFromInside) {
  m_pWorld->Add(Sided(CLineSegDesc({-1, 0}, {1, 0}), eSides::Front)); // above
  EXPECT_TRUE(m_pWorld->Cast({0, 1}, {0, -1}));
  EXPECT_FALSE(m_pWorld->Cast({0, -1}, {0, 1}));
  EXPECT_EQ(m_pWorld->FindInCircle({0, -0.1f}, 0.2f).size(), 1u);
  const CShapeId ring = m_pWorld->Add(CCircleDesc({5, 5}, 1));
  const auto hit = m_pWorld->Cast({5, 5}, {7, 5}, 0.25f);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->m_cShape, ring);
  EXPECT_NEAR(hit->m_fShare, 0.375f, 1e-6f);
  EXPECT_NEAR((hit->m_vPOI - Vector2(6, 5)).norm(), 0, 1e-6f);
  EXPECT_NEAR((hit->m_vNorm - Vector2(-1, 0)).norm(), 0, 1e-6f);
  EXPECT_TRUE(m_pWorld->FindInCircle({5, 5}, 0.5f).empty());
  EXPECT_TRUE(m_pWorld->FindInBox(CAabb2D({4.5f, 5.5f}, {5.5f, 4.5f})).empty());
}

TEST_P(CQuestionContract, WhatIsNotFiniteIsRefused) {
  EXPECT_THROW(m_pWorld->Cast({g_fNan, 0}, {1, 0}), std::invalid_argument);
  EXPECT_THROW(m_pWorld->CastAll({0, 0}, {g_fInf, 0}), std::invalid_argument);
  EXPECT_THROW(m_pWorld->Cast({0, 0}, {1, 0}, -1), std::invalid_argument);
  EXPECT_THROW(m_pWorld->FindClosest({0, g_fNan}), std::invalid_argument);
  EXPECT_THROW(m_pWorld->FindClosest({0, 0}, -1), std::invalid_argument);
  EXPECT_THROW(m_pWorld->FindInCircle({0, 0}, g_fInf), std::invalid_argument);
  EXPECT_THROW(m_pWorld->FindInBox(CAabb2D()), std::invalid_argument); // the empty one
  EXPECT_FALSE(m_pWorld->FindClosest({0, 0}));
}

} // namespace
} // namespace Shapes
