// SPDX-License-Identifier: MIT
// Box2D ends the process where it asserts, and Debian's library keeps its asserts. What is at the border of
// what it bears is stepped, in both profiles, and everything stays a number; what is beyond is refused.
#include "Box2DTesting.h"
#include "box2d_backend/world/Tuning.h"
#include "fuzz/Fuzz.h"
#include "traps/Traps.h"

namespace Shapes::Box2D {
namespace {

constexpr float g_fDenormal = std::numeric_limits<float>::denorm_min();

float Above(float f) { return std::nextafter(f, g_fInf); }
float Below(float f) { return std::nextafter(f, 0.0f); }

// The control: this is what the library keeps away from Box2D.
TEST(NoAssertDeathTest, Box2DEndsTheProcess) {
  const b2Vec2 close[] = {{0, 0}, {0.004f, 0}, {1, 0}};
  b2ChainShape chain;
  EXPECT_DEATH(chain.CreateChain(close, 3, {-1, 0}, {2, 0}), "Assertion");
  b2World world({0, 0});
  b2BodyDef def;
  def.position.Set(g_fNan, 0);
  EXPECT_DEATH(world.CreateBody(&def), "Assertion");
}

class CNoAssert : public Tests::CEveryProfile {
protected:
  // At the limits Box2D's own numbers may be infinite, but not its results.
  const CWithoutTraps m_cInBox2D;
  CNoAssert() { m_cDesc.m_cBox2D.m_eProfile = GetParam(); }

  /// User units to a metre of Box2D.
  float Unit() const { return m_cDesc.m_cBox2D.m_fLengthUnit / GetTuning(GetParam()).m_fScale; }
  float MaxLength() const { return std::min(g_fMaxLength, g_fMaxBox2DLength * Unit()); }
  float MaxSpeed() const { return std::min(g_fMaxSpeed, g_fMaxBox2DSpeed * Unit()); }
  void Make() { m_pWorld = GetBackend(eBackend::Box2D)->MakeWorld(m_cDesc); }

  /// Balls of no and of some size, at rest at p and on their way through it.
  void AddBalls(const Vector2& p) {
    for (const float r : {0.0f, 0.1f * Unit()})
      for (const float v : {0.0f, 0.9f})
        m_pWorld->Add(CDynamicCircleDesc(p + Vector2(0, v / 100 * Unit()), r, {0, -v * Unit()}));
  }

  void Step(int n = 3) {
    for (; n > 0; --n)
      m_pWorld->Step();
    EXPECT_NO_THROW(Fuzz::RequireSound(*m_pWorld));
  }

  /// With balls at its ends and its middle or centre.
  template <class TDesc>
  void StepStaticAndTurning(const TDesc& desc) {
    for (const TDesc& shape : {desc, Turning(desc, 1)}) {
      Make();
      m_pWorld->Add(shape);
      Vector2 p0, p1;
      shape.GetEndPts(p0, p1);
      for (const Vector2& p : {p0, p1, shape.m_vPos})
        AddBalls(p);
      Step();
    }
  }

  template <class TDesc>
  void ExpectRefused(const TDesc& desc) {
    EXPECT_THROW(m_pWorld->Add(desc), std::invalid_argument);
  }

