// SPDX-License-Identifier: MIT
// The functions that the page calls: one game at a time, plain numbers. A pointer that is returned is valid
// until the next call.
#include "../games/Describe.h"
#include "../games/Drawing.h"
#include "../games/Game.h"

#include <emscripten.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace Shapes;
using namespace Shapes::Games;

namespace {

constexpr std::array<const char*, 4> g_stdGames{"pinball", "pile", "billiard", "breakout"};

std::unique_ptr<CGame> g_pGame;
std::vector<CRow> g_stdRows;
std::array<float, 4> g_stdBounds;
std::string g_sText;

const char* Keep(std::string text) {
  g_sText = std::move(text);
  return g_sText.c_str();
}

} // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE unsigned GetGameCount() { return g_stdGames.size(); }
EMSCRIPTEN_KEEPALIVE const char* GetGameName(unsigned game) { return g_stdGames.at(game); }
EMSCRIPTEN_KEEPALIVE unsigned GetModeCount() { return g_stdModes.size(); }
EMSCRIPTEN_KEEPALIVE const char* GetModeName(unsigned mode) { return g_stdModes.at(mode).m_pName; }

EMSCRIPTEN_KEEPALIVE void Start(unsigned game, unsigned mode, unsigned seed) {
  g_pGame = MakeGame(g_stdGames.at(game), g_stdModes.at(mode), seed);
}
EMSCRIPTEN_KEEPALIVE void SetMode(unsigned mode) { g_pGame->SetMode(g_stdModes.at(mode)); }
EMSCRIPTEN_KEEPALIVE void Frame(unsigned keys) { g_pGame->Frame(keys); }
EMSCRIPTEN_KEEPALIVE unsigned Play() { return g_pGame->Play(); }

EMSCRIPTEN_KEEPALIVE unsigned GetFrame() { return g_pGame->GetFrame(); }
EMSCRIPTEN_KEEPALIVE int GetScore() { return g_pGame->GetScore(); }
EMSCRIPTEN_KEEPALIVE unsigned GetBallCount() { return g_pGame->GetWorld().GetBallIds().size(); }
EMSCRIPTEN_KEEPALIVE int GetLost() { return g_pGame->GetLost(); }
EMSCRIPTEN_KEEPALIVE const char* GetStatus() { return Keep(g_pGame->GetStatus()); }
EMSCRIPTEN_KEEPALIVE const char* GetTrace() { return Keep(g_pGame->GetTrace()); }
EMSCRIPTEN_KEEPALIVE const char* Explain() { return Keep(g_pGame->GetWorld().ExplainEffects()); }
EMSCRIPTEN_KEEPALIVE const char* GetScene(float seconds) {
  return Keep(Describe(g_pGame->GetWorld()).ToJson("playground", seconds));
}

/// Rows of 9 floats: CRow.
EMSCRIPTEN_KEEPALIVE const CRow* Draw() {
  g_stdRows = Draw(*g_pGame);
  return g_stdRows.data();
}
EMSCRIPTEN_KEEPALIVE unsigned GetRowCount() { return g_stdRows.size(); }
/// Left, bottom, right, top.
EMSCRIPTEN_KEEPALIVE const float* GetBounds() {
  const CAabb2D& box = g_pGame->GetBounds();
  g_stdBounds = {box.GetTopLeft().x(), box.GetBottomRt().y(), box.GetBottomRt().x(), box.GetTopLeft().y()};
  return g_stdBounds.data();
}

/// Nanoseconds for a step from the present state in a mode, in a world of its own: the game does not notice.
/// @param most  milliseconds after which no further step is begun
EMSCRIPTEN_KEEPALIVE double Measure(unsigned mode, double most) {
  const CWorld& world = g_pGame->GetWorld();
  const auto pWorld = MakeWorld(g_pGame->GetDesc(), g_stdModes.at(mode));
  Describe(world).AddTo(*pWorld);
  pWorld->Step(); // what a first step has to set up is not of interest
  const double begin = emscripten_get_now();
  double now = begin;
  unsigned steps = 0;
  for (; steps < 1 || now - begin < most; now = emscripten_get_now(), ++steps)
    pWorld->Step();
  return (now - begin) / steps * 1e6;
}

} // extern "C"
