// SPDX-License-Identifier: MIT
// The native world against the plain loop over the shapes themselves.
#include "NativeTesting.h"

#include <chrono>
#include <cstring>

namespace Shapes {
namespace {

/// A native world, and the loop over the same shapes that a game writes: everything moves, then every ball
/// asks every shape, points first. Sensors are for after it.
class CBoth : CShapeCommon {
public:
  explicit CBoth(float gravity = 0, float dt = g_fDt) : m_pWorld(MakeNative(g_cApproximate, gravity, dt)) {
    m_fTimeStep = dt;
    m_fGravity = -gravity;
  }

  template <class TDesc>
  CShapeId Add(const TDesc& desc) {
    const CShapeId id = m_pWorld->Add(desc);
    m_stdShapes.push_back(m_pWorld->GetShape(id).Clone());
    return id;
  }
  CShapeId Add(const CDynamicCircleDesc& desc) {
    m_stdBalls.push_back(std::make_unique<CDynamicCircle>(desc));
    return m_pWorld->Add(desc);
  }

  void Step() {
    m_pWorld->Step();
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

  void StepAndCompare(int steps) {
    for (int step = 0; step < steps; ++step) {
      Step();
      ASSERT_TRUE(HaveSameBits()) << "after step " << step;
    }
  }

  bool HaveSameBits() const {
    for (std::size_t i = 0; i < m_stdBalls.size(); ++i) {
      const Vector2 &p = m_stdBalls[i]->GetPos(), &v = m_stdBalls[i]->GetVel();
      if (std::memcmp(&p, &m_pWorld->GetBallPositions()[i], sizeof p) != 0) return false;
      if (std::memcmp(&v, &m_pWorld->GetBallVelocities()[i], sizeof v) != 0) return false;
    }
    return true;
  }

  std::unique_ptr<CWorld> m_pWorld;
  std::vector<std::unique_ptr<CShape>> m_stdShapes;
  std::vector<std::unique_ptr<CDynamicCircle>> m_stdBalls;
  std::size_t m_nContacts = 0; // of the loop

private:
  void Meet(CShape& shape, CDynamicCircle& ball) {
    if (shape.GetSensor() || ball.GetSensor()) return;
    CContactDesc c(&shape, &ball);
    if (!GetBackend(eBackend::Native)->CollisionDetected(c)) return;
    ball.CollisionResponse(c);
    ++m_nContacts;
  }
};

// A crowd in a ring, dense enough for a ball to touch several shapes at once.
void Fill(CBoth& both, CRandom& random, std::uint32_t shapes, int balls) {
  for (const CAnyShapeDesc& shape : MakeCrowd(random, shapes, 10, 1.5f))
    both.Add(shape);
  both.Add(CArcDesc({0, 0}, 16, 0, 0));
  for (int i = 0; i < balls; ++i) {
    const Vector2 p = random.InSquare(10), v = random.InSquare(8);
    const float r = random.Uniform(0.02f, 0.4f), mass = random.Uniform(0.1f, 5);
    CDynamicCircleDesc desc(p, r, v, mass, random.Uniform(0.7f, 1));
    desc.m_bIsSensor = i % 17 == 0;
    both.Add(desc);
  }
}

TEST(NativeWorldTest, HasTheBitsOfThePlainLoop) {
  for (const std::uint64_t seed : {1u, 2u}) {
    SCOPED_TRACE(seed);
    CRandom random(seed);
    CBoth both(4, 1.0f / 120.0f);
    Fill(both, random, 300, 30);
    both.StepAndCompare(600);
    const CWorldStats& stats = both.m_pWorld->GetStats();
    EXPECT_EQ(stats.m_nContacts, both.m_nContacts);
    EXPECT_GT(both.m_nContacts, 3000u); // a scene in which little happens would show little
    EXPECT_GT(stats.m_nSensorHits, 300u);
    // No all-pairs loop: it would have tested 301 * 30 shapes a step.
    EXPECT_LT(stats.m_nShapeTests, 600u * 301u * 30u / 5u);
    EXPECT_LT(stats.m_nBallTests, 600u * 30u * 29u / 2u / 5u);
  }
}

// By then the grid stands, and each is in a place where all but its rim is in the open.
TEST(NativeWorldTest, MeetsWhatASlowBallTouchesWithItsRim) {
  CRandom random(5);
  CBoth both;
  for (int i = 0; i < 64; ++i) {
    const Vector2 p(5.0f * static_cast<float>(i % 8), 5.0f * static_cast<float>(i / 8));
    both.Add(CPointDesc(p));
    const Vector2 away = random.VectorOfLength(1.1f, 1.3f);
    both.Add(CDynamicCircleDesc(p + away, 1.0f, -0.05f * away));
  }
  both.StepAndCompare(400);
  EXPECT_EQ(both.m_nContacts, 64u);
}

TEST(NativeWorldTest, HasTheBitsOfThePlainLoopFarFromTheOrigin) {
  // At 1e5 a coordinate has steps of .008: boxes without padding lose contacts there.
  CRandom random(4);
  CBoth both;
  const Vector2 far(1e5f, -1e5f);
  for (int i = 0; i < 40; ++i) {
    const Vector2 p = far + random.InSquare(3), q = far + random.InSquare(3);
    both.Add(CCircleDesc(p, 0.3f));
    both.Add(CLineSegDesc(p, p + Vector2(0.7f, random.Uniform(-1, 1))));
    both.Add(CDynamicCircleDesc(q, 0.2f, random.InSquare(3)));
  }
  both.StepAndCompare(1000);
  EXPECT_GT(both.m_nContacts, 1000u);
}

TEST(NativeWorldTest, AShapeThatWentFarAndCameBackIsMetAsByThePlainLoop) {
  // As it was made, though its ends were rounded out there.
  CBoth both;
  const CShapeId id = both.Add(CLineSegDesc({0, 0}, {0.05f, 0.05f}));
  for (const Vector2& p : {Vector2(1e6f, 2.5e6f), Vector2(0, 0)}) {
    both.m_stdShapes[0]->Relocate(p);
    both.m_pWorld->SetPos(id, p);
  }
  const CShapeId ball = both.Add(CDynamicCircleDesc({0, 0}, 1));
  CRandom random(9);
  for (int i = 0; i < 500; ++i) {
    const Vector2 p = random.InSquare(1);
    both.m_stdBalls[0]->SetPos(p);
    both.m_stdBalls[0]->SetVel({0, 0});
    both.m_pWorld->SetPos(ball, p);
    both.m_pWorld->SetVel(ball, {0, 0});
    both.Step();
    ASSERT_TRUE(both.HaveSameBits()) << p.transpose();
  }
  EXPECT_EQ(both.m_pWorld->GetStats().m_nContacts, both.m_nContacts);
  EXPECT_GT(both.m_nContacts, 10u);
}

// The cost of one change must not depend on how many other shapes there are. The control is a shape that
// comes and goes, for which the tree is built anew.
TEST(NativeWorldTest, AChangeOfOneShapeCostsNoMoreAmongMany) {
  using CChange = std::function<void(CWorld&, float)>; // by a number from 0 to 8
  const CShapeId flipper{1}, post{2};
  const auto seconds = [](const CChange& change, int points) {
    const auto pWorld = MakeNative(g_cAutomatic);
    pWorld->Add(Turning(CLineSegDesc({-100, 50}, {-99, 50})));
    for (int i = 0; i < points; ++i)
      pWorld->Add(CPointDesc({static_cast<float>(i % 100), static_cast<float>(i / 100)}));
    pWorld->Add(CDynamicCircleDesc({-100, 0}, 0.1f));
    pWorld->Step();
    double best = 1.0;
    for (int round = 0; round < 5; ++round) {
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < 40; ++i) {
        change(*pWorld, static_cast<float>(i * 5 % 9));
        pWorld->Step();
      }
      best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
  };
  const std::pair<const char*, CChange> changes[] = {
      {"the place of a ball", [](CWorld& w, float f) { w.SetPos(w.GetBallIds()[0], Vector2(-100, f)); }},
      {"the elasticity of a ball", [](CWorld& w, float f) { w.SetElasticity(w.GetBallIds()[0], 0.1f * f); }},
      {"a ball that cannot collide", [](CWorld& w, float f) { w.SetCanCollide(w.GetBallIds()[0], f < 4); }},
      {"the place of a flipper",
       [=](CWorld& w, float f) { w.SetPos(flipper, Vector2(-100, 50 + 0.01f * f)); }},
      {"the orientation of a flipper", [=](CWorld& w, float f) { w.SetOrientation(flipper, 0.1f * f); }},
      {"a post that sinks", [=](CWorld& w, float f) { w.SetCanCollide(post, f < 4); }},
  };
  for (const auto& [pName, change] : changes)
    EXPECT_LT(seconds(change, 4000), 8.0 * seconds(change, 40)) << pName;
  const CChange comesAndGoes = [](CWorld& w, float) { w.Remove(w.Add(CPointDesc({-90, 0}))); };
  EXPECT_GT(seconds(comesAndGoes, 4000), 15.0 * seconds(comesAndGoes, 40));
}

// Balls break all that they hit but the walls, and lines are drawn. The other world is loaded after each
// step, for which all boxes are made anew.
TEST(NativeWorldTest, ShapesThatComeAndGoAreMetWhileTheyAreThere) {
  for (const CEffectChoice& effects : {g_cAutomatic, g_cApproximate})
    for (const float gravity : {0.0f, 10.0f}) {
      SCOPED_TRACE(testing::Message() << "gravity " << gravity);
      const auto make = [&] {
        std::unique_ptr<CWorld> pWorld = MakeNative(effects, gravity);
        AddBox(*pWorld, 3);
        for (int row = 0; row < 6; ++row)
          for (int column = 0; column < 10; ++column) {
            const Vector2 p(-2.7f + 0.6f * static_cast<float>(column), 0.4f * static_cast<float>(row));
            pWorld->Add(CLineSegDesc(p, p + Vector2(0.4f, 0)));
            pWorld->Add(CArcDesc(p + Vector2(0.2f, 0), 0.2f, 0, g_fPi));
          }
        CRandom random(6);
        for (int i = 0; i < 20; ++i)
          pWorld->Add(
              CDynamicCircleDesc({-2.8f + 0.28f * static_cast<float>(i), random.Uniform(-2.8f, -0.5f)}, 0.1f,
                                 random.InSquare(9)));
        return pWorld;
      };
      const auto pKept = make(), pAnew = make();
      std::size_t removed = 0;
      CRandom random(7);
      for (int step = 0; step < 600; ++step) {
        const Vector2 from = random.InSquare(2.9f), to = from + random.InSquare(0.1f);
        for (CWorld* pWorld : {pKept.get(), pAnew.get()}) {
          if (step % 3 > 0) pWorld->Add(CLineSegDesc(from, to));
          pWorld->Step();
          std::vector<CShapeId> hit;
          for (const CContactEvent& contact : pWorld->GetContacts())
            hit.push_back(contact.m_cShape);
          for (const CShapeId id : hit)
            if (id.m_nValue > 4 && pWorld->Contains(id) && pWorld->GetMotionType(id) == eMotion::Static) {
              pWorld->Remove(id);
              ++removed;
            }
        }
        pAnew->LoadState(pAnew->SaveState());
        ASSERT_TRUE(HaveSameBits(*pKept, *pAnew)) << step;
      }
      EXPECT_GT(removed, 60u);
    }
}

// An arc that goes on from a segment: its end, (0, 0), is rounded to (1.19e-8, 0).
TEST(NativeWorldTest, NoBallFallsBetweenASegmentAndAnArcThatGoesOn) {
  int missed = 0;
  for (float x = 0.0f; x < 2e-8f; x += 1e-10f) {
    const auto pWorld = MakeNative(g_cApproximate);
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
    const auto pWorld = MakeNative(effects, g_fMaxSpeed, g_fMaxTimeStep);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0, 0}, 1));
    Steps(*pWorld, 40000);
    EXPECT_TRUE(pWorld->GetPos(ball).allFinite()) << pWorld->GetPos(ball).transpose();
    EXPECT_NEAR(pWorld->GetVel(ball).y() / g_fMaxSpeed, -1.0f, 4 * 1.2e-7f); // the bound of CapSpeed
    EXPECT_GT(pWorld->GetStats().m_nSpeedsCapped, 0u);
  }
}

TEST(NativeWorldTest, MovesThatAreLostToRoundingAreCounted) {
  // Half an ulp at 2^23 is .5: what moves by less in a step does not move at all.
  for (const auto& [move, lost] : {std::pair(0.25f, 3u), std::pair(1.0f, 0u), std::pair(0.0f, 0u)}) {
    const auto pWorld = MakeNative(g_cApproximate, 0, 1);
    const CShapeId ball = pWorld->Add(CDynamicCircleDesc({0x1p23f, 0}, 10, {move, 0}));
    Steps(*pWorld, 3);
    EXPECT_EQ(pWorld->GetStats().m_nMovesLost, lost) << move;
    EXPECT_EQ(pWorld->GetPos(ball).x(), 0x1p23f + (lost > 0 ? 0.0f : 3 * move));
  }
}

} // namespace
} // namespace Shapes
