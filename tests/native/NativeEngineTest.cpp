// SPDX-License-Identifier: MIT
// The native world against the plain loop over the shapes themselves.
#include <Shapes/Shapes.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <functional>
#include <memory>
#include <vector>

#include "Random.h"

namespace Shapes {
namespace {

using Tests::CRandom;

// The loop that a game writes: everything moves, then every ball asks every shape, points first. Sensors are
// for after it.
class CPlainLoop : CShapeCommon {
public:
  CPlainLoop(float dt, float gravity) {
    m_fTimeStep = dt;
    m_fGravity = gravity;
  }

  void Add(std::unique_ptr<CShape> pShape) { m_stdShapes.push_back(std::move(pShape)); }
  void Add(const CDynamicCircleDesc& desc) { m_stdBalls.push_back(std::make_unique<CDynamicCircle>(desc)); }

  void Step() {
    for (auto& pShape : m_stdShapes)
      pShape->move();
    for (auto& pBall : m_stdBalls)
      pBall->move();
    for (auto& pBall : m_stdBalls)
      for (const bool points : {true, false})
        for (auto& pShape : m_stdShapes)
          if ((pShape->GetShapeType() == eShape::Point) == points) Meet(*pShape, *pBall);
    for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
      for (std::size_t j = i + 1; j < m_stdBalls.size(); ++j)
        Meet(*m_stdBalls[j], *m_stdBalls[i]);
  }

