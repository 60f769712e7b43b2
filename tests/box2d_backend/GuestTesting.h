// SPDX-License-Identifier: MIT
// A small game with a b2World of its own, for tests of Shapes in it.
#pragma once

#include "ImportTesting.h"

namespace Shapes::Tests {

inline std::unique_ptr<CBox2DWorld> MakeGuest(b2World& game, eProfile e = eProfile::Shipped,
                                              float unit = 1.0f, const CEffectChoice& choice = g_cAutomatic) {
  CWorldDesc desc = Described({0, 0}, g_fDt, 1, choice, e);
  desc.m_cBox2D.m_fLengthUnit = unit;
  return MakeWorld(game, desc);
}

/// The frame of a game.
inline void Steps(b2World& game, CBox2DWorld& guest, int n, float dt = g_fDt) {
  for (int i = 0; i < n; ++i) {
    guest.PreStep(dt);
    game.Step(dt, 8, 3);
    guest.PostStep();
  }
}

/// A box of side 1 and mass 1 about p, with Box2D's restitution 0 and no friction.
inline b2Body* AddBox(b2World& game, const b2Vec2& p, b2BodyType type = b2_dynamicBody) {
  b2Body* pBody = CGame::AddBody(game, type, p);
  CGame::AddFixture(pBody, CGame::Box(0.5f, 0.5f));
  return pBody;
}

/// A ground of the game: an edge along y = 0.
inline b2Body* AddGround(b2World& game) {
  b2Body* pBody = CGame::AddBody(game, b2_staticBody);
  CGame::AddFixture(pBody, CGame::Edge({-50, 0}, {50, 0}));
  return pBody;
}

/// The bodies whose fixtures have that user pointer.
inline std::vector<b2Body*> FindBodies(b2World& game, const void* pUser) {
  std::vector<b2Body*> found;
  for (b2Body* p = game.GetBodyList(); p != nullptr; p = p->GetNext())
    if (p->GetFixtureList() != nullptr &&
        p->GetFixtureList()->GetUserData().pointer == reinterpret_cast<uintptr_t>(pUser))
      found.push_back(p);
  return found;
}

inline b2Body* FindBody(b2World& game, const void* pUser) { return FindBodies(game, pUser).at(0); }

/// Counts what it hears, and does something once, in the next PreSolve or EndContact.
struct CCounting : b2ContactListener {
  int m_nBegin = 0, m_nEnd = 0, m_nPre = 0, m_nPost = 0;
  float m_fRestitution = -1.0f; ///< in the last PreSolve
  std::function<void()> m_stdAtPreSolve, m_stdAtEnd;
  void BeginContact(b2Contact*) override { ++m_nBegin; }
  void EndContact(b2Contact*) override {
    ++m_nEnd;
    Act(m_stdAtEnd);
  }
  void PreSolve(b2Contact* pContact, const b2Manifold*) override {
    ++m_nPre;
    m_fRestitution = pContact->GetRestitution();
    Act(m_stdAtPreSolve);
  }
  void PostSolve(b2Contact*, const b2ContactImpulse*) override { ++m_nPost; }
  static void Act(std::function<void()>& what) {
    if (const auto act = std::exchange(what, nullptr)) act();
  }
};

/// A game without gravity and a guest in it, of either profile.
class CGuest : public CEveryProfile {
protected:
  /// Puts Shapes into the game, after the game's own bodies or before them; the last guest leaves first.
  CWorld& Join(const CEffectChoice& choice = g_cAutomatic) {
    m_pGuest.reset();
    m_pGuest = MakeGuest(m_cGame, GetParam(), 1, choice);
    return World();
  }
  CWorld& World() { return m_pGuest->GetWorld(); }
  void Steps(int n, float dt = g_fDt) { Tests::Steps(m_cGame, *m_pGuest, n, dt); }
  /// The contacts, sensor events or touches of n steps.
  template <class T>
  std::vector<T> Told(int n, std::span<const T> (CWorld::*pGet)() const) {
    return Shapes::Told(World(), n, pGet, [this] { Steps(1); });
  }
  /// The velocity of a new ball after n steps.
  Vector2 Throw(const CDynamicCircleDesc& ball, int n) {
    const CShapeId id = World().Add(ball);
    Steps(n);
    return World().GetVel(id);
  }
  b2Body* BodyOf(CShapeId id) {
    World().SetUserPtr(id, this);
    b2Body* pBody = FindBody(m_cGame, this);
    World().SetUserPtr(id, nullptr);
    return pBody;
  }
  /// One step of the game, in the middle of which it destroys the body of this shape or ball.
  void StepAndDestroy(CShapeId id) {
    b2Body* pBody = BodyOf(id);
    m_pGuest->PreStep(g_fDt);
    m_cGame.DestroyBody(pBody);
    m_cGame.Step(g_fDt, 8, 3);
    m_pGuest->PostStep();
  }

