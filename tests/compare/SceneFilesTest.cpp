// SPDX-License-Identifier: MIT
// How scenes play; and those that come with the tool, run natively.
#include "MadeScenes.h"

namespace Shapes::Compare::Tests {
namespace {

TEST(FlipTest, TurnsStaysGoesBackAndRests) {
  const CFlip flip{1.0f, 0.5f, 2.0f, 0.0f}; // pi radians per second: a way takes 1/pi = 0.318 s
  const float rounding = 4.0f * 1.2e-7f;
  for (const auto& [t, angle] :
       {std::pair(0.0, 0.0f), {0.4, 1.0f}, {0.999, 1.0f}, {1.4, 0.0f}, {1.999, 0.0f}})
    EXPECT_EQ(FlipOrientation(flip, t), angle) << t;
  EXPECT_NEAR(FlipOrientation(flip, 0.1), 0.1 * std::numbers::pi, rounding);
  EXPECT_NEAR(FlipOrientation(flip, 1.1), 1.0 - 0.1 * std::numbers::pi, rounding);

  CFlip mirrored = flip, later = flip;
  mirrored.m_fAngle = -1.0f;
  later.m_fPhase = 0.25f;
  for (int i = -4000; i < 4000; ++i) {
    const double t = i / 1024.0;
    EXPECT_EQ(FlipOrientation(mirrored, t), -FlipOrientation(flip, t));
    EXPECT_EQ(FlipOrientation(flip, t + 2.0), FlipOrientation(flip, t)); // exact: t and the period are binary
    EXPECT_EQ(FlipOrientation(later, t), FlipOrientation(flip, t + 0.25));
    const float step = FlipOrientation(flip, t + 1.0 / 1024.0) - FlipOrientation(flip, t);
    EXPECT_LE(std::abs(step), std::numbers::pi / 1024 + rounding) << "not above its speed, t = " << t;
  }
}

TEST(ShuttleTest, GoesStaysComesBackAndRests) {
  const CShuttle shuttle{{3, -4}, 10.0f, 2.0f, 0.5f}; // a way takes half a second
  const auto expect = [&](double t, double share) {
    EXPECT_NEAR((ShuttleOffset(shuttle, t - 0.5) - share * Eigen::Vector2d(3, -4)).norm(), 0.0, 1e-12) << t;
  };
  expect(0.0, 0.0), expect(0.25, 0.5), expect(0.5, 1.0), expect(0.999, 1.0);
  expect(1.125, 0.75), expect(1.5, 0.0), expect(1.75, 0.0), expect(2.25, 0.5), expect(-1.75, 0.5);
  EXPECT_TRUE(ShuttleOffset({{0, 0}, 1.0f, 1.0f}, 0.3).isZero(0.0));
}

TEST(TrialTest, ADrainedBallStartsAgainAsAtFirst) {
  CScene scene = MakeScene(4, 1, {Sensor(CLineSegDesc({-3, 0}, {3, 0}))},
                           {CDynamicCircleDesc({0, 1}, 0.1f, {0.5f, 0}),
                            CDynamicCircleDesc({1, 3}, 0.1f, {-0.5f, 0})}, // falls longer
                           {0, -10});
  scene.m_stdShapes[0].m_bIsDrain = true;
  const CStart start = MakeStart(scene, 1, 0);
  for (const std::size_t engine : {g_nNative, g_nApproximate, g_nBox2D}) {
    CGame game(scene, GetEngines()[engine], start);
    while (game.GetDrained() == 0)
      game.Step();
    const CWorld& world = game.GetWorld();
    EXPECT_EQ(world.GetBallPositions()[0], start.m_stdBalls[0].m_vPos);
    EXPECT_EQ(world.GetBallVelocities()[0], start.m_stdBalls[0].m_vVel);
    EXPECT_NE(world.GetBallPositions()[1], start.m_stdBalls[1].m_vPos); // the control
    EXPECT_LT(world.GetBallVelocities()[1].y(), -1.0f);
  }
}

// A game of a scene on the native engine, and what it comes to.
class CWatched {
public:
  explicit CWatched(const CScene& scene, std::uint64_t seed = 1)
      : m_cScene(scene),
        m_cGame(scene, GetEngines()[g_nNative], MakeStart(scene, seed, 0)),
        m_stdStays(scene.m_stdBalls.size()) {}

  const CGame& Run(double seconds) {
    const CWorld& world = m_cGame.GetWorld();
    const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);
    for (long n = std::lround(seconds / dt); n > 0; --n) {
      m_cGame.Step();
      m_fTime += dt;
      for (const CContactEvent& e :
           world.GetContacts()) // ids are those of the shapes in their order, from 1 on
        if (e.m_cShape.m_nValue <= m_cScene.m_stdShapes.size())
          m_stdMet.insert(m_cScene.m_stdShapes[e.m_cShape.m_nValue - 1].m_sName);
      for (std::size_t i = 0; i < m_stdStays.size(); ++i) {
        const Vector2 p = world.GetBallPositions()[i];
        if (Length(p - m_stdStays[i].m_vPos) > g_fStay) m_stdStays[i] = {p, m_fTime};
        m_fLongestStay = std::max(m_fLongestStay, m_fTime - m_stdStays[i].m_fSince);
      }
    }
    return m_cGame;
  }