  std::vector<std::unique_ptr<CShape>> m_stdShapes;
  std::vector<std::unique_ptr<CDynamicCircle>> m_stdBalls;
  std::size_t m_nContacts = 0;

private:
  void Meet(CShape& shape, CDynamicCircle& ball) {
    if (shape.GetSensor() || ball.GetSensor()) return;
    CContactDesc c(&shape, &ball);
    if (!GetBackend(eBackend::Native)->CollisionDetected(c)) return;
    ball.CollisionResponse(c);
    ++m_nContacts;
  }
};

template <class TStatic, class TKinematic, class TDesc>
void AddToBoth(CPlainLoop& loop, CWorld& world, const TDesc& desc) {
  if (desc.m_eMotionType == eMotion::Kinematic)
    loop.Add(std::make_unique<TKinematic>(desc));
  else
    loop.Add(std::make_unique<TStatic>(desc));
  world.Add(desc);
}

// Hundreds of shapes of all kinds, some turning, some sensors, some one-sided, in a box that is crowded
// enough for a ball to touch several at once.
void Fill(CPlainLoop& loop, CWorld& world, CRandom& random, int shapes, int balls) {
  const auto place = [&] { return random.InSquare(10); };
  for (int i = 0; i < shapes; ++i) {
    const Vector2 p = place();
    const auto dress = [&](auto& desc) {
      desc.m_fElasticity = random.Uniform(0.5f, 1.1f);
      desc.m_bIsSensor = random.Uniform(0, 1) < 0.1f;
      if (random.Uniform(0, 1) < 0.2f) {
        desc.m_eMotionType = eMotion::Kinematic;
        desc.m_fRotSpeed = random.Uniform(-2, 2);
        desc.m_vRotCenter = p;
      }
    };
    const auto sides = [&] {
      const float f = random.Uniform(0, 1);
      return f < 0.15f ? eSides::Front : f < 0.3f ? eSides::Back : eSides::Both;
    };
    switch (i % 4) {
    case 0: {
      CPointDesc desc(p);
      dress(desc);
      AddToBoth<CPoint, CKinematicPoint>(loop, world, desc);
      break;
    }
    case 1: {
      CLineSegDesc desc(p, p + random.InSquare(2));
      dress(desc);
      desc.m_eSides = sides();
      AddToBoth<CLineSeg, CKinematicLineSeg>(loop, world, desc);
      break;
    }
    case 2: {
      CCircleDesc desc(p, random.Uniform(0.05f, 0.8f));
      dress(desc);
      AddToBoth<CCircle, CKinematicCircle>(loop, world, desc);
      break;
    }
    default: {
      CArcDesc desc(p, random.Uniform(0.2f, 1.5f), random.Uniform(0, 6.2f), random.Uniform(0, 6.2f));
      dress(desc);
      desc.m_eSides = sides();
      AddToBoth<CArc, CKinematicArc>(loop, world, desc);
    }
    }
  }
  AddToBoth<CArc, CKinematicArc>(loop, world, CArcDesc({0, 0}, 16, 0, 0));
  for (int i = 0; i < balls; ++i) {
    CDynamicCircleDesc desc(place(), random.Uniform(0.02f, 0.4f), random.InSquare(8), random.Uniform(0.1f, 5),
                            random.Uniform(0.7f, 1));
    desc.m_bIsSensor = i % 17 == 0;
    loop.Add(desc);
    world.Add(desc);
  }
}

bool SameBits(const CPlainLoop& loop, const CWorld& world) {
  for (std::size_t i = 0; i < loop.m_stdBalls.size(); ++i) {
    const Vector2 &p = loop.m_stdBalls[i]->GetPos(), &v = loop.m_stdBalls[i]->GetVel();
    if (std::memcmp(&p, &world.GetBallPositions()[i], sizeof p) != 0) return false;
    if (std::memcmp(&v, &world.GetBallVelocities()[i], sizeof v) != 0) return false;
  }
  return true;
}

std::unique_ptr<CWorld> MakeNativeWorld(float dt, float gravity) {
  CWorldDesc desc;
  desc.m_fTimeStep = dt;
  desc.m_vGravity = {0, gravity};
  desc.m_cEffects = g_cApproximate;
  return GetBackend(eBackend::Native)->MakeWorld(desc);
}

TEST(NativeWorldTest, HasTheBitsOfThePlainLoop) {
  for (const std::uint64_t seed : {1u, 2u}) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    constexpr float dt = 1.0f / 120.0f, gravity = -4.0f;
    auto pWorld = MakeNativeWorld(dt, gravity);
    CPlainLoop loop(dt, gravity);
    Fill(loop, *pWorld, random, 300, 30);
    for (int step = 0; step < 2000; ++step) {
      loop.Step();
      pWorld->Step();
      ASSERT_TRUE(SameBits(loop, *pWorld)) << "after step " << step;
    }
    EXPECT_EQ(pWorld->GetStats().m_nContacts, loop.m_nContacts);
    EXPECT_GT(loop.m_nContacts, 10000u); // a scene in which little happens would show little
    EXPECT_GT(pWorld->GetStats().m_nSensorHits, 1000u);
    // No all-pairs loop: it would have tested 301 * 30 shapes a step.
    EXPECT_LT(pWorld->GetStats().m_nShapeTests, 2000u * 301u * 30u / 5u);
    EXPECT_LT(pWorld->GetStats().m_nBallTests, 2000u * 30u * 29u / 2u / 5u);
  }
}

TEST(NativeWorldTest, HasTheBitsOfThePlainLoopFarFromTheOrigin) {
  // At 1e5 a coordinate has steps of .008: boxes without padding lose contacts there.
  CRandom random(4);
  auto pWorld = MakeNativeWorld(1.0f / 60.0f, 0);
  CPlainLoop loop(1.0f / 60.0f, 0);
  const Vector2 far(1e5f, -1e5f);
  for (int i = 0; i < 40; ++i) {
    const Vector2 p = far + random.InSquare(3);
    AddToBoth<CCircle, CKinematicCircle>(loop, *pWorld, CCircleDesc(p, 0.3f));
    AddToBoth<CLineSeg, CKinematicLineSeg>(loop, *pWorld,
                                           CLineSegDesc(p, p + Vector2(0.7f, random.Uniform(-1, 1))));
    const CDynamicCircleDesc ball(far + random.InSquare(3), 0.2f, random.InSquare(3));
    loop.Add(ball);
    pWorld->Add(ball);
  }
  for (int step = 0; step < 1000; ++step) {
    loop.Step();
    pWorld->Step();
    ASSERT_TRUE(SameBits(loop, *pWorld)) << "after step " << step;
  }
  EXPECT_GT(loop.m_nContacts, 1000u);
}

TEST(NativeWorldTest, ABallFarOutAmongOthersEndsTheStep) {
  // Between 2^53 and 2^54 cells from the origin every other cell number is no double: counting them never
  // ended.
  auto pWorld = MakeNativeWorld(1.0f / 60.0f, 0);
  pWorld->Add(CDynamicCircleDesc({0x1.8p51f, 0}, 0.5f));
  for (int i = 0; i < 20; ++i)
    pWorld->Add(CDynamicCircleDesc({static_cast<float>(i), 0}, 0.1f));
  pWorld->Step();
  EXPECT_EQ(pWorld->GetStats().m_nSteps, 1u);
}

TEST(NativeWorldTest, AShapeThatWentFarAndCameBackIsMetAsByThePlainLoop) {
  // Its ends were rounded out there; normal and box have to follow the rounded ones.
  CPlainLoop loop(1.0f / 60.0f, 0);
  auto pWorld = MakeNativeWorld(1.0f / 60.0f, 0);
  const CLineSegDesc desc({0, 0}, {0.05f, 0.05f});
  AddToBoth<CLineSeg, CKinematicLineSeg>(loop, *pWorld, desc);
  const CShapeId id{1};
  for (const Vector2& p : {Vector2(1e6f, 2.5e6f), Vector2(0, 0)}) {
    loop.m_stdShapes[0]->SetPos(p);
    pWorld->SetPos(id, p);
  }
  const CDynamicCircleDesc desc0({0, 0}, 1);
  loop.Add(desc0);
  const CShapeId ball = pWorld->Add(desc0);
  CRandom random(9);
  for (int i = 0; i < 500; ++i) {
    const Vector2 p = random.InSquare(1);
    loop.m_stdBalls[0]->SetPos(p);
    loop.m_stdBalls[0]->SetVel({0, 0});
    pWorld->SetPos(ball, p);
    pWorld->SetVel(ball, {0, 0});
    loop.Step();
    pWorld->Step();
    ASSERT_TRUE(SameBits(loop, *pWorld)) << p.transpose();
  }
  EXPECT_EQ(pWorld->GetStats().m_nContacts, loop.m_nContacts);
  EXPECT_GT(loop.m_nContacts, 10u);
}

TEST(NativeWorldTest, OrderIsWhatThePlainLoopSays) {
  // The control of the comparison above: a loop with one rule broken (points last) gives other bits.
  constexpr float dt = 1.0f / 60.0f;
  CWorldDesc desc;
  desc.m_fTimeStep = dt;
  desc.m_cEffects = g_cApproximate;
  auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
  pWorld->Add(CLineSegDesc({0, 0}, {1, 0})); // added before the point, but the point is met first
  const CShapeId guard = pWorld->Add(CPointDesc(Vector2(0, 0)));
  pWorld->Add(CDynamicCircleDesc({0.05f, 0.11f}, 0.1f, {0, -2}));
  pWorld->Step();
  ASSERT_FALSE(pWorld->GetContacts().empty());
  EXPECT_EQ(pWorld->GetContacts()[0].m_cShape, guard);
  EXPECT_GT(pWorld->GetBallVelocities()[0].x(), 0.5f); // off the end, not straight up

  CLineSeg seg(CLineSegDesc({0, 0}, {1, 0}));
  CDynamicCircle ball(CDynamicCircleDesc({0.05f, 0.11f - 2 * dt}, 0.1f, {0, -2}));
  CContactDesc c(&seg, &ball);
  ASSERT_TRUE(GetBackend(eBackend::Native)->CollisionDetected(c));
  ball.CollisionResponse(c);
  EXPECT_FLOAT_EQ(ball.GetVel().x(), 0.0f); // what the segment would have done had it been first
}

TEST(NativeWorldTest, ABallMovedByAResponseMeetsWhatItWasMovedInto) {
  // A deep response throws the ball by more than the slack of the candidates, into a wall of a later id.
  auto pWorld = MakeNativeWorld(1.0f / 60.0f, 0);
  CPlainLoop loop(1.0f / 60.0f, 0);
  AddToBoth<CPoint, CKinematicPoint>(loop, *pWorld, CPointDesc(Vector2(0, 0)));
  AddToBoth<CLineSeg, CKinematicLineSeg>(loop, *pWorld, CLineSegDesc({0.55f, -3}, {0.55f, 3}));
  const CDynamicCircleDesc ball({0.01f, 0}, 0.3f, {0, 0});
  loop.Add(ball);
  pWorld->Add(ball);
  loop.Step();
  pWorld->Step();
  EXPECT_EQ(pWorld->GetContacts().size(), 2u);
  EXPECT_TRUE(SameBits(loop, *pWorld));
}

// What one change costs must not depend on how many other shapes there are. The control is a shape that comes
// and goes, for which the tree is built anew.
TEST(NativeWorldTest, AChangeOfOneShapeCostsNoMoreAmongMany) {
  struct CChange {
    const char* m_sName;
    std::function<void(CWorld&, CShapeId ball, CShapeId flipper, int i)> m_stdChange;
    bool m_bIsControl = false;
  };
  const CChange changes[] = {
      {"the place of a ball",
       [](CWorld& w, CShapeId ball, CShapeId, int i) {
         w.SetPos(ball, {-100.0f, static_cast<float>(i)});
       }},
      {"the elasticity of a ball", [](CWorld& w, CShapeId ball, CShapeId,
                                      int i) { w.SetElasticity(ball, 0.1f * static_cast<float>(i % 5)); }},
      {"a ball that cannot collide",
       [](CWorld& w, CShapeId ball, CShapeId, int i) { w.SetCanCollide(ball, i % 2 == 0); }},
      {"the place of a flipper",
       [](CWorld& w, CShapeId, CShapeId flipper, int i) {
         w.SetPos(flipper, {-100.0f, 50.0f + 0.01f * static_cast<float>(i % 9)});
       }},
      {"the orientation of a flipper",
       [](CWorld& w, CShapeId, CShapeId flipper, int i) {
         w.SetOrientation(flipper, 0.1f * static_cast<float>(i % 9));
       }},
      {"a post that sinks",
       [](CWorld& w, CShapeId, CShapeId, int i) { w.SetCanCollide(CShapeId{2}, i % 2 == 0); }},
      {"a shape that comes and goes",
       [](CWorld& w, CShapeId, CShapeId, int) {
         w.Remove(w.Add(CPointDesc({-90.0f, 0.0f})));
       },
       true},
  };
  for (const CChange& change : changes) {
    const auto seconds = [&](int points) {
      const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(CWorldDesc());
      CLineSegDesc desc({-100, 50}, {-99, 50});
      desc.m_eMotionType = eMotion::Kinematic;
      const CShapeId flipper = pWorld->Add(desc);
      for (int i = 0; i < points; ++i)
        pWorld->Add(CPointDesc({static_cast<float>(i % 100), static_cast<float>(i / 100)}));
      const CShapeId ball = pWorld->Add(CDynamicCircleDesc({-100, 0}, 0.1f));
      pWorld->Step();
      double best = 1.0;
      for (int round = 0; round < 5; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < 40; ++i) {
          change.m_stdChange(*pWorld, ball, flipper, i);
          pWorld->Step();
        }
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      }
      return best;
    };
    const double few = seconds(40), many = seconds(4000);
    if (change.m_bIsControl)
      EXPECT_GT(many, 15.0 * few) << change.m_sName;
    else
      EXPECT_LT(many, 8.0 * few) << change.m_sName;
  }
}

