// SPDX-License-Identifier: MIT
#include "LongRun.h"

#include "Energy.h"
#include "EngineResponse.h"
#include "reference/Reference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace Shapes::Compare {
namespace {

// Drifts are between the means over this share of the steps at either end: within the period of a bounce the
// energy of a world that goes in steps goes up and down.
constexpr double g_fEnds = 0.1;
// With fewer bounces there is no figure: it would be rounding, or chance.
constexpr std::size_t g_nLeastBounces = 100;
// Trials over which the free path is averaged. Engines lose volume in phase space, so a single one may end in
// a periodic orbit, and which one is chance.
constexpr std::size_t g_nFreePathTrials = 16;

bool KeepsEnergy(const CScene& scene) {
  const auto& balls = scene.m_stdBalls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].m_cDesc.m_bIsSensor) return false;
    for (std::size_t j = i + 1; j < balls.size(); ++j)
      if (balls[i].m_cDesc.m_fElasticity * balls[j].m_cDesc.m_fElasticity != 1.0f) return false;
    for (const CSceneShape& shape : scene.m_stdShapes)
      if (GetBase(shape.m_cDesc).m_fElasticity * balls[i].m_cDesc.m_fElasticity != 1.0f) return false;
  }
  return std::none_of(scene.m_stdShapes.begin(), scene.m_stdShapes.end(), [](const CSceneShape& shape) {
    return Moves(shape) || shape.m_bIsDrain || GetBase(shape.m_cDesc).m_bIsSensor;
  });
}

// The common centre of circles and full arcs; none if there is anything else.
std::optional<Vector2> FindCentre(const CScene& scene) {
  std::optional<Vector2> centre;
  for (const CSceneShape& shape : scene.m_stdShapes) {
    const auto* pArc = std::get_if<CArcDesc>(&shape.m_cDesc);
    const bool round = std::holds_alternative<CCircleDesc>(shape.m_cDesc) ||
                       (pArc != nullptr && CArc(*pArc).IsFullCircle() && pArc->m_eSides == eSides::Both);
    const Vector2& p = GetBase(shape.m_cDesc).m_vPos;
    if (!round || Moves(shape) || shape.m_bIsDrain || (centre && *centre != p)) return std::nullopt;
    centre = p;
  }
  return centre;
}

// The state at the end of a step.
struct CSample {
  double m_fEnergy;
  double m_fMomentum;
};

// Relative change from the first tenth of the samples to the last.
std::optional<double> GetDrift(const std::vector<CSample>& samples, double CSample::*pFigure) {
  const auto n = static_cast<std::size_t>(g_fEnds * static_cast<double>(samples.size()));
  if (n == 0) return std::nullopt;
  double first = 0.0, last = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const CSample &a = samples[i], &b = samples[samples.size() - n + i];
    first += a.*pFigure;
    last += b.*pFigure;
  }
  const double drift = last / first - 1.0;
  return std::isfinite(drift) ? std::optional(drift) : std::nullopt;
}

class CLongGame {
public:
  CLongGame(const CScene& scene, const CKept& kept, const CEngine& engine, const CStart& start)
      : m_cScene(scene), m_cKept(kept), m_cGame(scene, engine, start), m_cEnergy(scene) {}

  CLongRun Play(std::size_t bounces, std::size_t mostSteps) {
    CLongRun run;
    const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);
    for (std::size_t i = 0; i < mostSteps && run.m_nBounces < bounces && !HasStopped(); ++i) {
      const double way = GetSpeed() * dt;
      m_cGame.Step();
      if (m_cGame.GetEscaped() + m_cGame.GetNotFinite() > 0) break;
      run.m_nBounces += CountBounces(m_cGame.GetWorld());
      run.m_fSeconds += dt;
      m_fWay += way;
      m_stdSamples.push_back({m_cEnergy.GetSum(m_cGame.GetWorld()), GetMomentum()});
    }
    if (run.m_nBounces < g_nLeastBounces) return run;
    if (m_cKept.m_bEnergy) run.m_fEnergyDrift = GetDrift(m_stdSamples, &CSample::m_fEnergy);
    if (m_cKept.m_cCentre) run.m_fAngularMomentumDrift = GetDrift(m_stdSamples, &CSample::m_fMomentum);
    return run;
  }

  double GetWay() const { return m_fWay; }

