// SPDX-License-Identifier: MIT
// The scenes that come with the tool, run natively.
#include "../../compare/scene/Scene.h"

#include "../Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

namespace Shapes::Compare {
namespace {

const std::filesystem::path g_cScenes = std::filesystem::path(SHAPES_SOURCE_DIR) / "compare" / "scenes";

// A native world of a scene that is run like a game: it works the flippers and puts drained balls back.
class CGame {
public:
  CGame(const CScene& scene, const CWorldDesc& world, std::uint64_t seed)
      : m_cScene(scene), m_cRandom(seed), m_pWorld(GetBackend(eBackend::Native)->MakeWorld(world)) {
    for (const CSceneShape& shape : scene.m_stdShapes)
      m_stdShapeIds.push_back(m_pWorld->Add(shape.m_cDesc));
    for (const CSceneBall& ball : scene.m_stdBalls) {
      m_stdBallIds.push_back(m_pWorld->Add(ball.m_cDesc));
      Start(m_stdBallIds.size() - 1);
    }
    m_stdLeftAt.assign(m_stdBallIds.size(), 0.0);
    m_stdStayedAt.assign(m_stdBallIds.size(), Vector2(1e9f, 1e9f));
  }

  CWorld& World() { return *m_pWorld; }

  void Run(double seconds) {
    const double dt = m_pWorld->GetDesc().m_fTimeStep;
    for (long n = std::lround(seconds / dt); n > 0; --n) {
      Flip(m_fTime + dt);
      m_pWorld->Step();
      m_fTime += dt;
      Drain();
      for (std::size_t i = 0; i < m_stdBallIds.size(); ++i)
        Watch(i);
    }
  }

  int m_nEscapes = 0;
  int m_nDrained = 0;
  double m_fLongestStay = 0.0;           // seconds within a radius of one place
  std::set<std::string> m_stdMet;        // names of the shapes that were met
  static constexpr float g_fStay = 0.5f; // units, that radius

private:
  void Start(std::size_t i) {
    const CSceneBall& ball = m_cScene.m_stdBalls[i];
    const float x = m_cRandom.Uniform(-ball.m_vSpread.x(), ball.m_vSpread.x());
    const float y = m_cRandom.Uniform(-ball.m_vSpread.y(), ball.m_vSpread.y());
    const float turn = m_cRandom.Uniform(-ball.m_fTurn, ball.m_fTurn);
    const float speed = 1.0f + m_cRandom.Uniform(-ball.m_fSpeedSpread, ball.m_fSpeedSpread);
    m_pWorld->SetPos(m_stdBallIds[i], ball.m_cDesc.m_vPos + Vector2(x, y));
    m_pWorld->SetVel(m_stdBallIds[i], speed * RotatePt(ball.m_cDesc.m_vVel, Vector2::Zero(), turn));
  }

  void Flip(double t) {
    const double dt = m_pWorld->GetDesc().m_fTimeStep;
    for (std::size_t i = 0; i < m_stdShapeIds.size(); ++i) {
      if (!m_cScene.m_stdShapes[i].m_cFlip) continue;
      const double now = m_pWorld->GetOrientation(m_stdShapeIds[i]);
      const double turn =
          std::remainder(static_cast<double>(FlipOrientation(*m_cScene.m_stdShapes[i].m_cFlip, t)) - now,
                         2.0 * std::numbers::pi);
      m_pWorld->SetRotSpeed(m_stdShapeIds[i], static_cast<float>(turn / (2.0 * std::numbers::pi * dt)));
    }
  }

  void Drain() {
    std::set<std::size_t> drained;
    for (const CContactEvent& e : m_pWorld->GetContacts()) {
      const auto shape = std::find(m_stdShapeIds.begin(), m_stdShapeIds.end(), e.m_cShape);
      if (shape == m_stdShapeIds.end()) continue;
      const CSceneShape& met = m_cScene.m_stdShapes[static_cast<std::size_t>(shape - m_stdShapeIds.begin())];
      m_stdMet.insert(met.m_sName);
      const auto ball = std::find(m_stdBallIds.begin(), m_stdBallIds.end(), e.m_cBall);
      if (met.m_bIsDrain) drained.insert(static_cast<std::size_t>(ball - m_stdBallIds.begin()));
    }
    for (const std::size_t i : drained)
      Start(i);
    m_nDrained += static_cast<int>(drained.size());
  }

