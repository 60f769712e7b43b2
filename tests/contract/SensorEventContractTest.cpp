// SPDX-License-Identifier: MIT
// Begin and end of what sensors see and of solid contacts: every begin has its end, whatever happens to the
// world.
#include "Backends.h"

namespace Shapes {
namespace {

using CPairs = std::set<std::pair<CShapeId, CShapeId>>; // ball, shape

class CSensorEventContract : public CEveryBackend {
protected:
  void SetUp() override { m_pWorld = Backend().MakeWorld(Described({0, 0}, 1.0f / 64.0f)); }

  std::string Step() { return Marks(*m_pWorld, &CWorld::GetSensorEvents); }

  /// A ball in a zone, or one that falls onto a floor; they touch after m_nSteps.
  struct CTouching {
    std::unique_ptr<CWorld> m_pWorld;
    CShapeId m_cShape, m_cBall;
    int m_nSteps;
  };
  CTouching MakeTouching(bool isSensor) const {
    CTouching made{
        Make({{eEffect::Touches}, {}}, eProfile::Shipped, {0, isSensor ? 0.0f : -10.0f}), {}, {}, 1};
    if (isSensor) {
      made.m_cShape = made.m_pWorld->Add(MakeZone());
    } else {
      made.m_cShape = made.m_pWorld->Add(CLineSegDesc({-5, 0}, {5, 0}));
      made.m_nSteps = 120;
    }
    made.m_cBall = made.m_pWorld->Add(CDynamicCircleDesc({0, 0.15f}, 0.1f, {0, 0}, 1, 0.0f));
    return made;
  }

  /// Once with the events of sensors, once with those of solid contacts.
  template <class F>
  static void OfBothKinds(const F& f) {
    f(true, &CWorld::GetSensorEvents);
    f(false, &CWorld::GetTouchEvents);
  }

  std::unique_ptr<CWorld> m_pWorld;
};
SHAPES_ON_EVERY_BACKEND(CSensorEventContract);

TEST_P(CSensorEventContract, WhoeverIsRemovedOrTurnedOffCeasesToTouch) {
  OfBothKinds([&](bool isSensor, auto pGet) {
    for (const CParting& part : g_stdPartings) {
      SCOPED_TRACE(testing::Message() << isSensor << ' ' << &part - g_stdPartings);
      const CTouching made = MakeTouching(isSensor);
      CWorld& world = *made.m_pWorld;
      EXPECT_EQ(Marks(world, pGet, made.m_nSteps), "+");
      EXPECT_EQ(Marks(world, pGet), "");
      part(world, made.m_cShape, made.m_cBall);
      ASSERT_EQ(Marks(world, pGet), "-");
      const auto event = (world.*pGet)()[0];
      EXPECT_EQ(event, (decltype(event){made.m_cShape, made.m_cBall, false}));
      for (const CContactEvent& contact : world.GetContacts())
        EXPECT_NE(contact.m_bIsSensor, isSensor);
      EXPECT_EQ(Marks(world, pGet), "");
    }
  });
}

TEST_P(CSensorEventContract, ASavedStateKnowsWhatTouches) {
  OfBothKinds([&](bool isSensor, auto pGet) {
    const CTouching made = MakeTouching(isSensor), other = MakeTouching(isSensor);
    CWorld& world = *made.m_pWorld;
    const CSavedState apart = world.SaveState(); // nothing was told yet
    EXPECT_EQ(Marks(world, pGet, made.m_nSteps), "+");
    const CSavedState touching = world.SaveState();
    EXPECT_EQ(Marks(world, pGet), "");
    world.SetPos(made.m_cBall, {0, 3});
    EXPECT_EQ(Marks(world, pGet), "-");
    world.LoadState(touching);
    EXPECT_TRUE((world.*pGet)().empty());
    EXPECT_EQ(Marks(world, pGet, 60), "");
    world.LoadState(apart);
    EXPECT_EQ(Marks(world, pGet, made.m_nSteps), "+");
    // In another world too.
    other.m_pWorld->LoadState(touching);
    EXPECT_EQ(Marks(*other.m_pWorld, pGet, 60), "");
    other.m_pWorld->Remove(made.m_cBall);
    EXPECT_EQ(Marks(*other.m_pWorld, pGet), "-");
  });
}

// The ball passes the gate, bounces off the wall and passes it again: seen only if the world knows where it
// turned, whether contacts are told or not.
TEST_P(CSensorEventContract, PassesWithinASubstepAreOne) {
  for (const auto& [substeps, forbidden] :
       {std::pair(1u, CEffects()), {2u, CEffects()}, {1u, CEffects{eEffect::Events}}}) {
    const CEffectChoice choice{{eEffect::Continuous}, forbidden};
    m_pWorld = Backend().MakeWorld(Described({0, 0}, 1.0f / 64.0f, substeps, choice));
    m_pWorld->Add(Sensor(CLineSegDesc({0.5f, -1}, {0.5f, 1})));
    m_pWorld->Add(CLineSegDesc({0.875f, -1}, {0.875f, 1}));
    m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.125f, {100, 0})); // 1.56 a step, the wall is .75 away
    EXPECT_EQ(Step(), substeps == 1 ? "+-" : "+-+-");
  }
}