  double m_fLongestStay = 0.0;           // seconds within a radius of one place
  std::set<std::string> m_stdMet;        // names of the shapes that were met
  static constexpr float g_fStay = 0.5f; // units, that radius

private:
  struct CStay {
    Vector2 m_vPos = Vector2(1e9f, 1e9f);
    double m_fSince = 0.0;
  };
  const CScene& m_cScene;
  CGame m_cGame;
  double m_fTime = 0.0;
  std::vector<CStay> m_stdStays; // where each ball was when it last left a place, and since when
};

void RemoveShapes(CScene& scene, const std::string& name) {
  const std::size_t n = std::erase_if(scene.m_stdShapes, [&](const auto& s) { return s.m_sName == name; });
  ASSERT_GT(n, 0u) << name;
}

TEST(SceneFilesTest, AreAllThere) {
  const std::vector<CScene> scenes = LoadScenes(SHAPES_SCENES_DIR);
  EXPECT_GE(scenes.size(), 23u);
  for (const CScene& scene : scenes) {
    EXPECT_EQ(scene.m_sName + ".json", scene.m_cPath.filename().string());
    EXPECT_GT(scene.m_sDescription.size(), 60u) << scene.m_sName << " has to say what it shows";
    EXPECT_TRUE(scene.m_sDescription.ends_with('.')) << scene.m_sName;
    // Whom it favours is measured, not foretold.
    EXPECT_EQ(scene.m_sDescription.find("favour"), std::string::npos) << scene.m_sName;
  }
}

// Starts are free: a step too short to get anywhere meets nothing. The same scene run for its whole time is
// the control: there is something to meet.
TEST(SceneFilesTest, StartFreeAndMeetSomething) {
  constexpr int runs = 100;
  for (const CScene& scene : LoadScenes(SHAPES_SCENES_DIR)) {
    CScene still = scene;
    still.m_cWorld.m_fTimeStep = 1e-6f;
    int met = 0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      EXPECT_TRUE(CWatched(still, seed).Run(1e-6).GetWorld().GetContacts().empty())
          << scene.m_sName << ", seed " << seed;
      CWatched run(scene, seed);
      met += run.Run(std::min(scene.m_fDuration, 5.0f)).GetWorld().GetStats().m_nContacts > 0;
    }
    EXPECT_GE(met, runs * 3 / 4) << scene.m_sName << " wastes its runs";
  }
}

// The controls: a table with a hole loses balls, one without a drain keeps them where they are. Long, because
// few balls come to the lane behind the right wall.
TEST(PinballTest, KeepsItsBallsAndTheirWaysGoOn) {
  for (const char* pMissing : {"", "left wall", "right wall", "chute arc", "drain"}) {
    SCOPED_TRACE(pMissing);
    const std::string missing = pMissing;
    CScene scene = LoadBundled("pinball");
    if (!missing.empty()) RemoveShapes(scene, missing);
    CWatched game(scene);
    const CGame& end = game.Run(600.0);
    EXPECT_EQ(end.GetEscaped() == 0, missing.empty() || missing == "drain");
    EXPECT_EQ(game.m_fLongestStay > 20.0, missing == "drain");
    if (!missing.empty()) continue;
    EXPECT_GT(end.GetDrained(), 100u) << "balls have to come back to the plunger";
    for (const CSceneShape& shape : scene.m_stdShapes)
      EXPECT_TRUE(shape.m_sName == "floor" || game.m_stdMet.contains(shape.m_sName))
          << shape.m_sName << " is never met: out of reach";
    EXPECT_FALSE(game.m_stdMet.contains("floor")) << "the drain has to take balls before the floor does";
  }
}

TEST(PinballTest, TheGateLetsBallsOutOfTheLaneOnly) {
  CScene scene = LoadBundled("pinball");
  const auto gate = std::find_if(scene.m_stdShapes.begin(), scene.m_stdShapes.end(),
                                 [](const auto& s) { return s.m_sName == "gate"; });
  ASSERT_NE(gate, scene.m_stdShapes.end());
  auto& desc = std::get<CLineSegDesc>(gate->m_cDesc);
  // How far balls fall that are let go above the gate, and that are shot up below it.
  const auto endOf = [&](const Vector2& p, const Vector2& v) {
    scene.m_stdBalls.resize(1);
    scene.m_stdBalls[0] = CSceneBall{};
    scene.m_stdBalls[0].m_cDesc = CDynamicCircleDesc(p, 0.25f, v);
    return Vector2(CWatched(scene).Run(0.6).GetWorld().GetBallPositions()[0]);
  };
  const Vector2 above(9.6f, 14.2f), below(9.55f, 12.0f), up(0.0f, 12.0f);
  EXPECT_LT(endOf(above, Vector2::Zero()).x(), 9.1f) << "rolls off into the field";
  EXPECT_GT(endOf(below, up).y(), 13.9f) << "goes through to the arc";

  desc.m_eSides = eSides::Back; // the controls: the gate the wrong way round
  EXPECT_GT(endOf(above, Vector2::Zero()).x(), 9.1f);
  EXPECT_LT(endOf(below, up).y(), 13.9f);
}

} // namespace
} // namespace Shapes::Compare::Tests
