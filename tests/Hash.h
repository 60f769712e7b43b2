// SPDX-License-Identifier: MIT
// All that a world tells of its balls in one number.
#pragma once

#include <Shapes/World.h>

#include <bit>
#include <cstdint>

namespace Shapes::Tests {

/// FNV-1a, 64 bits, over the bits of whatever is put in (G. Fowler, L. Noll, K. Vo).
class CHash {
public:
  void Add(std::uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8)
      m_nHash = (m_nHash ^ ((bits >> shift) & 0xFFu)) * 0x100000001B3u;
  }
  void Add(float f) { Add(std::bit_cast<std::uint32_t>(f)); }
  void Add(const Vector2& v) {
    Add(v.x());
    Add(v.y());
  }
  std::uint64_t Get() const { return m_nHash; }

private:
  std::uint64_t m_nHash = 0xCBF29CE484222325u;
};

/// Where and how fast all balls are, and the contacts of the last step, without their impulses.
inline void AddTo(CHash& hash, const CWorld& world) {
  for (const Vector2& p : world.GetBallPositions())
    hash.Add(p);
  for (const Vector2& v : world.GetBallVelocities())
    hash.Add(v);
  for (const CContactEvent& contact : world.GetContacts()) {
    hash.Add(contact.m_cShape.m_nValue);
    hash.Add(contact.m_cBall.m_nValue);
    hash.Add(contact.m_vPOI);
    hash.Add(contact.m_vNorm);
    hash.Add(contact.m_fSetback);
    hash.Add(contact.m_fSpeed);
    hash.Add(static_cast<std::uint32_t>(contact.m_bIsSensor));
  }
}

} // namespace Shapes::Tests
