// SPDX-License-Identifier: MIT
// The exact reference in double against itself with 50 digits, and against its own past: random scenes with
// everything in them, bounce by bounce. Errors of billiards grow exponentially, so each scene carries a bound
// that grows with it, and is compared as long as the bound is small.
#include "ReferenceTesting.h"
#include "reference/Scalar.h"

namespace Shapes::Compare::Tests {
namespace {

CAnyShapeDesc RandomShape(CRandom& random, float e) {
  const Vector2 p = random.InSquare(1.5f);
  switch (random.Below(5)) {
  case 0: return CPointDesc(p, e);
  case 1: return Wall(p, p + random.VectorOfLength(.2f, 1), e);
  case 2: return CCircleDesc(p, random.Uniform(.1f, .5f), e);
  case 3: {
    const CLineSegDesc blade = Wall(p, p + random.VectorOfLength(.2f, 1), e);
    const Vector2 center = random.InSquare(1);
    return Turning(blade, random.Uniform(-.5f, .5f), center);
  }
  default: {
    const float r = random.Uniform(.2f, .8f), a0 = random.Uniform(0, 6), span = random.Uniform(.5f, 5);
    return CArcDesc(p, r, a0, a0 + span, e);
  }
  }
}

template <class T>
CReference<T> MakeRun(const CSceneDesc& scene) {
  return CReference<T>(scene.m_stdShapes, scene.m_stdBalls, scene.m_cWorld.m_vGravity);
}

// A box with shapes of all kinds, and balls that are clear of them.
CSceneDesc RandomScene(CRandom& random, bool elastic) {
  const auto elasticity = [&] { return elastic ? 1.0f : random.Uniform(.8f, 1); };
  CSceneDesc scene;
  if (random.Coin()) scene.m_cWorld.m_vGravity = random.InSquare(5);
  const Vector2 corners[] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  for (int i = 0; i < 4; ++i)
    scene.m_stdShapes.emplace_back(Wall(corners[i], corners[(i + 1) % 4], elasticity()));
  const std::uint32_t shapes = 2 + random.Below(3), balls = 1 + random.Below(3);
  for (std::uint32_t k = 0; k < shapes; ++k)
    scene.m_stdShapes.push_back(RandomShape(random, elasticity()));
  while (scene.m_stdBalls.size() < balls) {
    const float r = random.Uniform(.03f, .2f), m = random.Uniform(.2f, 5);
    const Vector2 p = random.InSquare(1.7f), v = random.VectorOfLength(.5f, 3);
    scene.m_stdBalls.emplace_back(p, r, v, m);
    if (GetGap(MakeRun<double>(scene), scene.m_stdBalls.size() - 1) > .01)
      scene.m_stdBalls.back().m_fElasticity = elasticity();
    else
      scene.m_stdBalls.pop_back();
  }
  return scene;
}

// How far two runs of a scene may be apart, that differ by roundings only: bounds of the errors x of the
// position and v of the velocity of each ball, in first order.
// - A hit finds the place to 2 (g_nTouchRoundings + 16) roundings of the coordinates (Sweep.h).
// - An error x of the place at which a ball with speed u meets a surface at the approach speed c is one of
//   x u / c along the surface. On a surface with the contact radius R (of both bodies together) it turns the
//   normal by x u / (R c), and that turns the velocity by twice as much: v grows by 2 x u^2 / (R c). This is
//   the growth of dispersing billiards, by a factor of 1 + 2 s / (R cos) for the way s to the next hit.
// - The time of the hit errs by x / c. Meanwhile gravity changes the velocity by g x / c, and a surface that
//   turns with w by up to 2 (w u + w^2 L) x / c: v grows by twice that.
// - Two balls share the larger errors of the two.
// - In flight x grows by v t.
class CErrorBound {
public:
  template <class T>
  CErrorBound(const CSceneDesc& scene, const CReference<T>& start)
      : m_cScene(scene),
        m_fEps(static_cast<double>(std::numeric_limits<T>::epsilon())),
        m_fGravity(static_cast<double>(scene.m_cWorld.m_vGravity.norm())),
        m_stdErrors(scene.m_stdBalls.size()) {
    for (std::size_t k = 0; k < start.GetShapeCount(); ++k) {
      m_stdGeometries.push_back(MakeShapeGeometry(scene.m_stdShapes[k]));
      m_stdTurns.push_back(2 * std::numbers::pi * std::abs(static_cast<double>(start.GetRotSpeed(k))));
    }
  }