TEST_P(CSensorEventContract, WhatIsOffAndOnAgainBetweenStepsTouchesOn) {
  const CShapeId zone = m_pWorld->Add(MakeZone()), ball = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f));
  EXPECT_EQ(Step(), "+");
  m_pWorld->SetSensor(zone, false);
  m_pWorld->SetSensor(zone, true);
  m_pWorld->SetCanCollide(ball, false);
  m_pWorld->SetCanCollide(ball, true);
  EXPECT_EQ(Step(), "");
  // Still a pair if the ball is the sensor now.
  m_pWorld->SetSensor(ball, true);
  m_pWorld->SetSensor(zone, false);
  EXPECT_EQ(Step(), "");
}

TEST_P(CSensorEventContract, TheEndOfWhatIsGoneComesBeforeWhatTheStepBrings) {
  const CShapeId a = m_pWorld->Add(MakeZone()), b = m_pWorld->Add(MakeZone({5, 0}));
  const CShapeId ball = m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.1f));
  const CShapeId other = m_pWorld->Add(CDynamicCircleDesc({0, 0.5f}, 0.1f));
  EXPECT_EQ(Step(), "++");
  m_pWorld->SetPos(ball, {5, 0});
  m_pWorld->Remove(other);
  EXPECT_EQ(Step(), "--+");
  const auto told = m_pWorld->GetSensorEvents();
  EXPECT_EQ(told[0], (CSensorEvent{a, other, false})); // though it is a later ball
  EXPECT_EQ(told[1], (CSensorEvent{a, ball, false}));
  EXPECT_EQ(told[2], (CSensorEvent{b, ball, true}));
}

// A world to which anything may happen between two steps, and what was told of it.
class CRandomGame {
public:
  CRandomGame(CWorld& world, std::uint64_t seed)
      : m_cWorld(world), m_cRandom(seed), m_cFloor(world.Add(CLineSegDesc({-5, -3.5f}, {5, -3.5f}))) {}

  /// A saved state has to know this.
  struct CAccount {
    CPairs m_stdTouching, m_stdSolid; // begun and not ended: of sensors, and of solid contacts
  };
  std::size_t m_nBegins = 0, m_nCrossed = 0, m_nLoads = 0, m_nSolidBegins = 0;
  CAccount m_cNow;

