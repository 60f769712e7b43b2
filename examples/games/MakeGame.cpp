// SPDX-License-Identifier: MIT
#include "Billiard.h"
#include "Breakout.h"
#include "Pile.h"
#include "Pinball.h"

namespace Shapes::Games {

std::unique_ptr<CGame> MakeGame(std::string_view name, const CMode& mode, std::uint32_t seed) {
  if (GetBackend(mode.m_eEngine) == nullptr) return nullptr;
  if (name == "pinball") return std::make_unique<CPinball>(mode, seed);
  if (name == "pile") return std::make_unique<CPile>(mode, seed);
  if (name == "billiard") return std::make_unique<CBilliard>(mode, seed);
  if (name == "breakout") return std::make_unique<CBreakout>(mode, seed);
  return nullptr;
}

} // namespace Shapes::Games
