// SPDX-License-Identifier: MIT
// Begin and end of what sensors see and of solid contacts: every begin has its end, whatever happens to the
// world.
#include "../fuzz/WorldTrial.h"
#include "Backends.h"

namespace Shapes {
namespace {

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

// Shapes and balls in a square, and balls that move by up to one unit a step.
class CGameSource {
public:
  explicit CGameSource(std::uint64_t seed) : m_cRandom(seed) {}

  unsigned Below(unsigned n) { return m_cRandom.Below(n); }
  bool Flag() { return m_cRandom.Coin(); }
  Vector2 Pos() { return m_cRandom.InSquare(3); }
  Vector2 Vel() { return m_cRandom.InSquare(60); }
  Vector2 Gravity() { return {0, m_cRandom.Coin() ? -10.0f : 0.0f}; }
  float Angle() { return m_cRandom.Uniform(0, 6); }
  float RotSpeed() { return m_cRandom.Uniform(-4, 4); }
  float Elasticity() { return m_cRandom.Coin() ? 1.0f : 0.5f; }

  CAnyShapeDesc Shape(unsigned what) {
    if (what < 4)
      return WithAnyShape(m_cRandom, what, Pos(), 1, [this](const auto& desc) { return Dressed(desc); });
    CDynamicCircleDesc ball{Pos(), m_cRandom.Uniform(0.05f, 0.3f)};
    ball.m_vVel = Vel();
    ball.m_bIsSensor = m_cRandom.Below(4) == 0;
    ball.m_fElasticity = Elasticity();
    return ball;
  }
  std::vector<CAnyShapeDesc> Parts() { return {Shape(Below(4)), Shape(Below(4))}; }

private:
  template <class TDesc>
  CAnyShapeDesc Dressed(TDesc desc) {
    desc.m_bIsSensor = m_cRandom.Coin();
    // The open side of a sensor is seen like the solid one.
    if constexpr (requires { desc.m_eSides; }) {
      if (m_cRandom.Coin()) desc.m_eSides = m_cRandom.Coin() ? eSides::Front : eSides::Back;
    }
    return m_cRandom.Below(3) == 0 ? Turning(desc, RotSpeed(), desc.m_vPos) : desc;
  }

  CRandom m_cRandom;
};
using CRandomGame = Fuzz::CWorldTrial<CGameSource>;

std::vector<CShapeId> AllIds(const CWorld& world) {
  std::vector<CShapeId> ids(world.GetShapeIds());
  ids.insert(ids.end(), world.GetBallIds().begin(), world.GetBallIds().end());
  return ids;
}

// A touch that has begun and not ended is one that lasts.
void ExpectSensed(const CRandomGame& game) {
  const CWorld& world = game.GetWorld();
  const std::vector<CShapeId> ids = AllIds(world);
  for (const CShapeId ball : world.GetBallIds())
    for (const CShapeId id : ids) {
      const bool isBall = world.GetMotionType(id) == eMotion::Dynamic;
      if (isBall && id <= ball) continue;
      const bool on = world.GetCanCollide(ball) && world.GetCanCollide(id) &&
                      (world.GetSensor(ball) || world.GetSensor(id)) &&
                      DoMeet(world.GetFilter(ball), world.GetFilter(id));
      const Vector2 p = world.GetPos(ball);
      // An arc is a curve; ends belong to what they end.
      const float d = isBall ? GetDistance(world, id, p) : SensedDistanceFrom(world.GetShape(id), p),
                  gap = d - world.GetRadius(ball);
      if (on && std::abs(gap) < 1e-5f) continue; // rounding decides: some ulp of coordinates up to 5
      ASSERT_EQ(game.GetSensed().contains({ball, id}), on && gap < 0) << "gap " << gap;
    }
}

TEST_P(CSensorEventContract, EveryBeginHasItsEndWhateverHappens) {
  // Those that put something there, that turn something on or off, and that save and load.
  constexpr unsigned operations[] = {0, 1, 2, 3, 4, 4, 4, 5, 10, 11, 13, 14, 15, 15, 15, 20, 20, 21, 21, 23};
  std::size_t open = 0;
  for (const CMode& mode : g_stdModes)
    for (std::uint64_t seed = 1; seed <= (mode.m_eProfile == eProfile::Shipped ? 4 : 2); ++seed) {
      SCOPED_TRACE(testing::Message() << mode.m_sName << ", seed " << seed);
      CEffectChoice choice = mode.m_cEffects;
      choice.m_cForced.Set(eEffect::Touches);
      CGameSource source(seed);
      CRandomGame game(source);
      // Every other game is on a floor.
      game.Make(Backend(), Described({0, seed % 2 == 0 ? -10.0f : 0.0f}, g_fDt, 1, choice, mode.m_eProfile));
      CWorld& world = game.GetWorld();
      world.Add(CLineSegDesc({-5, -3.5f}, {5, -3.5f}));
      for (int step = 0; step < 400; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        for (int i = 0; i < 2; ++i) {
          const unsigned operation = operations[source.Below(std::size(operations))];
          const std::size_t there = operation == 4 ? world.GetBallIds().size() : world.GetShapeIds().size();
          const bool isRoom = operation > 5 || there < (operation == 4 ? 12 : 24);
          if (isRoom) {
            ASSERT_NO_THROW(game.Do(operation));
          }
        }
        for (const CShapeId id : AllIds(world)) // puts back what flew away
          if (world.GetPos(id).cwiseAbs().maxCoeff() > 4) world.SetPos(id, source.Pos());
        ASSERT_NO_THROW(game.Step());
        ASSERT_NO_FATAL_FAILURE(ExpectSensed(game));
      }
      EXPECT_GT(game.m_nBegins, 200u); // a game in which little happens would show little
      EXPECT_GT(game.m_nCrossed, 20u);
      EXPECT_GT(game.m_nSolidBegins, 50u);
      EXPECT_GT(game.m_nLoads, 0u);
      open += game.GetSensed().size();
      for (const CShapeId id : AllIds(world))
        world.Remove(id);
      ASSERT_NO_THROW(game.Step());
      EXPECT_TRUE(game.GetSensed().empty() && game.GetTouching().empty());
      EXPECT_TRUE(world.GetContacts().empty());
    }
  EXPECT_GT(open, 5u); // some did touch when everything was removed
}

} // namespace
} // namespace Shapes