  void Act() {
    const std::vector<CShapeId> ids = GetIds();
    if (ids.empty()) return AddBall();
    const CShapeId id = ids[m_cRandom.Below(static_cast<std::uint32_t>(ids.size()))];
    switch (m_cRandom.Below(12)) {
    case 0:
    case 1: return AddBall();
    case 2:
    case 3: return AddShape();
    case 4:
      if (ids.size() > 10) m_cWorld.Remove(id);
      break;
    case 5: return m_cWorld.SetSensor(id, !m_cWorld.GetSensor(id));
    case 6: return m_cWorld.SetCanCollide(id, !m_cWorld.GetCanCollide(id));
    case 7: return m_cWorld.SetPos(id, m_cRandom.InSquare(3));
    case 8:
      if (m_cRandom.Below(4) == 0) m_stdSaved.emplace(m_cWorld.SaveState(), m_cNow);
      break;
    case 9:
      if (m_cRandom.Below(4) == 0) Load();
      break;
    default:
      if (m_cWorld.GetMotionType(id) == eMotion::Dynamic) m_cWorld.SetVel(id, Velocity());
    }
  }

  /// Puts back what flew away.
  void KeepIn() {
    for (const CShapeId id : GetIds())
      if (m_cWorld.GetPos(id).cwiseAbs().maxCoeff() > 4) m_cWorld.SetPos(id, m_cRandom.InSquare(3));
  }

  /// Steps, and keeps account. Every begin is of a pair that does not touch, every end of one that does.
  void Step() {
    m_cWorld.Step();
    CPairs begun;
    for (const CSensorEvent& event : m_cWorld.GetSensorEvents()) {
      const std::pair pair(event.m_cBall, event.m_cShape);
      if (event.m_bBegin) {
        ASSERT_TRUE(m_cNow.m_stdTouching.insert(pair).second);
        ASSERT_TRUE(begun.insert(pair).second);
        ++m_nBegins;
      } else {
        ASSERT_EQ(m_cNow.m_stdTouching.erase(pair), 1u);
        m_nCrossed += begun.contains(pair);
      }
    }
    for (const CTouchEvent& event : m_cWorld.GetTouchEvents()) {
      const std::pair pair(event.m_cBall, event.m_cShape);
      ASSERT_TRUE(event.m_bBegin ? m_cNow.m_stdSolid.insert(pair).second
                                 : m_cNow.m_stdSolid.erase(pair) == 1);
      m_nSolidBegins += event.m_bBegin;
    }
    // The contacts are those that touch or touched: a pair that goes on touching has one.
    CPairs contacts;
    for (const CContactEvent& contact : m_cWorld.GetContacts())
      if (contact.m_bIsSensor) {
        ASSERT_TRUE(contacts.emplace(contact.m_cBall, contact.m_cShape).second);
        ASSERT_TRUE(m_cWorld.GetSensor(contact.m_cBall) || m_cWorld.GetSensor(contact.m_cShape));
        ASSERT_TRUE(m_cWorld.GetCanCollide(contact.m_cBall) && m_cWorld.GetCanCollide(contact.m_cShape));
      }
    for (const auto& pair : m_cNow.m_stdTouching)
      ASSERT_TRUE(contacts.contains(pair));
    for (const auto& pair : begun)
      ASSERT_TRUE(contacts.contains(pair));
    LookAtAllPairs();
  }

  void RemoveAll() {
    for (const CShapeId id : GetIds())
      m_cWorld.Remove(id);
  }

private:
  // A touch that has begun and not ended is one that lasts.
  void LookAtAllPairs() {
    for (const CShapeId ball : m_cWorld.GetBallIds())
      for (const CShapeId id : GetIds()) {
        if (id == ball) continue;
        const bool isBall = m_cWorld.GetMotionType(id) == eMotion::Dynamic;
        if (isBall && id < ball) continue;
        const bool on = m_cWorld.GetCanCollide(ball) && m_cWorld.GetCanCollide(id) &&
                        (m_cWorld.GetSensor(ball) || m_cWorld.GetSensor(id));
        const Vector2& p = m_cWorld.GetPos(ball);
        // An arc is a curve; ends belong to what they end.
        const float d = isBall ? GetDistance(m_cWorld, id, p) : SensedDistanceFrom(m_cWorld.GetShape(id), p),
                    gap = d - m_cWorld.GetRadius(ball);
        if (on && std::abs(gap) < 1e-5f) continue; // rounding decides: some ulp of coordinates up to 5
        ASSERT_EQ(m_cNow.m_stdTouching.contains({ball, id}), on && gap < 0) << "gap " << gap;
      }
  }

