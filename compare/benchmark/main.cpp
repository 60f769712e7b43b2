// SPDX-License-Identifier: MIT
// shapes-benchmark: what a step of the peg field costs on each engine. scripts/benchmark.sh runs it.
#include "Games.h"

#include <benchmark/benchmark.h>

#include <functional>
#include <string>

namespace {

using namespace Shapes;
using namespace Shapes::Compare::Benchmark;

struct CPlayer {
  std::string m_sName;
  std::function<std::unique_ptr<CGame>(const CPegField&, bool pairs)> m_stdMake;
  std::size_t m_nMostBalls; // with more a run takes minutes
};

std::vector<CPlayer> GetPlayers() {
  const auto shapes = [](eBackend backend, CEffectChoice effects) {
    return [=](const CPegField& field, bool pairs) { return MakeShapesGame(field, backend, effects, pairs); };
  };
  const auto box2D = [](bool continuous) {
    return [=](const CPegField& field, bool pairs) { return MakeBox2DGame(field, continuous, pairs); };
  };
  const auto chipmunk = [](float cells) {
    return [=](const CPegField& field, bool pairs) { return MakeChipmunkGame(field, cells, pairs); };
  };
  return {{"native-approximate", shapes(eBackend::Native, g_cApproximate), 1'000'000},
          {"native-continuous", shapes(eBackend::Native, g_cContinuous), 1'000'000},
          {"box2d", box2D(true), 10'000},
          {"box2d-discrete", box2D(false), 10'000},
          {"box2d-through-shapes", shapes(eBackend::Box2D, g_cAutomatic), 10'000},
          {"chipmunk-tree", chipmunk(0.0f), 100'000},
          {"chipmunk-hash", chipmunk(0.6f), 100'000}};
}

// 300 steps after 60, fewer where there are many balls: those before let the field settle into its stream.
void Play(benchmark::State& state, const CPlayer& player, std::size_t balls, bool pairs) {
  const auto pGame = player.m_stdMake(MakePegField(balls), pairs);
  for (int i = 0; i < 60; ++i)
    pGame->Step();
  for ([[maybe_unused]] auto _ : state)
    pGame->Step();
  // Reported as seconds for each ball and step.
  state.counters["ball_step"] =
      benchmark::Counter(static_cast<double>(balls),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

} // namespace

int main(int argc, char** argv) {
  for (const CPlayer& player : GetPlayers())
    for (const bool pairs : {false, true})
      for (std::size_t balls = 100; balls <= (pairs ? 10'000 : player.m_nMostBalls); balls *= 10) {
        const std::string name = player.m_sName + "/" + std::to_string(balls) + (pairs ? "/pairs" : "/alone");
        benchmark::RegisterBenchmark(name.c_str(),
                                     [=](benchmark::State& state) { Play(state, player, balls, pairs); })
            ->Iterations(balls <= 1'000    ? 300
                         : balls <= 10'000 ? 100
                                           : 20)
            ->Unit(benchmark::kMicrosecond);
      }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