  CCounting m_cListener; // hears of the end of the guest, too
  b2World m_cGame{b2Vec2_zero};
  std::unique_ptr<CBox2DWorld> m_pGuest;
};

inline b2ContactListener* Installed(const b2World& game) {
  return game.GetContactManager().m_contactListener;
}

inline std::string Thrown(const std::function<void()>& f) { return MessageOf<std::logic_error>(f); }

/// A game with a ground and a box, and a guest with a bit of everything, in touch with both.
struct CTable {
  CCounting m_cListener;
  std::unique_ptr<b2World> m_pGame = std::make_unique<b2World>(b2Vec2(0, -10));
  b2Body* m_pBox;
  std::unique_ptr<CBox2DWorld> m_pGuest;
  CShapeId m_cSegment, m_cArc, m_cBall, m_cOther;
  int m_nUserData[2] = {}; ///< of the ball, the arc

  explicit CTable(eProfile e = eProfile::Tuned) {
    m_pGame->SetContactListener(&m_cListener);
    AddGround(*m_pGame);
    m_pBox = AddBox(*m_pGame, {0, 0.51f});
    m_pGuest = MakeGuest(*m_pGame, e);
    m_cSegment = World().Add(CLineSegDesc({2, 0.5f}, {4, 0.5f}));
    m_cArc = World().Add(CArcDesc({4, 1.5f}, 1, 1.5f * g_fPi, 0.25f * g_fPi)); // goes on in the segment
    World().Add(CPointDesc({2, 0.5f}));
    m_cBall = World().Add(CDynamicCircleDesc({3, 0.62f}, 0.1f, {1, 0}, 1, 0.5f));
    m_cOther = World().Add(CDynamicCircleDesc({0, 1.15f}, 0.1f, {0, 0}, 1, 0));
    World().SetUserPtr(m_cBall, &m_nUserData[0]);
    World().SetUserPtr(m_cArc, &m_nUserData[1]);
    Step(10);
  }
  CWorld& World() { return m_pGuest->GetWorld(); }
  void Step(int n = 1) { Steps(*m_pGame, *m_pGuest, n); }
  /// Steps that the guest knows nothing of.
  void StepGame(int n) {
    for (int i = 0; i < n; ++i)
      m_pGame->Step(g_fDt, 8, 3);
  }
  /// All that may change something.
  std::vector<std::function<void()>> Calls() {
    const Vector2 zero(0, 0);
    const std::vector<CAnyShapeDesc> parts{CPointDesc(zero)};
    return {[=, this] { World().Add(CPointDesc(zero)); },
            [=, this] { World().Add(CDynamicCircleDesc(zero, 1)); },
            [=, this] { World().Remove(m_cBall); },
            [=, this] { World().SetPos(m_cBall, zero); },
            [=, this] { World().SetVel(m_cBall, zero); },
            [=, this] { World().SetElasticity(m_cArc, 0.1f); },
            [=, this] { World().SetSensor(m_cArc, true); },
            [=, this] { World().SetCanCollide(m_cArc, false); },
            [=, this] { World().SetUserPtr(m_cArc, nullptr); },
            [=, this] { World().AddCompound(parts, zero); },
            [=, this] { m_pGuest->PreStep(g_fDt); },
            [=, this] { m_pGuest->PostStep(); }};
  }
  b2Body* BodyOfBall() { return FindBody(*m_pGame, &m_nUserData[0]); }
  b2Body* BodyOfArc() { return FindBody(*m_pGame, &m_nUserData[1]); }
};

} // namespace Shapes::Tests