  struct CBound {
    double m_fPlace; // of the ball
    double m_fTime;  // of the hit
    double m_fSpeed; // of the velocity after it
  };

  /// Goes on to the hit, at `time` since the start of the run.
  template <class T>
  CBound Hit(const CExactEvent<T>& event, double time) {
    const std::size_t i = event.m_nBall, j = event.m_bIsBall ? event.m_nShape : i;
    Fly(i, time);
    Fly(j, time);
    const auto inDouble = [](const CVec<T>& v) { return CVec2d(v.template cast<double>()); };
    const CVec2d n = inDouble(event.m_vNorm), before = inDouble(event.m_vVelBefore),
                 surface = inDouble(event.m_vSurface), rel = before - surface;
    const double own = before.norm() + surface.norm();
    const double u = rel.norm(), c = -rel.dot(n), w = event.m_bIsBall ? 0 : m_stdTurns[event.m_nShape];
    const double size = inDouble(event.m_vCenter).cwiseAbs().maxCoeff() + 4; // the box
    const double x = std::max(m_stdErrors[i].m_fPlace, m_stdErrors[j].m_fPlace) +
                     2 * (g_nTouchRoundings + 16) * m_fEps * size + 4 * m_fEps * time * own;
    const double v = std::max(m_stdErrors[i].m_fSpeed, m_stdErrors[j].m_fSpeed) +
                     2 * x * (u * u * Curvature(event) + m_fGravity + 2 * w * (u + w * size)) / c +
                     32 * m_fEps * own;
    m_stdErrors[i] = m_stdErrors[j] = {x, v, time};
    return {x, x / c + 4 * m_fEps * time, v + m_fGravity * x / c};
  }

  /// All balls go on to `time`. Returns the bound for their places.
  double End(double time) {
    double most = 0;
    for (std::size_t i = 0; i < m_stdErrors.size(); ++i)
      most = std::max(most, Fly(i, time));
    return most;
  }

private:
  struct CError {
    double m_fPlace = 0, m_fSpeed = 0;
    double m_fTime = 0; // at which the ball has them
  };

  double Fly(std::size_t i, double time) {
    CError& error = m_stdErrors[i];
    error.m_fPlace += error.m_fSpeed * (time - error.m_fTime);
    error.m_fTime = time;
    return error.m_fPlace;
  }

  template <class T>
  double Curvature(const CExactEvent<T>& event) const {
    const double r = static_cast<double>(m_cScene.m_stdBalls[event.m_nBall].m_fRadius);
    if (event.m_bIsBall) return 1 / (r + static_cast<double>(m_cScene.m_stdBalls[event.m_nShape].m_fRadius));
    const double R = m_stdGeometries[event.m_nShape].m_fRadius;
    switch (event.m_ePart) {
    case ePart::Front:
    case ePart::Back: return 0;
    case ePart::Outside: return 1 / (R + r);
    case ePart::Inside: return 1 / (R - r);
    default: return 1 / r;
    }
  }

