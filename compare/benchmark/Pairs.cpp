// SPDX-License-Identifier: MIT
#include "Pairs.h"

#include <Shapes/Shapes.h>

#include <benchmark/benchmark.h>

#include <string>
#include <utility>

namespace Shapes::Compare::Benchmark {
namespace {

// All have their tops at the origin. The ball is so heavy that no response moves it.
const std::pair<const char*, CAnyShapeDesc> g_stdShapes[] = {
    {"point", CPointDesc(Vector2(0, 0))},
    {"segment", CLineSegDesc({-1, 0}, {1, 0})},
    {"circle", CCircleDesc({0, -1}, 1)},
    {"arc", CArcDesc({0, -1}, 1, 0, g_fPi)},
    {"ball", CDynamicCircleDesc({0, -0.1f}, 0.1f, {0, 0}, 1e12f)}};

void Turn(benchmark::State& state, const CBackend& backend, const CAnyShapeDesc& desc, const Vector2& from) {
  const Vector2 v(0, -6);
  CDynamicCircle ball(CDynamicCircleDesc(from, 0.1f, v));
  const auto pShape = MakeShape(desc);
  for ([[maybe_unused]] auto _ : state) {
    ball.SetPos(from);
    ball.SetVel(v);
    ball.move();
    CContactDesc contact(pShape.get(), &ball);
    if (backend.CollisionDetected(contact)) ball.CollisionResponse(contact);
    benchmark::DoNotOptimize(ball.GetPos());
  }
  state.counters["seconds"] =
      benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

} // namespace

void RegisterPairs() {
  for (const auto& [kind, desc] : g_stdShapes)
    for (const CBackend& backend : GetBackends())
      for (const bool far : {true, false}) {
        // A move of a sixtieth of a second ends .03 deep where they meet.
        const Vector2 from(0, far ? 3.0f : 0.17f);
        const std::string name = std::string("pair-") + (far ? "far-" : "meeting-") + kind + "/" +
                                 std::string(backend.GetName()) + "/1/alone";
        benchmark::RegisterBenchmark(name.c_str(), [&backend, pDesc = &desc, from](benchmark::State& state) {
          Turn(state, backend, *pDesc, from);
        })->MinTime(0.1);
      }
}

} // namespace Shapes::Compare::Benchmark