  std::vector<CShapeId> GetIds() const {
    std::vector<CShapeId> ids(m_cWorld.GetShapeIds());
    std::erase(ids, m_cFloor);
    ids.insert(ids.end(), m_cWorld.GetBallIds().begin(), m_cWorld.GetBallIds().end());
    return ids;
  }
  Vector2 Velocity() { return m_cRandom.InSquare(60); } // up to 1 unit a step
  void AddBall() {
    if (m_cWorld.GetBallIds().size() >= 12) return;
    CDynamicCircleDesc desc{m_cRandom.InSquare(3), m_cRandom.Uniform(0.05f, 0.3f)};
    desc.m_vVel = Velocity();
    desc.m_bIsSensor = m_cRandom.Below(4) == 0;
    desc.m_fElasticity = m_cRandom.Coin() ? 1.0f : 0.5f;
    m_cWorld.Add(desc);
  }
  template <class TDesc>
  void Dress(TDesc desc) {
    desc.m_bIsSensor = m_cRandom.Coin();
    // The open side of a sensor is seen like the solid one.
    if constexpr (requires { desc.m_eSides; }) {
      if (m_cRandom.Coin()) desc.m_eSides = m_cRandom.Coin() ? eSides::Front : eSides::Back;
    }
    if (m_cRandom.Below(3) == 0) {
      desc.m_eMotionType = eMotion::Kinematic;
      desc.m_vRotCenter = desc.m_vPos;
      desc.m_fRotSpeed = m_cRandom.Uniform(-4, 4);
    }
    m_cWorld.Add(desc);
  }
  void AddShape() {
    if (m_cWorld.GetShapeIds().size() > 28) return;
    const Vector2 p = m_cRandom.InSquare(3);
    const std::uint32_t kind = m_cRandom.Below(4);
    WithAnyShape(m_cRandom, kind, p, 1, [this](const auto& desc) { Dress(desc); });
  }
  void Load() {
    if (!m_stdSaved) return;
    m_cWorld.LoadState(m_stdSaved->first);
    m_cNow = m_stdSaved->second; // what began and was not told to have ended then
    ++m_nLoads;
  }

  CWorld& m_cWorld;
  CRandom m_cRandom;
  CShapeId m_cFloor; // stays
  std::optional<std::pair<CSavedState, CAccount>> m_stdSaved;
};

TEST_P(CSensorEventContract, EveryBeginHasItsEndWhateverHappens) {
  std::size_t open = 0;
  for (const CMode& mode : g_stdModes)
    for (std::uint64_t seed = 1; seed <= (mode.m_eProfile == eProfile::Shipped ? 4 : 2); ++seed) {
      SCOPED_TRACE(testing::Message() << mode.m_sName << ", seed " << seed);
      CEffectChoice choice = mode.m_cEffects;
      choice.m_cForced.Set(eEffect::Touches);
      // Every other game is on a floor.
      const auto pWorld = Make(choice, mode.m_eProfile, {0, seed % 2 == 0 ? -10.0f : 0.0f});
      CRandomGame game(*pWorld, seed);
      for (int step = 0; step < 400; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        game.Act();
        game.Act();
        game.KeepIn();
        ASSERT_NO_FATAL_FAILURE(game.Step());
      }
      EXPECT_GT(game.m_nBegins, 200u); // a game in which little happens would show little
      EXPECT_GT(game.m_nCrossed, 20u);
      EXPECT_GT(game.m_nSolidBegins, 50u);
      EXPECT_GT(game.m_nLoads, 0u);
      open += game.m_cNow.m_stdTouching.size();
      game.RemoveAll();
      ASSERT_NO_FATAL_FAILURE(game.Step());
      EXPECT_TRUE(game.m_cNow.m_stdTouching.empty() && game.m_cNow.m_stdSolid.empty());
      EXPECT_TRUE(pWorld->GetContacts().empty());
    }
  EXPECT_GT(open, 5u); // some did touch when everything was removed
}

} // namespace
} // namespace Shapes