  CWorldDesc m_cDesc;
  std::unique_ptr<CWorld> m_pWorld;
};
SHAPES_ON_EVERY_PROFILE(CNoAssert);

TEST_P(CNoAssert, SegmentsOfAnyLength) {
  for (const float metres : {0.0f, g_fDenormal, 1e-30f, 0.004f, Below(b2_linearSlop), b2_linearSlop,
                             Above(b2_linearSlop), Below(g_fShortestEdge), g_fShortestEdge, 1e4f, 1e8f})
    for (const eSides sides : {eSides::Both, eSides::Front, eSides::Back})
      StepStaticAndTurning(Sided(CLineSegDesc({0, 0}, {metres * Unit(), 0}), sides));
}

TEST_P(CNoAssert, ArcsOfAnyRadiusAndSpan) {
  for (const float metres :
       {0.0f, g_fDenormal, 1e-30f, 0.001f, 0.0025f, b2_linearSlop, g_fShortestEdge, 0.1f, 1e3f})
    for (const float span :
         {g_fDenormal, 1e-6f, 0.001f, 0.01f, 0.1f, g_fPi, 6.0f, Below(Below(Below(g_fTwoPi))), g_fTwoPi})
      StepStaticAndTurning(
          Sided(CArcDesc({0, 0}, metres * Unit(), 0, span), span < 1 ? eSides::Front : eSides::Both));
}

TEST_P(CNoAssert, TheLimitsAreTakenAndTheNextFloatIsNot) {
  for (const float unit : {1.0f, 1e-3f, 100.0f}) {
    m_cDesc.m_cBox2D.m_fLengthUnit = unit;
    Make();
    const float length = MaxLength(), speed = MaxSpeed();
    ExpectRefused(CPointDesc({Above(length), 0}));
    for (const float sign : {1.0f, -1.0f}) {
      m_pWorld->Add(CPointDesc({sign * length, sign * length}));
      m_pWorld->Add(CDynamicCircleDesc({sign * length, -sign * length}, 0));
      ExpectRefused(CDynamicCircleDesc({0, sign * Above(length)}, 0));
    }
    m_pWorld->Add(CCircleDesc({0, 0}, length));
    ExpectRefused(CCircleDesc({0, 0}, Above(length)));
    m_pWorld->Add(CArcDesc({0, 0}, length, 0, 0));
    m_pWorld->Add(CLineSegDesc({-length, -length}, {length, length}));
    for (const float m : {g_fMinBox2DMass, g_fMaxBox2DMass})
      m_pWorld->Add(CDynamicCircleDesc({0, 0}, unit, {speed, -speed}, m));
    for (const float m : {Below(g_fMinBox2DMass), Above(g_fMaxBox2DMass)})
      ExpectRefused(CDynamicCircleDesc({0, 0}, unit, {0, 0}, m));
    ExpectRefused(CDynamicCircleDesc({0, 0}, unit, {Above(speed), 0}));
    m_pWorld->SetGravity({speed, -speed});
    EXPECT_THROW(m_pWorld->SetGravity({Above(speed), 0}), std::invalid_argument);
    m_pWorld->SetPos(m_pWorld->GetBallIds()[0], {length, length});
    EXPECT_THROW(m_pWorld->SetPos(m_pWorld->GetBallIds()[0], {0, Above(length)}), std::invalid_argument);
    Step();
  }
}

TEST_P(CNoAssert, WorldDescriptionsAtTheirLimits) {
  const auto step = [&](auto change) {
    m_cDesc = CWorldDesc();
    m_cDesc.m_cBox2D.m_eProfile = GetParam();
    change(m_cDesc);
    Make();
    m_pWorld->SetGravity({0, -std::min(10 * Unit(), MaxSpeed())});
    m_pWorld->Add(CArcDesc({0, 0}, 0.5f * Unit(), 0, 3));
    m_pWorld->Add(CCircleDesc({0, 0}, 0.5f * Unit()));
    AddBalls({0, 0});
    AddBalls({0, 0.5f * Unit()});
    Step();
  };
  for (const float f : {g_fMinTimeStep, 1e-20f, 1e3f, g_fMaxTimeStep})
    step([&](CWorldDesc& d) { d.m_fTimeStep = f; });
  for (const float f : {g_fMinLengthUnit, 1e-9f, 1e9f, g_fMaxLength})
    step([&](CWorldDesc& d) { d.m_cBox2D.m_fLengthUnit = f; });
  for (const float f : {g_fDenormal, 1e-30f, 1.0f, g_fMaxLength})
    step([&](CWorldDesc& d) { d.m_cBox2D.m_fSagittaTolerance = f; });
  for (const unsigned n : {1u, 1000u})
    step([&](CWorldDesc& d) { d.m_cBox2D.m_nVelocityIterations = d.m_cBox2D.m_nPositionIterations = n; });
  step([](CWorldDesc& d) { d.m_nSubsteps = 64; });
  // A metre of a tuned world would have been infinitely many of these units.
  for (const float f : {Below(g_fMinLengthUnit), g_fDenormal})
    EXPECT_THROW(step([&](CWorldDesc& d) { d.m_cBox2D.m_fLengthUnit = f; }), std::invalid_argument);
}

TEST_P(CNoAssert, TheFastestSurfaceAndTheLargestElasticityGiveASpeedThatIsANumber) {
  for (const float unit : {1.0f, 1e10f, 1e17f})
    for (const float dt : {g_fMinTimeStep, 1.0f / 60.0f, g_fMaxTimeStep}) {
      m_cDesc.m_cBox2D.m_fLengthUnit = unit;
      m_cDesc.m_fTimeStep = dt;
      Make();
      m_pWorld->Add(Turning(CLineSegDesc({-Unit(), 0}, {Unit(), 0}, g_fMaxElasticity), g_fMaxRotSpeed,
                            Vector2{-0.9f * MaxLength(), 0}));
      m_pWorld->SetGravity({0, -MaxSpeed()});
      for (const auto& [y, m] : {std::pair(0.1f, g_fMaxBox2DMass), std::pair(0.25f, g_fMinBox2DMass)})
        m_pWorld->Add(CDynamicCircleDesc({0, y * Unit()}, 0.1f * Unit(), {0, 0}, m, g_fMaxElasticity));
      Step();
    }
}

TEST_P(CNoAssert, BumpersThatHoldABallFastTakeNoMoreThanTheMostCuts) {
  // The ball gets faster in each cut, and would ask for more of them for ever.
  Make();
  for (const float x : {-0.05f, 0.05f})
    m_pWorld->Add(CLineSegDesc({x, -1}, {x, 1}, g_fMaxElasticity));
  m_pWorld->Add(CDynamicCircleDesc({0, 0}, 0.06f, {1, 0}, 1, g_fMaxElasticity));
  Step(1);
  EXPECT_LE(m_pWorld->GetStats().m_nEngineSteps, g_nMaxAdaptiveSubsteps);
  EXPECT_EQ(m_pWorld->GetStats().m_nEngineSteps > 1, IsTuned());
}

TEST_P(CNoAssert, ABumpedBallGoesNoFartherThanBox2DMovesIt) {
  // In a tuned world each of many hits multiplies how far it is off its parabola.
  m_cDesc.m_fTimeStep = 1000;
  Make();
  m_pWorld->SetGravity({1e6f, 0});
  for (const float y : {0.0f, 1.0f})
    m_pWorld->Add(CLineSegDesc({-5, y}, {5, y + 0.5f}, g_fMaxElasticity));
  m_pWorld->Add(CDynamicCircleDesc({0, 0.4f}, 0.3f, {0, 1}));
  m_pWorld->Add(CDynamicCircleDesc({0.5f, 0.5f}, 2.0f, {0, 1}, 1, 1000));
  Step(1);
  // In each cut 2 metres by Box2D, 2 by the deviation, and what pushes overlapping shapes apart: less than 8.
  const float most = 12 * Unit() * static_cast<float>(m_pWorld->GetStats().m_nEngineSteps);
  for (const Vector2& p : m_pWorld->GetBallPositions())
    EXPECT_LE(p.norm(), most);
}

TEST_P(CNoAssert, BouncyBallsInEachOtherStayNumbers) {
  // In a tuned world each of many impacts in a step multiplies what a ball is faster on its parabola.
  m_cDesc.m_vGravity = {0, -2.5f};
  Make();
  m_pWorld->Add(CPointDesc({-0.076f, -0.085f}, 2));
  m_pWorld->Add(CDynamicCircleDesc({-0.076f, -0.085f}, 0.25f, {-1.2e8f, 3.6e7f}, 1, 1000));
  m_pWorld->Add(CDynamicCircleDesc({-0.11f, 0.1f}, 0.025f, {0, 0}, 1, g_fMaxElasticity));
  m_pWorld->Add(CDynamicCircleDesc({0.01f, -0.57f}, 2.5f, {0.24f, 0.07f}));
  Step(10);
}

} // namespace
} // namespace Shapes::Box2D
