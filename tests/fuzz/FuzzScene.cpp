// SPDX-License-Identifier: MIT
#include "Fuzz.h"
#include "Sound.h"

#include "Scene.h"
#include "Trial.h"

#include <string>
#include <string_view>

namespace Shapes::Fuzz {
namespace {

using namespace Compare;

// Thousands of chords that all touch one ball take Box2D seconds a step.
constexpr std::uint64_t g_nMostPieces = 64;

// What the loader has promised.
void TakeNatively(const CScene& scene) {
  const auto pWorld = GetBackend(eBackend::Native)->MakeWorld(scene.m_cWorld);
  for (const CSceneShape& shape : scene.m_stdShapes)
    pWorld->Add(shape.m_cDesc);
  for (const CSceneBall& ball : scene.m_stdBalls) {
    const Vector2& p = ball.m_cDesc.m_vPos;
    Require((scene.m_cBounds && Vector2(p - ball.m_vSpread)) &&
                (scene.m_cBounds && Vector2(p + ball.m_vSpread)),
            "a ball starts in the bounds", p.transpose());
    pWorld->Add(ball.m_cDesc);
  }
}

void Play(const CScene& scene, const CEngine& engine) {
  const CStart start = MakeStart(scene, 1, 0);
  std::optional<CGame> game;
  try {
    game.emplace(scene, engine, start);
  } catch (const std::invalid_argument&) { // beyond what the engine can hold, after a part of a step
    return;
  }
  if (game->GetWorld().GetStats().m_nArcPieces > g_nMostPieces) return;
  for (int i = 0; i < 4; ++i) {
    game->Step();
    Require(game->GetNotFinite() == 0, "balls keep their numbers", engine.m_sName);
    RequireSound(game->GetWorld());
  }
}

} // namespace

void FuzzScene(std::span<const std::uint8_t> bytes) {
  CScene scene;
  try {
    scene = ParseScene("s.json", std::string(bytes.begin(), bytes.end()));
  } catch (const CSceneError& error) {
    const std::string_view what = error.what();
    Require(what.starts_with("s.json:") && what.size() > 10, "a refusal says where and why", what);
#ifdef SHAPES_PLANTED_FAULT
    // As if nobody had looked whether a float can hold a number.
    Require(what.find("a number that a float can hold") == what.npos, "numbers are put into floats", what);
#endif
    return;
  }
  TakeNatively(scene);
  for (const CEngine& engine : GetEngines())
    Play(scene, engine);
}

} // namespace Shapes::Fuzz