  const CSceneDesc& m_cScene;
  double m_fEps;
  double m_fGravity;
  std::vector<CError> m_stdErrors; // of the balls
  std::vector<CShapeGeometry<double>> m_stdGeometries;
  std::vector<double> m_stdTurns;
};

// A scene is compared up to this bound of the place. Beyond it a near miss may be a hit in the other run
// without being marked as one, because it misses by more than g_fGraze of the contact radius.
constexpr double g_fComparable = 1e-9;

double Apart(const CVec<double>& a, const CVec<CFifty>& b) {
  return static_cast<double>(Norm(CVec<CFifty>(a.cast<CFifty>() - b)));
}

// The findings of a comparison of runs.
struct CTally {
  int m_nHits = 0;
  int m_nAmbiguous = 0; // scenes given up at a graze, or where the order of two hits is open
  int m_nParts[8] = {};
  int m_nTurning = 0;  // hits on shapes that turn
  double m_fShare = 0; // largest of an error in its bound
};

// `push` changes the first velocity in the runs of the doubles by this share of it.
void CompareRuns(const CSceneDesc& scene, double seconds, CTally& tally, double push = 0) {
  CReference<CFifty> exact = MakeRun<CFifty>(scene);
  CErrorBound cumulative(scene, MakeRun<double>(scene));
  const CEventsOf<CFifty> truths = Carry(exact, seconds);
  std::vector<CErrorBound::CBound> bounds; // of the hits that can be compared
  bool ambiguous = exact.GetNearMissCount() > 0;
  for (const CExactEvent<CFifty>& truth : truths) {
    const auto bound = cumulative.Hit(truth, static_cast<double>(truth.m_fTime));
    if (!(bound.m_fPlace < g_fComparable)) break;
    const std::size_t k = bounds.size();
    ambiguous = ambiguous || truth.m_bGraze ||
                (k > 0 && truth.m_fTime - truths[k - 1].m_fTime < bound.m_fTime + bounds[k - 1].m_fTime);
    bounds.push_back(bound);
  }
  const double place = cumulative.End(seconds);
  for (const int steps : {1, 100}) {
    SCOPED_TRACE(testing::Message() << steps << " steps");
    CExact run = MakeRun<double>(scene);
    run.SetBall(0, run.GetBall(0).m_vPos, run.GetBall(0).m_vVel * (1 + push));
    const CEvents events = Carry(run, seconds / steps, steps);
    if (ambiguous || run.GetNearMissCount() > 0) {
      ++tally.m_nAmbiguous;
      return;
    }
    ASSERT_GE(events.size(), bounds.size());
    for (std::size_t k = 0; k < bounds.size(); ++k) {
      SCOPED_TRACE("hit " + std::to_string(k));
      const CExactEvent<double>& event = events[k];
      const CExactEvent<CFifty>& truth = truths[k];
      ASSERT_EQ(event.m_nBall, truth.m_nBall);
      ASSERT_EQ(event.m_bIsBall, truth.m_bIsBall);
      ASSERT_EQ(event.m_nShape, truth.m_nShape);
      ASSERT_EQ(event.m_bOverlapped, truth.m_bOverlapped);
      // Where a face goes over into an end both are right.
      if (event.m_ePart != truth.m_ePart) {
        ASSERT_LE(Apart(event.m_vPOI, truth.m_vPOI), 2 * g_fComparable);
      }
      const double timeOff = std::abs(static_cast<double>(CFifty(event.m_fTime) - truth.m_fTime));
      const double speedOff = Apart(event.m_vVelAfter, truth.m_vVelAfter);
      tally.m_fShare = std::max({tally.m_fShare, timeOff / bounds[k].m_fTime, speedOff / bounds[k].m_fSpeed});
    }
    if (bounds.size() < truths.size()) continue;
    EXPECT_EQ(events.size(), truths.size());
    if (steps == 1) { // a ball that rests is counted in every step
      EXPECT_EQ(run.GetSlideCount(), exact.GetSlideCount());
      EXPECT_EQ(run.GetRestCount(), exact.GetRestCount());
    }
    for (std::size_t i = 0; i < scene.m_stdBalls.size(); ++i)
      tally.m_fShare = std::max(tally.m_fShare, Apart(run.GetBall(i).m_vPos, exact.GetBall(i).m_vPos) /
                                                    (place + steps * 1e-15));
  }
  tally.m_nHits += static_cast<int>(bounds.size());
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    ++tally.m_nParts[static_cast<int>(truths[k].m_ePart)];
    tally.m_nTurning += !truths[k].m_bIsBall && exact.GetRotSpeed(truths[k].m_nShape) != 0;
  }
}

TEST(ReferencePrecision, DoubleFollowsFiftyDigitsHoweverTimeIsCutIntoSteps) {
  CTally tally;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CRandom random(seed);
    const CSceneDesc scene = RandomScene(random, seed % 2 == 0);
    CompareRuns(scene, 2, tally);
    if (HasFatalFailure()) break;
    ASSERT_LE(tally.m_fShare, 1);
  }
  const int scenes = 300;
  EXPECT_LT(tally.m_nAmbiguous, scenes / 10);
  EXPECT_GT(tally.m_nHits, 3 * scenes);
  for (const int hits : tally.m_nParts)
    EXPECT_GT(hits, 5);
  EXPECT_GT(tally.m_nTurning, 20);
}