TEST(NativeWorldTest, TunnelsHeadOnAsOftenAsTheFormulaSays) {
  // A ball that moves L a step at a wall is turned back with probability min(1, r/L), and is not noticed at
  // all with probability max(0, 1 - 2 r/L). 4000 phases in equal steps: the rate is exact within two phases.
  constexpr float dt = 1.0f / 60.0f, r = 0.1f;
  for (const float ratio : {0.5f, 1.0f, 1.5f, 2.0f, 4.0f}) {
    int tunneled = 0, missed = 0;
    constexpr int phases = 4000;
    for (int k = 0; k < phases; ++k) {
      const float L = ratio * r;
      auto pWorld = MakeNativeWorld(dt, 0);
      pWorld->Add(CLineSegDesc({-1, 0}, {1, 0}));
      pWorld->Add(CDynamicCircleDesc({0, r + L * (static_cast<float>(k) + 0.5f) / phases}, r, {0, -L / dt}));
      bool met = false;
      for (int step = 0; step < 6; ++step) {
        pWorld->Step();
        met |= !pWorld->GetContacts().empty();
      }
      tunneled += pWorld->GetBallPositions()[0].y() < 0;
      missed += !met;
    }
    EXPECT_NEAR(tunneled, phases * std::max(0.0f, 1 - 1 / ratio), 3) << "v dt / r = " << ratio;
    EXPECT_NEAR(missed, phases * std::max(0.0f, 1 - 2 / ratio), 3) << "v dt / r = " << ratio;
  }
}

