// SPDX-License-Identifier: MIT
// Effects: the parts of a simulation that a world runs only where its content calls for them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace Shapes {

/// A part of the simulation. docs/effects.md has the costs.
enum class eEffect {
  /// Balls fall. Called for by a gravity other than 0, where there is a ball.
  Gravity,
  /// Shapes move and rotate, and the velocity of their surfaces counts in responses. Called for by a
  /// kinematic shape with a velocity or a rotation speed other than 0; one that stands still is as cheap as a
  /// static one.
  Kinematics,
  /// Balls meet balls. Called for by two balls that are solid: neither sensors nor turned off.
  BallPairs,
  /// CWorld::GetSensorEvents, and sensors in CWorld::GetContacts. Called for by a shape or a ball that is a
  /// sensor, and by a touch whose end is not reported yet.
  Sensors,
  /// CWorld::GetContacts. Called for wherever a ball can collide; forbid it if the contacts are not read.
  Events,
  /// Balls are swept: they collide where they first touch, instead of where they overlap at the end of a
  /// substep, and do not push each other through shapes. On native balls fall on parabolas then, and only
  /// those that something may be near to cost more than their flight. Called for wherever a ball can collide
  /// or falls. On Box2D this is its continuous physics; in a game's b2World the game decides.
  Continuous,
  /// CWorld::GetTouchEvents. Called for by nothing: force it where somebody reads them. Without Events
  /// (forbidden) it is refused.
  Touches,
  Size ///< counts them
};

/// "Gravity", "Kinematics", ...
std::string_view GetName(eEffect e);

/// A set of effects.
class CEffects {
public:
  constexpr CEffects() = default;
  constexpr CEffects(std::initializer_list<eEffect> effects) {
    for (const eEffect e : effects)
      Set(e);
  }
  static constexpr CEffects All() { return CEffects((1u << static_cast<unsigned>(eEffect::Size)) - 1u); }

  constexpr bool Has(eEffect e) const { return (m_nBits & Bit(e)) != 0; }
  constexpr void Set(eEffect e, bool b = true) { m_nBits = b ? m_nBits | Bit(e) : m_nBits & ~Bit(e); }
  constexpr bool IsEmpty() const { return m_nBits == 0; }

  friend constexpr bool operator==(CEffects, CEffects) = default;
  friend constexpr CEffects operator|(CEffects a, CEffects b) { return CEffects(a.m_nBits | b.m_nBits); }
  friend constexpr CEffects operator&(CEffects a, CEffects b) { return CEffects(a.m_nBits & b.m_nBits); }
  /// Those of a that are not in b.
  friend constexpr CEffects operator-(CEffects a, CEffects b) { return CEffects(a.m_nBits & ~b.m_nBits); }

private:
  explicit constexpr CEffects(std::uint32_t bits) : m_nBits(bits) {}
  static constexpr std::uint32_t Bit(eEffect e) { return 1u << static_cast<unsigned>(e); }

  std::uint32_t m_nBits = 0;
};

/// The forced and forbidden effects of a world. An effect in neither set runs where it is called for.
struct CEffectChoice {
  CEffects m_cForced;    ///< They run in any case.
  CEffects m_cForbidden; ///< They never run, also where the content calls for them.
  friend constexpr bool operator==(const CEffectChoice&, const CEffectChoice&) = default;
};

/// The default: effects run where they are called for.
inline constexpr CEffectChoice g_cAutomatic{};
/// The cheapest: balls collide with shapes that they overlap at the end of a substep. Fast ones pass through
/// walls.
inline constexpr CEffectChoice g_cApproximate{{}, {eEffect::Continuous}};
/// Balls are always swept.
inline constexpr CEffectChoice g_cContinuous{{eEffect::Continuous}, {}};

} // namespace Shapes