TEST(ReferencePrecision, BoundIsNarrow) { // control: a velocity that is off by 1e-10 is noticed
  int noticed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CRandom random(seed);
    CTally tally;
    CompareRuns(RandomScene(random, true), 1, tally, 1e-10);
    noticed += tally.m_fShare > 1;
  }
  EXPECT_GE(noticed, 15);
}

// Turns everything round: velocities and rotations.
template <class T>
void Reverse(CReference<T>& reference) {
  for (std::size_t i = 0; i < reference.GetBallCount(); ++i)
    reference.SetBall(i, reference.GetBall(i).m_vPos, -reference.GetBall(i).m_vVel);
  for (std::size_t k = 0; k < reference.GetShapeCount(); ++k)
    if (reference.GetRotSpeed(k) != T(0)) reference.SetRotSpeed(k, -reference.GetRotSpeed(k));
}

struct CReturn {
  std::size_t m_nHits = 0; // both ways
  double m_fBound = 0;
  double m_fOff = 0; // largest distance from the start
};

// For `seconds` there, and as long back. The bound goes on growing on the way back.
template <class T>
CReturn ThereAndBack(const CSceneDesc& scene, double seconds, bool reversed = true) {
  CReference<T> run = MakeRun<T>(scene);
  CErrorBound bound(scene, run);
  CReturn result;
  for (const bool back : {false, true}) {
    if (back && reversed) Reverse(run);
    const CEventsOf<T> events = Carry(run, seconds);
    result.m_nHits += events.size();
    for (const CExactEvent<T>& event : events)
      bound.Hit(event, static_cast<double>(event.m_fTime) + (back ? seconds : 0));
    result.m_fBound = bound.End(back ? 2 * seconds : seconds);
  }
  for (std::size_t i = 0; i < scene.m_stdBalls.size(); ++i) {
    const CVec<T> d = run.GetBall(i).m_vPos - scene.m_stdBalls[i].m_vPos.template cast<T>();
    result.m_fOff = std::max(result.m_fOff, static_cast<double>(Norm(d)));
  }
  return result;
}

// Elastic balls under gravity run backwards when they are turned round. Scenes whose bound has grown beyond
// `most` are left out.
template <class T>
void ExpectReturns(std::uint64_t scenes, double seconds, double most, std::size_t expected) {
  std::size_t hits = 0, returned = 0;
  for (std::uint64_t seed = 1001; seed <= 1000 + scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    CRandom random(seed);
    const CSceneDesc scene = RandomScene(random, true);
    const CReturn result = ThereAndBack<T>(scene, seconds);
    if (!(result.m_fBound < most)) continue;
    EXPECT_LE(result.m_fOff, result.m_fBound);
    EXPECT_EQ(result.m_nHits % 2, 0u);
    ++returned;
    hits += result.m_nHits;
  }
  EXPECT_GT(returned, scenes / 4);
  EXPECT_GT(hits, expected);
}

TEST(ReferencePrecision, TimeRunsBackwards) { ExpectReturns<double>(400, 1, 1e-6, 800); }
TEST(ReferencePrecision, TimeRunsBackwardsInFiftyDigits) { ExpectReturns<CFifty>(40, 4, 1e-6, 600); }

TEST(ReferencePrecision, TimeDoesNotRunBackwardsOtherwise) { // control: a loss, or not turned round
  int strays = 0, hit = 0;
  for (std::uint64_t seed = 1001; seed <= 1100; ++seed) {
    CRandom random(seed);
    CSceneDesc scene = RandomScene(random, true);
    EXPECT_GT(ThereAndBack<double>(scene, 1, false).m_fOff, 1e-3) << "seed " << seed;
    for (CDynamicCircleDesc& ball : scene.m_stdBalls)
      ball.m_fElasticity = .99f;
    const CReturn lossy = ThereAndBack<double>(scene, 1);
    hit += lossy.m_nHits > 0;
    strays += lossy.m_fOff > 1e-6;
  }
  EXPECT_GT(hit, 80);
  EXPECT_EQ(strays, hit);
}

} // namespace
} // namespace Shapes::Compare::Tests
