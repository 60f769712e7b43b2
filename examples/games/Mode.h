// SPDX-License-Identifier: MIT
// The ways to step a world that a player can choose between, by the names that shapes-compare gives them.
#pragma once

#include <Shapes/Shapes.h>

#include <array>
#include <memory>

namespace Shapes::Games {

struct CMode {
  const char* m_pName;
  eBackend m_eEngine;
  CEffectChoice m_cEffects;
  eProfile m_eProfile;
};

inline constexpr std::array<CMode, 4> g_stdModes{{
    {"native", eBackend::Native, g_cAutomatic, eProfile::Shipped},
    {"native-approximate", eBackend::Native, g_cApproximate, eProfile::Shipped},
    {"box2d", eBackend::Box2D, g_cAutomatic, eProfile::Shipped},
    {"box2d-tuned", eBackend::Box2D, g_cAutomatic, eProfile::Tuned},
}};

/// An empty world; effects that the description forbids stay forbidden.
/// @return null where the engine was not built
inline std::unique_ptr<CWorld> MakeWorld(CWorldDesc desc, const CMode& mode) {
  desc.m_cEffects.m_cForced = desc.m_cEffects.m_cForced | mode.m_cEffects.m_cForced;
  desc.m_cEffects.m_cForbidden = desc.m_cEffects.m_cForbidden | mode.m_cEffects.m_cForbidden;
  desc.m_cBox2D.m_eProfile = mode.m_eProfile;
  const CBackend* pEngine = GetBackend(mode.m_eEngine);
  return pEngine == nullptr ? nullptr : pEngine->MakeWorld(desc);
}

} // namespace Shapes::Games