// An arc that goes on from a segment: its end, (0, 0), is rounded to (1.19e-8, 0).
TEST(NativeWorldTest, NoBallFallsBetweenASegmentAndAnArcThatGoesOn) {
  CWorldDesc desc;
  desc.m_cEffects = g_cApproximate;
  int missed = 0;
  for (float x = 0.0f; x < 2e-8f; x += 1e-10f) {
    const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
    pWorld->Add(CLineSegDesc({-2, 0}, {0, 0}));
    pWorld->Add(CArcDesc({0, 1}, 1, 1.5f * g_fPi, 0));
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({x, 0.11f}, 0.1f, {0, -3}));
    pWorld->Step();
    missed += !(pWorld->GetVel(ball).y() > 0.0f);
  }
  EXPECT_EQ(missed, 0);
}

// Without a cut the place of the ball is no number any more after 26,000 steps.
TEST(NativeWorldTest, TheLargestGravityIsFinite) {
  for (const CEffectChoice& effects : {g_cApproximate, g_cContinuous}) {
    CWorldDesc desc;
    desc.m_vGravity = {0, -g_fMaxSpeed};
    desc.m_fTimeStep = g_fMaxTimeStep;
    desc.m_cEffects = effects;
    const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
    for (int i = 0; i < 40000; ++i)
      pWorld->Step();
    EXPECT_TRUE(pWorld->GetPos(ball).allFinite()) << pWorld->GetPos(ball).transpose();
    EXPECT_NEAR(pWorld->GetVel(ball).y() / g_fMaxSpeed, -1.0f, 4 * 1.2e-7f); // the bound of CapSpeed
    EXPECT_GT(pWorld->GetStats().m_nSpeedsCapped, 0u);
  }
}