  void Watch(std::size_t i) {
    const Vector2 p = m_pWorld->GetPos(m_stdBallIds[i]);
    if (!(m_cScene.m_cBounds && p)) {
      ++m_nEscapes;
      Start(i);
    }
    if (Length(p - m_stdStayedAt[i]) > g_fStay) {
      m_stdStayedAt[i] = p;
      m_stdLeftAt[i] = m_fTime;
    }
    m_fLongestStay = std::max(m_fLongestStay, m_fTime - m_stdLeftAt[i]);
  }

  const CScene& m_cScene;
  Shapes::Tests::CRandom m_cRandom;
  std::unique_ptr<CWorld> m_pWorld;
  std::vector<CShapeId> m_stdShapeIds, m_stdBallIds;
  std::vector<Vector2> m_stdStayedAt; // of each ball, where it was when it last left a place
  std::vector<double> m_stdLeftAt;    // and when
  double m_fTime = 0.0;
};

CScene Pinball() { return LoadScene(g_cScenes / "pinball.json"); }

void RemoveShapes(CScene& scene, const std::string& name) {
  const std::size_t n = std::erase_if(scene.m_stdShapes, [&](const auto& s) { return s.m_sName == name; });
  ASSERT_GT(n, 0u) << name;
}

TEST(SceneFilesTest, AreAllThere) {
  std::set<std::string> names;
  for (const CScene& scene : LoadScenes(g_cScenes)) {
    EXPECT_EQ(scene.m_sName + ".json", scene.m_cPath.filename().string());
    EXPECT_GT(scene.m_sDescription.size(), 60u) << scene.m_sName << " has to say what it shows";
    EXPECT_TRUE(scene.m_sDescription.ends_with('.')) << scene.m_sName;
    // Whom it favours is measured, not foretold.
    EXPECT_EQ(scene.m_sDescription.find("favour"), std::string::npos) << scene.m_sName;
    names.insert(scene.m_sName);
  }
  for (const char* name :
       {"head_on_wall", "grazing_wall", "point_off_centre", "bowl", "open_arc_outside", "open_arc_inside",
        "naked_ends", "guarded_ends", "tangent_joint", "corner", "spinner", "ball_on_ball", "pinball"})
    EXPECT_TRUE(names.contains(name)) << name;
}

// Starts are free: a step too short to get anywhere meets nothing. The same scene run for its whole time is
// the control: there is something to meet.
TEST(SceneFilesTest, StartFreeAndMeetSomething) {
  constexpr int runs = 100;
  for (const CScene& scene : LoadScenes(g_cScenes)) {
    CWorldDesc still = scene.m_cWorld;
    still.m_fTimeStep = 1e-6f;
    int met = 0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      CGame start(scene, still, seed);
      start.World().Step();
      EXPECT_TRUE(start.World().GetContacts().empty()) << scene.m_sName << ", seed " << seed;
      CGame run(scene, scene.m_cWorld, seed);
      run.Run(std::min(scene.m_fDuration, 5.0f));
      met += run.World().GetStats().m_nContacts > 0;
    }
    EXPECT_GE(met, runs * 3 / 4) << scene.m_sName << " wastes its runs";
  }
}

// The step of this scene is two radii long and its starts are spread over exactly one step, so the centre is
// beyond the wall after the first touching step in 1 - r / L = 1/2 of all runs where balls are not swept.
TEST(SceneFilesTest, HalfOfTheHeadOnBallsTunnel) {
  const CScene scene = LoadScene(g_cScenes / "head_on_wall.json");
  const CDynamicCircleDesc& ball = scene.m_stdBalls[0].m_cDesc;
  ASSERT_FLOAT_EQ(ball.m_vVel.x() * scene.m_cWorld.m_fTimeStep, 2.0f * ball.m_fRadius);
  constexpr int runs = 2000;
  CWorldDesc approximate = scene.m_cWorld;
  approximate.m_cEffects = g_cApproximate;
  int escapes = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    CGame game(scene, approximate, seed);
    game.Run(scene.m_fDuration);
    escapes += game.m_nEscapes > 0;
    EXPECT_EQ(game.World().GetStats().m_nContacts, 1u) << "one contact per trial, seed " << seed;
  }
  EXPECT_NEAR(escapes, runs / 2, 5.0 * std::sqrt(runs * 0.25)); // 5 standard deviations of the binomial
}

