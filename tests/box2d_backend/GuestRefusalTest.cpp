// SPDX-License-Identifier: MIT
// Calls that Shapes refuses in a game's b2World, always or at that moment, change nothing.
#include "GuestTesting.h"

namespace Shapes::Tests {
namespace {

/// That f throws, and that the message has these words in it.
void ExpectThrows(const std::string& words, const std::function<void()>& f) {
  EXPECT_TRUE(Says(Thrown(f), words));
}

TEST(GuestRefusalTest, NothingIsChangedInCallbacksOfBox2D) {
  for (const bool atEnd : {false, true}) { // of the step, and of DestroyBody outside of one
    CTable table;
    table.Step(30);
    std::vector<std::string> thrown;
    std::size_t balls = 0;
    (atEnd ? table.m_cListener.m_stdAtEnd : table.m_cListener.m_stdAtPreSolve) = [&] {
      for (const auto& f : table.Calls())
        thrown.push_back(Thrown(f));
      balls = table.World().GetBallPositions().size(); // looking is allowed
    };
    if (atEnd)
      table.m_pGame->DestroyBody(table.m_pBox);
    else
      table.Step();
    ASSERT_EQ(thrown.size(), 12u);
    for (const std::string& what : thrown)
      EXPECT_TRUE(Says(what, "callback of Box2D"));
    EXPECT_EQ(balls, 2u);
    EXPECT_EQ(table.World().GetElasticity(table.m_cArc), 1);
    EXPECT_EQ(table.World().GetUserPtr(table.m_cArc), &table.m_nUserData[1]);
    table.Step(10);
    table.World().Remove(table.m_cBall); // the control: afterwards it can be done
  }
}

TEST(GuestRefusalTest, WhatTheGuestItselfDestroysIsHeardOfButNotActedUpon) {
  struct CGoodbye : b2DestructionListener {
    std::function<void()> m_stdAct;
    void SayGoodbye(b2Joint*) override {}
    void SayGoodbye(b2Fixture*) override { m_stdAct(); }
  } goodbye;
  for (const bool byDestructionListener : {false, true}) {
    CTable table;
    table.Step(30);
    std::string thrown;
    (byDestructionListener ? goodbye.m_stdAct : table.m_cListener.m_stdAtEnd) = [&] {
      thrown = Thrown([&] { table.World().Remove(table.m_cSegment); });
    };
    if (byDestructionListener) table.m_pGame->SetDestructionListener(&goodbye);
    table.World().Remove(table.m_cOther);
    EXPECT_TRUE(Says(thrown, "callback of Box2D"));
    EXPECT_TRUE(table.World().Contains(table.m_cSegment));
    table.m_pGame->SetDestructionListener(nullptr);
  }
}

TEST(GuestRefusalTest, StepsComeInPairs) {
  CTable table;
  CBox2DWorld& guest = *table.m_pGuest;
  ExpectThrows("without PreStep", [&] { guest.PostStep(); });
  for (const float dt : {0.0f, -1.0f, std::nanf(""), 1e7f})
    EXPECT_THROW(guest.PreStep(dt), std::invalid_argument);
  const auto steps = table.World().GetStats().m_nSteps;
  guest.PreStep(g_fDt);
  ExpectThrows("called twice", [&] { guest.PreStep(g_fDt); });
  ExpectThrows("between PreStep and PostStep", [&] { table.World().SetPos(table.m_cBall, Vector2(0, 0)); });
  table.StepGame(1);
  guest.PostStep();
  ExpectThrows("without PreStep", [&] { guest.PostStep(); });
  EXPECT_EQ(table.World().GetStats().m_nSteps, steps + 1);
}

TEST(GuestRefusalTest, AStepWithoutPreStepIsTheGamesOwn) {
  CTable table;
  table.StepGame(30);
  table.Step(30);
  EXPECT_TRUE(table.m_pGuest->IsAlive());
}

TEST(GuestRefusalTest, WhatAGuestCannotDoItRefuses) {
  CTable table;
  ExpectThrows("call PreStep(dt), then b2World::Step(dt, ...)", [&] { table.World().Step(); });
  ExpectThrows("neither saved nor loaded", [&] { table.World().SaveState(); });
  const CSavedState saved = MakeBox2D(eProfile::Shipped)->SaveState();
  ExpectThrows("neither saved nor loaded", [&] { table.World().LoadState(saved); });
  EXPECT_TRUE(table.World().Contains(table.m_cBall));
  EXPECT_THROW(table.World().SetGravity({0, -1}), std::invalid_argument);

  const int bodies = table.m_pGame->GetBodyCount();
  const b2ContactListener* pListener = Installed(*table.m_pGame);
  CWorldDesc desc;
  desc.m_vGravity = {0, -1};
  EXPECT_EQ(Thrown([&] { MakeWorld(*table.m_pGame, desc); }),
            "m_vGravity is not zero: expected (0, 0): the b2World has the gravity");
  desc = CWorldDesc();
  desc.m_cBox2D.m_fLengthUnit = 0;
  EXPECT_THROW(MakeWorld(*table.m_pGame, desc), std::invalid_argument);
  EXPECT_EQ(table.m_pGame->GetBodyCount(), bodies);
  EXPECT_EQ(Installed(*table.m_pGame), pListener);
}

TEST(GuestRefusalTest, NoGuestIsMadeInTheMiddleOfAStepOfBox2D) {
  CTable table;
  std::string thrown;
  table.m_cListener.m_stdAtPreSolve = [&] { thrown = Thrown([&] { MakeGuest(*table.m_pGame); }); };
  table.Step();
  EXPECT_TRUE(Says(thrown, "during b2World::Step"));
}

} // namespace
} // namespace Shapes::Tests
