// SPDX-License-Identifier: MIT
#include "metrics/EngineResponse.h"

#include "MadeScenes.h"

namespace Shapes::Compare::Tests {
namespace {

CContactEvent MakeEvent(float speed, float setback, float impulse) {
  CContactEvent event;
  event.m_fSpeed = speed;
  event.m_fSetback = setback;
  event.m_fImpulse = impulse;
  return event;
}

TEST(EngineResponse, IsWhatChangesTheVelocityOrThePlaceOfABall) {
  EXPECT_TRUE(IsResponse(MakeEvent(1, 0, 0)));
  EXPECT_TRUE(IsResponse(MakeEvent(0, 1, 0)));
  EXPECT_TRUE(IsResponse(MakeEvent(0, 0, 1)));
  EXPECT_FALSE(IsResponse(MakeEvent(0, 0, 0)));
  CContactEvent sensor = MakeEvent(1, 0, 1);
  sensor.m_bIsSensor = true;
  EXPECT_FALSE(IsResponse(sensor));
}

// A ball that lies is carried in every step, and bounces in none.
TEST(EngineResponse, ABallThatLiesIsCarriedAndDoesNotBounce) {
  for (const CBackend& backend : GetBackends()) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -10};
    const auto pWorld = backend.MakeWorld(desc);
    pWorld->Add(CLineSegDesc({-5, 0}, {5, 0}));
    CDynamicCircleDesc ball({0, 0.5f}, 0.5f);
    ball.m_fElasticity = 0.0f;
    const CShapeId id = pWorld->Add(ball);
    pWorld->Step();
    pWorld->Step();
    EXPECT_EQ(CountBounces(*pWorld), 0u) << backend.GetName();
    const auto contacts = pWorld->GetContacts();
    EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [&](const CContactEvent& event) {
      return AsSeenBy(event, id).has_value();
    })) << backend.GetName();
  }
}

// Balls that are held by a wall before they could bounce off it have been answered: in a chute of Box2D, in a
// pile on native.
TEST(EngineResponse, BallsThatAreHeldHaveBeenAnswered) {
  const auto count = [](const char* pScene, std::string_view engine) {
    std::vector<CEngine> engines = GetEngines();
    std::erase_if(engines, [&](const CEngine& e) { return e.m_sName != engine; });
    const CImpactTrialResult result = Judge(LoadBundled(pScene), 2000, 100000, 1, engines);
    EXPECT_GE(result.m_stdContacts.size(), 2000u);
    return std::count_if(result.m_stdContacts.begin(), result.m_stdContacts.end(),
                         [](const CContact& c) { return c.m_stdEngines[0].m_eOutcome == eOutcome::Missed; });
  };
  EXPECT_EQ(count("chute", "box2d-tuned"), 0);
  EXPECT_EQ(count("closing_gates", "native"), 0);
}

} // namespace
} // namespace Shapes::Compare::Tests
