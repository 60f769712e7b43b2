// SPDX-License-Identifier: MIT
#include "Bytes.h"
#include "Fuzz.h"

#include "scene/Scene.h"
#include "scene/Trial.h"

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Fuzz {
namespace {

using namespace Compare;

// Thousands of chords that all touch one ball take Box2D seconds a step.
constexpr std::uint64_t g_nMostScenePieces = 64;

// A scene of everything, for numbers to be put into.
constexpr std::string_view g_sScene = R"({"name": "n", "length_unit": 2, "gravity": [1, -9.5],
 "time_step": 0.0078125, "duration": 3, "bounds": {"left": -5, "bottom": -6, "right": 7, "top": 8},
 "shapes": [
  {"type": "point", "position": [1, 2], "elasticity": 0.5},
  {"type": "line_segment", "p0": [3, 0], "p1": [-3, 1], "sides": "back", "elasticity": 1},
  {"type": "line_segment", "p0": [3, 0], "p1": [4, -1], "motion": "kinematic", "rotation_center": [3, 0],
   "flip": {"angle": 1, "speed": 2, "period": 1, "phase": 0.25}},
  {"type": "circle", "position": [4, 4], "radius": 0.25, "drain": true},
  {"type": "arc", "position": [0, 5], "radius": 2, "angles": [3, 0.5], "sides": "front", "motion": "kinematic",
   "rotation_speed": -0.5, "rotation_center": [0, 4]}],
 "compounds": [{"rotation_center": [-2, -2], "rotation_speed": 1, "shapes": [
  {"type": "arc", "position": [-1, -2], "radius": 1, "angles": [0, 1.5], "elasticity": 1.5},
  {"type": "circle", "position": [-2, -2], "radius": 0.5}]}],
 "balls": [
  {"position": [0, 0], "velocity": [3, 4], "radius": 0.5, "mass": 2, "elasticity": 0.25,
   "spread": {"position": [0.5, 1], "direction": 0.125, "speed": 0.5}},
  {"position": [-1, -1], "velocity": [9, -40], "radius": 0.25, "mass": 1, "elasticity": 1}]})";

// Most changes of a text make it none of a scene. So bytes that begin with 1 are numbers for g_sScene: which
// one, and its value, again and again.
std::string ToText(std::span<const std::uint8_t> data) {
  if (data.empty() || data.front() != 1) return std::string(data.begin(), data.end());
  std::vector<std::string> between(1), numbers;
  bool isName = false;
  for (std::size_t i = 0; i < g_sScene.size(); ++i) {
    isName ^= g_sScene[i] == '"';
    const std::size_t end = isName ? i : g_sScene.find_first_not_of("-.0123456789", i);
    if (end == i) {
      between.back() += g_sScene[i];
      continue;
    }
    numbers.emplace_back(g_sScene.substr(i, end - i));
    between.emplace_back();
    i = end - 1;
  }
  for (CBytes bytes(data.subspan(1)); !bytes.IsEmpty();) {
    const std::size_t which = bytes.Byte() % numbers.size();
    char text[32];
    std::snprintf(text, sizeof(text), "%.9g", static_cast<double>(bytes.Number()));
    // JSON has no word for what is no number.
    numbers[which] = text[0] == 'i' || text[0] == 'n' || text[1] == 'i' || text[1] == 'n' ? "1e300" : text;
  }
  std::string scene = between.front();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    scene += numbers[i] + between[i + 1];
  return scene;
}

// The promises of the loader.
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
  if (game->GetWorld().GetStats().m_nArcPieces > g_nMostScenePieces) return;
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
    scene = ParseScene("s.json", ToText(bytes));
  } catch (const CSceneError& error) {
    const std::string_view what = error.what();
    Require(what.starts_with("s.json:") && what.size() > 10, "a refusal says where and why", what);
    return;
  }
#ifdef SHAPES_PLANTED_FAULT
  // As if nobody had thought of gravity that pulls up.
  Require(!(scene.m_cWorld.m_vGravity.y() > 0.0f), "gravity pulls down");
#endif
  TakeNatively(scene);
  for (const CEngine& engine : GetEngines())
    Play(scene, engine);
}

} // namespace Shapes::Fuzz
