// SPDX-License-Identifier: MIT
// The changes of the two profiles to Box2D, one switch each, so that each can be measured by itself.
#pragma once

#include <Shapes/World.h>

namespace Shapes::Box2D {

struct CTuning {
  float m_fScale = 1.0f; ///< Box2D's metres to a metre of the description; a power of 2 rounds nothing.
  bool m_bExactContacts =
      false;                 ///< Normals and depths from the shapes themselves, not from chords and skins.
  bool m_bParabolas = false; ///< Gravity bends the path of a ball within a step, and bounces keep its energy.
  bool m_bBullets = false;   ///< Fast balls meet each other at their time of impact.
  bool m_bGhostVertices = false;    ///< Shapes that share an end are joined by ghost vertices.
  bool m_bAdaptiveSubsteps = false; ///< A step in which Box2D would slow something down is cut.
  bool m_bLastingContact = false;   ///< Balls that press on each other are left to Box2D's own solver.
};

inline constexpr CTuning g_cShipped{};
inline constexpr CTuning g_cTuned{4.0f, true, true, true, true, true, true};

inline const CTuning& GetTuning(eProfile e) { return e == eProfile::Tuned ? g_cTuned : g_cShipped; }

} // namespace Shapes::Box2D