private:
  bool HasStopped() const {
    const auto v = m_cGame.GetWorld().GetBallVelocities();
    return m_cScene.m_cWorld.m_vGravity.isZero(0.0f) &&
           std::all_of(v.begin(), v.end(), [](const Vector2& x) { return x.isZero(0.0f); }) &&
           std::none_of(m_cScene.m_stdShapes.begin(), m_cScene.m_stdShapes.end(), Turns);
  }

  double GetSpeed() const { return Norm(ToDouble(m_cGame.GetWorld().GetBallVelocities()[0])); }

  double GetMomentum() const {
    if (!m_cKept.m_cCentre) return 0.0;
    const CWorld& world = m_cGame.GetWorld();
    const CVec2d centre = ToDouble(*m_cKept.m_cCentre);
    double momentum = 0.0;
    for (std::size_t i = 0; i < m_cScene.m_stdBalls.size(); ++i)
      momentum += static_cast<double>(m_cScene.m_stdBalls[i].m_cDesc.m_fMass) *
                  Cross(CVec2d(ToDouble(world.GetBallPositions()[i]) - centre),
                        ToDouble(world.GetBallVelocities()[i]));
    return momentum;
  }

  const CScene& m_cScene;
  const CKept& m_cKept;
  CGame m_cGame;
  CEnergy m_cEnergy;
  double m_fWay = 0.0; // of the first ball
  std::vector<CSample> m_stdSamples;
};

// Length of the path, and number of hits.
struct CFlight {
  double m_fWay = 0.0;
  std::size_t m_nBounces = 0;

  std::optional<double> GetFreePath() const {
    if (m_nBounces < g_nLeastBounces) return std::nullopt;
    return m_fWay / static_cast<double>(m_nBounces);
  }
};

// The same on the exact reference, which runs on in double without being rounded to float.
void FlyExactly(const CScene& scene, const CStart& start, std::size_t bounces, std::size_t mostSteps,
                CFlight& flight) {
  CReference<double> reference(GetShapes(scene), start.m_stdBalls, scene.m_cWorld.m_vGravity);
  const double dt = static_cast<double>(scene.m_cWorld.m_fTimeStep);
  std::vector<CExactEvent<double>> events;
  for (std::size_t hits = 0, i = 0; hits < bounces && i < mostSteps; ++i) {
    const auto& ball = reference.GetBall(0);
    if (!(scene.m_cBounds && Vector2(ball.m_vPos.cast<float>()))) return;
    const double way = Norm(ball.m_vVel) * dt;
    events.clear();
    try {
      reference.Step(dt, events);
    } catch (const std::runtime_error&) {
      return; // the flight ends where the reference gave up
    }
    hits += events.size();
    flight.m_nBounces += events.size();
    flight.m_fWay += way;
  }
}

// Free paths of the engines against the exact one.
void MeasureFreePaths(const CScene& scene, const CKept& kept, const std::vector<CEngine>& engines,
                      std::uint64_t seed, std::size_t bounces, std::size_t mostSteps,
                      std::vector<CLongRun>& runs) {
  CFlight exact;
  std::vector<CFlight> flights(engines.size());
  const std::size_t each = bounces / g_nFreePathTrials + 1, eachSteps = mostSteps / g_nFreePathTrials + 1;
  for (std::uint64_t trial = 0; trial < g_nFreePathTrials; ++trial) {
    const CStart start = MakeStart(scene, seed, trial);
    FlyExactly(scene, start, each, eachSteps, exact);
    for (std::size_t i = 0; i < engines.size(); ++i) {
      CLongGame game(scene, kept, engines[i], start);
      flights[i].m_nBounces += game.Play(each, eachSteps).m_nBounces;
      flights[i].m_fWay += game.GetWay();
    }
  }
  for (std::size_t i = 0; i < engines.size(); ++i)
    if (const auto a = flights[i].GetFreePath(), b = exact.GetFreePath(); a && b)
      runs[i].m_fFreePathError = *a / *b - 1.0;
}

} // namespace

CKept FindKept(const CScene& scene) {
  CKept kept;
  kept.m_bEnergy = KeepsEnergy(scene);
  const bool falls = !scene.m_cWorld.m_vGravity.isZero(0.0f);
  kept.m_bFreePath = kept.m_bEnergy && !falls && scene.m_stdBalls.size() == 1;
  if (!falls) kept.m_cCentre = FindCentre(scene);
  return kept;
}

std::vector<CLongRun> MeasureLongRuns(const CScene& scene, const std::vector<CEngine>& engines,
                                      std::uint64_t seed, std::size_t bounces, std::size_t mostSteps) {
  const CKept kept = FindKept(scene);
  if (!kept.IsAnything()) return std::vector<CLongRun>(engines.size());
  const CStart start = MakeStart(scene, seed, 0);
  std::vector<CLongRun> runs;
  for (const CEngine& engine : engines)
    runs.push_back(CLongGame(scene, kept, engine, start).Play(bounces, mostSteps));
  if (kept.m_bFreePath) MeasureFreePaths(scene, kept, engines, seed, bounces, mostSteps, runs);
  return runs;
}

} // namespace Shapes::Compare
