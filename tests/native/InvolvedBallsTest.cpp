// SPDX-License-Identifier: MIT
// The native world with Continuous takes up only balls that may meet something: none that does is left out,
// and what finds the shapes does not matter to what comes out.
#include "NativeTesting.h"

namespace Shapes {
namespace {

// After the first substeps a grid that knows what is clear is there; it must not change anything.
TEST(InvolvedBallsTest, ABallThatTurnsRoundBelowACeilingMeetsItInEveryStep) {
  const float g = 10.0f, up = 0.5f * g * g_fDt, top = 0.5f * up * up / g, r = 0.25f * top;
  for (const bool isAlone : {true, false}) {
    auto pWorld = MakeNative(g_cContinuous, g);
    // The ball would be back where it began at the end of the step.
    pWorld->Add(CLineSegDesc({-1, r + 0.9f * top}, {1, r + 0.9f * top}));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, r, {0, 0}, 1, 0));
    if (!isAlone) pWorld->Add(CDynamicCircleDesc({0, -50}, r));
    Vector2 first = Vector2::Zero();
    for (int i = 0; i < 3000; ++i) {
      pWorld->SetPos(ball, {0, 0});
      pWorld->SetVel(ball, {0, up});
      pWorld->Step();
      ASSERT_EQ(pWorld->GetContacts().size(), 1u) << i;
      if (i == 0) first = pWorld->GetPos(ball);
      ASSERT_EQ(pWorld->GetPos(ball), first) << i;
    }
  }
}

// A light ball that a heavy one hits goes farther than either would have gone.
TEST(InvolvedBallsTest, ABallThatIsHitMeetsOneInTheOpenInTheSameStep) {
  for (const float place : {8.0f, 80.0f}) { // the control is out of its way
    auto pWorld = MakeNative(g_cContinuous);
    pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f, {300, 0}, 1000));
    pWorld->Add(CDynamicCircleDesc({1, 0}, 0.1f, {0, 0}, 0.001f));
    const CShapeId inTheOpen = pWorld->Add(CDynamicCircleDesc({place, 0}, 0.1f));
    // Where there are few balls each looks at all of them.
    for (int i = 0; i < 100; ++i)
      pWorld->Add(CDynamicCircleDesc({static_cast<float>(i), 50}, 0.1f));
    pWorld->Step();
    EXPECT_EQ(pWorld->GetVel(inTheOpen).x() > 0.0f, place < 10.0f);
  }
}

// Balls that meet shapes only are moved one after the other.
TEST(InvolvedBallsTest, ContactsOfBallsThatMoveAloneAreToldInTheOrderOfTime) {
  const auto pWorld = MakeNative({{}, CEffects{eEffect::BallPairs}});
  pWorld->Add(CLineSegDesc({-10, 0}, {10, 0}));
  pWorld->Add(CLineSegDesc({-10, 1}, {10, 1}));
  // The first one meets the floor late, the second one both in between, the third one at the same time as it.
  for (const auto& [x, y, v] : {std::tuple(-5.0f, 0.95f, -60.0f), {0.0f, 0.2f, -90.0f}, {5.0f, 0.2f, -90.0f}})
    pWorld->Add(CDynamicCircleDesc({x, y}, 0.1f, {0, v}));
  pWorld->Step();
  std::vector<CShapeId> balls;
  for (const CContactEvent& contact : pWorld->GetContacts())
    balls.push_back(contact.m_cBall);
  const auto ids = pWorld->GetBallIds();
  EXPECT_EQ(balls, (std::vector<CShapeId>{ids[1], ids[2], ids[1], ids[2], ids[0]}));
}

TEST(InvolvedBallsTest, AWorldThatGoesOnAndOneThatIsLoadedHaveTheSameBitsWhateverFindsTheShapes) {
  for (const bool falls : {true, false}) {
    CRandom random(271);
    auto pWorld = MakeNative(g_cContinuous, falls ? 10.0f : 0.0f);
    AddBox(*pWorld, 6);
    for (const CAnyShapeDesc& shape : MakeCrowd(random, 60, 5.5f, 0.8f))
      pWorld->Add(shape);
    for (int i = 0; i < 80; ++i) {
      const Vector2 p = random.InSquare(5.5f), v = random.VectorOfLength(0.0f, 20.0f);
      const float r = random.Uniform(0.02f, 0.2f);
      pWorld->Add(CDynamicCircleDesc(p, r, v, 1, random.Uniform(0.3f, 1.0f)));
    }
    Steps(*pWorld, 100); // by now it has its grid
    const auto pLoaded = GetBackend(eBackend::Native)->MakeWorld(pWorld->GetDesc());
    std::size_t contacts = 0;
    for (int i = 0; i < 20; ++i) {
      pLoaded->LoadState(pWorld->SaveState()); // and this one never
      pWorld->Step();
      pLoaded->Step();
      contacts += pWorld->GetContacts().size();
      ASSERT_EQ(pWorld->GetContacts().size(), pLoaded->GetContacts().size()) << i;
      ASSERT_TRUE(HaveSameBits(*pWorld, *pLoaded)) << i;
    }
    EXPECT_GT(contacts, 20u);
  }
}

// A ball that slides leaves the disc by which it was found near others, in long steps by much, and so does
// one that balls push in a pile. One world in 70 keeps an overlap of more than .1 radii; without a bound of
// the curve on which balls slide along each other it is one in ten.
TEST(InvolvedBallsTest, BallsThatLeaveTheirDiscsFindWhatIsThere) {
  int deep = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    const auto pWorld = MakeNative(g_cContinuous, 10, random.Uniform(0.03f, 0.1f));
    AddBox(*pWorld, 1.5f, 0.5f);
    pWorld->Add(CArcDesc({0, 0.2f}, 1.6f, 3.14159f, 6.28318f, 0.3f));
    for (int i = 0; i < 3; ++i)
      pWorld->Add(CCircleDesc(random.InSquare(1.2f), 0.3f, 0.5f));
    for (int i = 0; i < 26; ++i) {
      const float e = random.Uniform(0, 0.9f);
      const Vector2 v = 3.0f * random.InSquare(1), p = random.InSquare(1.3f);
      pWorld->Add(CDynamicCircleDesc(p, 0.06f, v, 1, e));
    }
    Steps(*pWorld, 26); // they begin in each other
    double overlap = 0.0;
    InEachStep(*pWorld, 34, [&](int) {
      EXPECT_TRUE(AreWithin(*pWorld, 1.5));
      overlap = std::max(overlap, GetOverlap(*pWorld));
    });
    EXPECT_LT(overlap, 0.5);
    deep += overlap > 0.1;
  }
  EXPECT_LE(deep, 6);
}

// All centres are level: nothing in the row says that it can give way upwards.
TEST(InvolvedBallsTest, ARowThatAWallSqueezesIsLiftedInsteadOfMerging) {
  auto pWorld = MakeNative(g_cContinuous, 10);
  pWorld->Add(CLineSegDesc({0, 0}, {10, 0}));
  pWorld->Add(CLineSegDesc({0, 0}, {0, 9}));
  pWorld->Add(Moving(CLineSegDesc({4, 0}, {4, 9}), {-2, 0}));
  for (int i = 0; i < 9; ++i)
    pWorld->Add(CDynamicCircleDesc({0.2f + 0.4f * static_cast<float>(i), 0.2f}, 0.2f, {0, 0}, 1, 0.5f));
  // Of two radii, until it is half as wide.
  InEachStep(*pWorld, 60, [&](int) { EXPECT_LT(GetOverlap(*pWorld), 1.25); });
}

} // namespace
} // namespace Shapes