// As docs/effects.md says.
TEST(NativeWorldTest, TheApproximateModeFallsAheadOfTheParabola) {
  const double g = 8.0, dt = 1.0 / 64.0;
  for (const int steps : {1, 64, 128}) {
    CWorldDesc desc;
    desc.m_vGravity = {0, static_cast<float>(-g)};
    desc.m_fTimeStep = static_cast<float>(dt);
    desc.m_cEffects = g_cApproximate;
    const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 1, {0, 2}));
    for (int i = 0; i < steps; ++i)
      pWorld->Step();
    const double t = steps * dt, parabola = 2.0 * t - 0.5 * g * t * t;
    EXPECT_NEAR(static_cast<double>(pWorld->GetPos(ball).y()), parabola - 0.5 * g * t * dt, 1e-5) << steps;
  }
}

TEST(NativeWorldTest, MovesThatAreLostToRoundingAreCounted) {
  // Half an ulp at 2^23 is .5: what moves by less in a step does not move at all.
  for (const auto& [move, lost] : {std::pair(0.25f, 3u), std::pair(1.0f, 0u), std::pair(0.0f, 0u)}) {
    CWorldDesc desc;
    desc.m_fTimeStep = 1.0f;
    desc.m_cEffects = g_cApproximate;
    const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(desc);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0x1p23f, 0}, 10, {move, 0}));
    for (int i = 0; i < 3; ++i)
      pWorld->Step();
    EXPECT_EQ(pWorld->GetStats().m_nMovesLost, lost) << move;
    EXPECT_EQ(pWorld->GetPos(ball).x(), 0x1p23f + (lost > 0 ? 0.0f : 3 * move));
  }
}

} // namespace
} // namespace Shapes
