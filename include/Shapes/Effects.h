// SPDX-License-Identifier: MIT
// Effects: the parts of a simulation that a world runs only where its content calls for them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace Shapes {

/// What runs only where it is called for. docs/effects.md has what each costs, on both engines.
enum class eEffect {
  /// Balls fall. Called for by a gravity other than 0, where there is a ball.
  Gravity,
  /// Shapes rotate, and the balls that they hit take on the velocity of their surface. Called for by a
  /// kinematic shape with a rotation speed other
  /// than 0; one that stands still is as cheap as a static one.
  Kinematics,
  /// Balls meet balls. Called for by two balls that are solid: neither sensors nor turned off.
  BallPairs,
  /// CWorld::GetSensorEvents, and sensors in CWorld::GetContacts. Called for by a shape or a ball that is a
  /// sensor, and by a ball that is still to be told that it has left one.
  Sensors,
  /// CWorld::GetContacts. Called for wherever a ball can meet anything; forbid it where nobody reads them.
  Events,
  /// Balls meet what is on their way when they are there, instead of what they overlap at the end of a
  /// substep: none gets through a wall. On the native engine balls that fall fly on parabolas then, and only
  /// those that something may be near to cost more than their flight. Called for wherever a ball can meet
  /// anything. On Box2D this is its continuous physics; in a game's b2World the game decides.
  Continuous,
  /// CWorld::GetTouchEvents. Called for by nothing: force it where somebody reads them. It needs Events.
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

/// What a description says of effects. An effect that is in neither set runs where it is called for.
struct CEffectChoice {
  CEffects m_cForced;    ///< They run in any case.
  CEffects m_cForbidden; ///< They never run. What the world does not do then is the user's decision.
  friend constexpr bool operator==(const CEffectChoice&, const CEffectChoice&) = default;
};

/// Whatever is called for: the default.
inline constexpr CEffectChoice g_cAutomatic{};
/// The cheapest way, that of the plain loop of a game: what balls overlap at the end of a substep is met.
/// Fast ones get through walls.
inline constexpr CEffectChoice g_cApproximate{{}, {eEffect::Continuous}};
/// Balls always meet what is on their way.
inline constexpr CEffectChoice g_cContinuous{{eEffect::Continuous}, {}};

} // namespace Shapes