TEST(PinballTest, KeepsItsBallsAndTheirWaysGoOn) {
  const CScene scene = Pinball();
  CGame game(scene, scene.m_cWorld, 1);
  game.Run(600.0);
  EXPECT_EQ(game.m_nEscapes, 0);
  EXPECT_LT(game.m_fLongestStay, 20.0);
  EXPECT_GT(game.m_nDrained, 100) << "balls have to come back to the plunger";
  for (const CSceneShape& shape : scene.m_stdShapes)
    EXPECT_TRUE(shape.m_sName == "floor" || game.m_stdMet.contains(shape.m_sName))
        << shape.m_sName << " is never met: out of reach";
  EXPECT_FALSE(game.m_stdMet.contains("floor")) << "the drain has to take balls before the floor does";
}

// Controls: a table with a hole loses balls, one without a drain keeps them where they are.
TEST(PinballTest, LosesBallsThroughEachMissingWall) {
  for (const char* wall : {"left wall", "right wall", "chute arc"}) {
    CScene scene = Pinball();
    RemoveShapes(scene, wall);
    CGame game(scene, scene.m_cWorld, 1);
    game.Run(600.0); // long, because few balls come to the lane behind the right wall
    EXPECT_GT(game.m_nEscapes, 0) << wall;
  }
}

TEST(PinballTest, BallsRestWithoutTheDrain) {
  CScene scene = Pinball();
  RemoveShapes(scene, "drain");
  CGame game(scene, scene.m_cWorld, 1);
  game.Run(120.0);
  EXPECT_GT(game.m_fLongestStay, 20.0);
}

TEST(PinballTest, TheGateLetsBallsOutOfTheLaneOnly) {
  CScene scene = Pinball();
  const auto gate = std::find_if(scene.m_stdShapes.begin(), scene.m_stdShapes.end(),
                                 [](const auto& s) { return s.m_sName == "gate"; });
  ASSERT_NE(gate, scene.m_stdShapes.end());
  auto& desc = std::get<CLineSegDesc>(gate->m_cDesc);
  // How far balls fall that are let go above the gate, and that are shot up below it.
  const auto endOf = [&](const Vector2& p, const Vector2& v) {
    scene.m_stdBalls.resize(1);
    scene.m_stdBalls[0] = CSceneBall{};
    scene.m_stdBalls[0].m_cDesc = CDynamicCircleDesc(p, 0.25f, v);
    CGame game(scene, scene.m_cWorld, 1);
    game.Run(0.6);
    return game.World().GetBallPositions()[0];
  };
  const Vector2 above(9.6f, 14.2f), below(9.55f, 12.0f), up(0.0f, 12.0f);
  EXPECT_LT(endOf(above, Vector2::Zero()).x(), 9.1f) << "rolls off into the field";
  EXPECT_GT(endOf(below, up).y(), 13.9f) << "goes through to the arc";

  desc.m_eSides = eSides::Back; // the controls: the gate the wrong way round
  EXPECT_GT(endOf(above, Vector2::Zero()).x(), 9.1f);
  EXPECT_LT(endOf(below, up).y(), 13.9f);
}

} // namespace
} // namespace Shapes::Compare
