// SPDX-License-Identifier: MIT
// shapes-benchmark: what a step of each field costs on each engine. scripts/benchmark.sh runs it.
#include "Games.h"
#include "Pairs.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <string>

namespace {

using namespace Shapes;
using namespace Shapes::Compare::Benchmark;

struct CPlayer {
  std::string m_sName;
  std::function<std::unique_ptr<CGame>(const CField&, bool pairs)> m_stdMake;
  // With more a run takes minutes. Balls that do not meet each other, and those that do.
  std::size_t m_nMostAlone, m_nMostPairs;
};

std::vector<CPlayer> GetPlayers() {
  const auto shapes = [](eBackend backend, CEffectChoice effects) {
    return [=](const CField& field, bool pairs) { return MakeShapesGame(field, backend, effects, pairs); };
  };
  const auto box2D = [](eByHand byHand) {
    return [=](const CField& field, bool pairs) { return MakeBox2DGame(field, byHand, pairs); };
  };
  const auto chipmunk = [](bool hash) {
    return [=](const CField& field, bool pairs) { return MakeChipmunkGame(field, hash, pairs); };
  };
  return {{"native-approximate", shapes(eBackend::Native, g_cApproximate), 1'000'000, 10'000},
          {"native-continuous", shapes(eBackend::Native, g_cContinuous), 1'000'000, 10'000},
          {"box2d", box2D(eByHand::Continuous), 10'000, 1'000},
          {"box2d-discrete", box2D(eByHand::Discrete), 10'000, 10'000},
          {"box2d-like-shapes", box2D(eByHand::LikeShapes), 1'000, 1'000},
          {"box2d-through-shapes", shapes(eBackend::Box2D, g_cAutomatic), 1'000, 1'000},
          {"chipmunk-tree", chipmunk(false), 100'000, 10'000},
          {"chipmunk-hash", chipmunk(true), 100'000, 10'000}};
}

struct CScene {
  std::string m_sName;
  CField (*m_pMake)(std::size_t balls);
  std::vector<std::size_t> m_stdBalls;
  bool m_bAlone; ///< also with balls that do not meet each other
  int m_nBefore; ///< steps that are not timed
  int m_nSteps;  ///< fewer where there are many balls
};

std::vector<CScene> GetScenes() {
  return {{"peg-field", MakePegField, {100, 1'000, 10'000, 100'000, 1'000'000}, true, 60, 300},
          {"pinball", MakePinball, {1, 6, 100}, false, 60, 1'200},
          {"pile-settling", MakePile, {10, 50, 200, 1'000}, false, 0, 300},
          {"pile-resting", MakePile, {10, 50, 200, 1'000}, false, 900, 300}};
}

// A game at 120 Hz: the flippers kick every 1.1 seconds, 60 degrees up and down.
void Step(CGame& game, int step) {
  const int phase = step % 132;
  if (phase == 0) game.Turn(1.0f);
  if (phase == 16) game.Turn(-1.0f);
  if (phase == 32) game.Turn(0.0f);
  game.Step();
}

void Play(benchmark::State& state, const CPlayer& player, const CScene& scene, std::size_t balls,
          bool pairs) {
  const CField field = scene.m_pMake(balls);
  const auto pGame = player.m_stdMake(field, pairs);
  int step = 0;
  while (step < scene.m_nBefore)
    Step(*pGame, step++);
  for ([[maybe_unused]] auto _ : state)
    Step(*pGame, step++);
  // For each ball and step.
  state.counters["seconds"] =
      benchmark::Counter(static_cast<double>(balls),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  // Balls that got through the walls meet nothing more: the fewer are left, the less a time means.
  const auto positions = pGame->GetBallPositions();
  const auto lost = std::count_if(positions.begin(), positions.end(), [&](const Vector2& p) {
    return (p.array() < 0.0f || p.array() > field.m_vSize.array()).any();
  });
  state.counters["lost"] = static_cast<double>(lost);
}

void Register(const CPlayer& player, const CScene& scene, std::size_t balls, bool pairs) {
  if (balls > (pairs ? player.m_nMostPairs : player.m_nMostAlone)) return;
  const std::string name =
      scene.m_sName + "/" + player.m_sName + "/" + std::to_string(balls) + (pairs ? "/pairs" : "/alone");
  benchmark::RegisterBenchmark(name.c_str(),
                               [=](benchmark::State& state) { Play(state, player, scene, balls, pairs); })
      ->Iterations(balls <= 1'000    ? scene.m_nSteps
                   : balls <= 10'000 ? 100
                                     : 20)
      ->Unit(benchmark::kMicrosecond);
}

} // namespace

int main(int argc, char** argv) {
  for (const CScene& scene : GetScenes())
    for (const CPlayer& player : GetPlayers())
      for (const bool pairs : {false, true})
        for (const std::size_t balls : scene.m_stdBalls)
          if (pairs || scene.m_bAlone) Register(player, scene, balls, pairs);
  RegisterPairs();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
