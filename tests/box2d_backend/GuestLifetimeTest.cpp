// SPDX-License-Identifier: MIT
// The order in which objects may be destroyed, and the listeners they may replace, where Shapes is in a
// game's b2World. A failure here is memory that is used after its end: run it under the address sanitizer,
// too.
#include "GuestTesting.h"

namespace Shapes::Tests {
namespace {

void ExpectGone(CTable& table) {
  EXPECT_FALSE(table.m_pGuest->IsAlive());
  EXPECT_TRUE(table.World().Contains(table.m_cBall)); // what was there last can be read
  EXPECT_EQ(table.World().GetBallPositions().size(), 2u);
  EXPECT_EQ(table.World().GetShape(table.m_cArc).GetShapeType(), eShape::Arc);
  for (const auto& f : table.Calls())
    EXPECT_TRUE(Says(Thrown(f), "The b2World is gone"));
  EXPECT_EQ(table.World().GetStats().m_nBodiesLost, 0u);
}

TEST(GuestLifetimeTest, TheGameDestroysItsWorldFirst) {
  for (const bool inTheStep : {false, true}) {
    CTable table;
    EXPECT_TRUE(table.m_pGuest->IsAlive());
    const Vector2 p = table.World().GetPos(table.m_cBall);
    if (inTheStep) table.m_pGuest->PreStep(g_fDt);
    table.m_pGame.reset();
    EXPECT_EQ(table.World().GetPos(table.m_cBall), p);
    ExpectGone(table);
  }
}

TEST(GuestLifetimeTest, TwoGuestsNoticeTheEndOfTheirWorldAlsoWithoutAShape) {
  for (const bool firstLeavesFirst : {true, false}) {
    CTable table;
    auto pSecond = MakeGuest(*table.m_pGame);
    EXPECT_TRUE(pSecond->IsAlive());
    table.m_pGame.reset();
    (firstLeavesFirst ? table.m_pGuest : pSecond).reset();
    EXPECT_FALSE((firstLeavesFirst ? pSecond : table.m_pGuest)->IsAlive());
  }
}

TEST(GuestLifetimeTest, TheGameDestroysABallOrAShapeOrAFixture) {
  struct CRow {
    const char* m_sName;
    CShapeId CTable::*m_pLost;
    void (*m_pDestroy)(CTable&);
  };
  const CRow rows[] = {
      {"a ball", &CTable::m_cBall, [](CTable& t) { t.m_pGame->DestroyBody(t.BodyOfBall()); }},
      {"a shape of several fixtures, in which another goes on", &CTable::m_cArc,
       [](CTable& t) { t.m_pGame->DestroyBody(t.BodyOfArc()); }},
      {"one of them, and then what is left of it and is the game's", &CTable::m_cArc, [](CTable& t) {
         b2Body* pArc = t.BodyOfArc();
         ASSERT_NE(pArc->GetFixtureList()->GetNext(), nullptr);
         pArc->DestroyFixture(pArc->GetFixtureList());
         EXPECT_FALSE(t.World().Contains(t.m_cArc));
         t.Step(10);
         t.m_pGame->DestroyBody(pArc);
       }}};
  for (const CRow& row : rows) {
    SCOPED_TRACE(row.m_sName);
    CTable table;
    const CShapeId lost = table.*row.m_pLost;
    const auto pieces = table.World().GetStats().m_nArcPieces;
    row.m_pDestroy(table);
    EXPECT_FALSE(table.World().Contains(lost)); // at once
    EXPECT_EQ(table.World().GetBallPositions().size(), lost == table.m_cBall ? 1u : 2u);
    EXPECT_EQ(table.World().GetStats().m_nBodiesLost, 1u);
    EXPECT_EQ(table.World().GetStats().m_nArcPieces < pieces, lost == table.m_cArc);
    EXPECT_THROW(table.World().GetPos(lost), std::invalid_argument);
    EXPECT_THROW(table.World().Remove(lost), std::invalid_argument);
    table.Step(60);
    EXPECT_TRUE(table.World().Contains(table.m_cOther));
    const CShapeId next = table.World().Add(CDynamicCircleDesc({3, 1}, 0.1f));
    EXPECT_GT(next, table.m_cOther); // ids are never used again
    table.Step(60);
  }
}

TEST(GuestLifetimeTest, TheGameDestroysAllBodies) {
  CTable table;
  while (table.m_pGame->GetBodyList() != nullptr)
    table.m_pGame->DestroyBody(table.m_pGame->GetBodyList());
  ExpectGone(table);
  // The next one in the same b2World is none the wiser.
  const auto pNext = MakeGuest(*table.m_pGame);
  pNext->GetWorld().Add(CLineSegDesc({-1, 0}, {1, 0}));
  pNext->GetWorld().Add(CDynamicCircleDesc({0, 0.3f}, 0.1f, {0, -3}));
  table.m_cListener = CCounting();
  Steps(*table.m_pGame, *pNext, 10);
  EXPECT_EQ(table.m_cListener.m_nBegin, 1); // once: the first one's listener passes on and no more
  table.m_pGuest.reset();
  Steps(*table.m_pGame, *pNext, 10);
}

TEST(GuestLifetimeTest, TheGameDestroysAllBodiesButABall) {
  for (const bool goesOn : {true, false}) {
    CTable table;
    std::vector<b2Body*> others;
    for (b2Body* p = table.m_pGame->GetBodyList(); p != nullptr; p = p->GetNext())
      if (p != table.BodyOfBall()) others.push_back(p);
    for (b2Body* p : others)
      table.m_pGame->DestroyBody(p);
    EXPECT_TRUE(table.m_pGuest->IsAlive());
    if (goesOn) table.Step(10);
    EXPECT_EQ(table.World().GetStats().m_nBodiesLost, 4u);
    table.World().Remove(table.m_cBall);
    EXPECT_TRUE(table.m_pGuest->IsAlive()); // it has made itself another sentinel
    table.m_pGame.reset();
    EXPECT_FALSE(table.m_pGuest->IsAlive());
  }
}

TEST(GuestLifetimeTest, TheMemoryOfABodyBecomesOneOfTheGame) {
  for (const int moment : {0, 1, 2}) { // before the step, before Box2D's part of it, and after that
    CTable table;
    b2Body *pBall = table.BodyOfBall(), *pBox = nullptr;
    const auto exchange = [&](int now) {
      if (now != moment) return;
      table.m_pGame->DestroyBody(pBall);
      pBox = AddBox(*table.m_pGame, {3, 1.01f}); // falls onto the segment
    };
    exchange(0);
    table.m_pGuest->PreStep(g_fDt);
    exchange(1);
    table.StepGame(1);
    exchange(2);
    table.m_pGuest->PostStep();
    ASSERT_EQ(pBox, pBall); // Box2D gives what it got back last
    ASSERT_EQ(table.World().GetBallIds().size(), 1u);
    EXPECT_EQ(table.World().GetBallIds()[0], table.m_cOther);
    EXPECT_NEAR(table.World().GetPos(table.m_cOther).x(), 0, 0.01f); // and not the place of the other one
    table.Step(30);
    EXPECT_FALSE(table.World().Contains(table.m_cBall));
    EXPECT_EQ(table.World().GetStats().m_nBodiesLost, 1u);
    for (const CContactEvent& event : table.World().GetContacts())
      EXPECT_EQ(event.m_cBall, table.m_cOther);
    const b2Vec2 p = pBox->GetPosition();
    EXPECT_NEAR(p.y, 1.01f, 0.02f);
    table.m_pGuest.reset();
    EXPECT_EQ(pBox->GetPosition(), p);
    EXPECT_EQ(table.m_pGame->GetBodyCount(), 3); // ground and two boxes
  }
}

TEST(GuestLifetimeTest, TheGuestIsDestroyedFirst) {
  CTable table;
  const auto touching = [&] { return table.m_cListener.m_nBegin - table.m_cListener.m_nEnd; };
  table.Step(30);
  ASSERT_NE(Installed(*table.m_pGame), &table.m_cListener);
  ASSERT_GT(touching(), 1);
  table.m_pGuest.reset();
  EXPECT_EQ(Installed(*table.m_pGame), &table.m_cListener);
  EXPECT_EQ(table.m_pGame->GetBodyCount(), 2);
  EXPECT_EQ(touching(), 1); // only the box is left, on the ground
  table.StepGame(60);
}

TEST(GuestLifetimeTest, AnotherListenerIsNoticedAndPassedOnTo) {
  CTable table;
  CCounting second;
  for (CCounting* pNext : {&second, static_cast<CCounting*>(nullptr)}) {
    table.m_pGame->SetContactListener(pNext);
    table.m_cListener = second = CCounting();
    table.Step(10);
    EXPECT_EQ(table.World().GetStats().m_nListenersReplaced, pNext ? 1u : 2u);
    EXPECT_FALSE(table.World().GetContacts().empty());
    EXPECT_EQ(second.m_nPre > 0, pNext != nullptr);
    EXPECT_EQ(table.m_cListener.m_nPre, 0);
  }
  table.m_pGuest.reset();
  EXPECT_EQ(Installed(*table.m_pGame), nullptr);
}

TEST(GuestLifetimeTest, AListenerMayPassOnToOurs) {
  struct CWrapping : CCounting {
    b2ContactListener* m_pNext = nullptr;
    void PreSolve(b2Contact* pContact, const b2Manifold* pOld) override {
      CCounting::PreSolve(pContact, pOld);
      m_pNext->PreSolve(pContact, pOld);
    }
  } outer;
  CTable table;
  outer.m_pNext = Installed(*table.m_pGame);
  table.m_pGame->SetContactListener(&outer);
  table.m_cListener = CCounting();
  table.Step(10);
  EXPECT_GT(outer.m_nPre, 0);
  EXPECT_EQ(table.m_cListener.m_nPre, outer.m_nPre); // each hears everything once
  // One that begins to pass on while it is passed on to must not go round for ever.
  outer.m_pNext = Installed(*table.m_pGame);
  outer.m_nPre = 0;
  table.Step(10);
  EXPECT_GT(outer.m_nPre, 0);
  table.m_pGuest.reset();
  table.StepGame(10);
}

TEST(GuestLifetimeTest, AListenerThatIsInstalledInEachStepCostsNothing) {
  CTable table;
  CCounting second;
  b2ContactListener* pOurs = nullptr;
  for (int i = 0; i < 10; ++i) {
    table.m_pGame->SetContactListener(&second);
    table.m_pGuest->PreStep(g_fDt);
    EXPECT_TRUE(i == 0 || Installed(*table.m_pGame) == pOurs);
    pOurs = Installed(*table.m_pGame);
    table.StepGame(1);
    table.m_pGuest->PostStep();
  }
  EXPECT_EQ(table.World().GetStats().m_nListenersReplaced, 10u);
  table.m_pGuest.reset();
}

TEST(GuestLifetimeTest, TwoGuestsInOneWorldLeaveInEitherOrder) {
  for (const bool firstLeavesFirst : {true, false}) {
    CTable table;
    auto pSecond = MakeGuest(*table.m_pGame);
    const CShapeId ball = pSecond->GetWorld().Add(CDynamicCircleDesc({3, 0.9f}, 0.1f, {0, -1}));
    table.m_cListener = CCounting();
    int strangers = 0;
    for (int i = 0; i < 30; ++i) {
      table.m_pGuest->PreStep(g_fDt);
      pSecond->PreStep(g_fDt);
      table.StepGame(1);
      pSecond->PostStep();
      table.m_pGuest->PostStep();
      for (const CContactEvent& event : pSecond->GetWorld().GetContacts())
        strangers += event.m_cBall == ball && event.m_cShape == CShapeId();
    }
    EXPECT_GT(strangers, 0); // the ball of the one falls onto the segment of the other
    EXPECT_GT(table.World().GetStats().m_nContacts, 0u);
    for (CBox2DWorld* p : {table.m_pGuest.get(), pSecond.get()})
      EXPECT_EQ(p->GetWorld().GetStats().m_nListenersReplaced, 0u);
    CBox2DWorld& left = firstLeavesFirst ? *pSecond : *table.m_pGuest;
    (firstLeavesFirst ? table.m_pGuest : pSecond).reset();
    EXPECT_TRUE(left.IsAlive());
    const auto contacts = left.GetWorld().GetStats().m_nContacts;
    left.GetWorld().Add(CDynamicCircleDesc({7, 0.15f}, 0.1f, {0, -1})); // to the ground
    Steps(*table.m_pGame, left, 30);
    EXPECT_GT(left.GetWorld().GetStats().m_nContacts, contacts);
    EXPECT_EQ(left.GetWorld().GetStats().m_nListenersReplaced, 0u);
    table.m_pGuest.reset();
    pSecond.reset();
    EXPECT_EQ(Installed(*table.m_pGame), &table.m_cListener);
    EXPECT_EQ(table.m_pGame->GetBodyCount(), 2);
  }
}

TEST(GuestLifetimeTest, TheGuestIsDestroyedInTheMiddleOfAStepOfBox2D) {
  CTable table;
  const int bodies = table.m_pGame->GetBodyCount();
  table.m_cListener.m_stdAtPreSolve = [&] { table.m_pGuest.reset(); };
  table.m_pGuest->PreStep(g_fDt);
  table.StepGame(1);
  ASSERT_EQ(table.m_pGuest, nullptr);
  EXPECT_EQ(table.m_pGame->GetBodyCount(), bodies); // they are the game's now
  table.StepGame(30);
  const auto pNext = MakeGuest(*table.m_pGame);
  Steps(*table.m_pGame, *pNext, 10);
  table.m_pGame->DestroyBody(table.BodyOfBall());
  Steps(*table.m_pGame, *pNext, 10);
  EXPECT_EQ(pNext->GetWorld().GetStats().m_nBodiesLost, 0u);
}

TEST(GuestLifetimeTest, TheGuestIsDestroyedWhileABodyIs) {
  CTable table;
  table.Step(30);
  table.m_cListener.m_stdAtEnd = [&] { table.m_pGuest.reset(); };
  table.m_pGame->DestroyBody(table.m_pBox); // the other ball lies on it
  ASSERT_EQ(table.m_pGuest, nullptr);
  table.StepGame(30);
}

} // namespace
} // namespace Shapes::Tests
