// SPDX-License-Identifier: MIT
// The bytes of a fuzzer, read as choices and numbers. make_corpus.py writes the same format.
#pragma once

#include <Shapes/ShapeMath.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace Shapes::Fuzz {

/// Beyond the end everything is 0.
class CBytes {
public:
  explicit CBytes(std::span<const std::uint8_t> bytes) : m_stdBytes(bytes) {}

  bool IsEmpty() const { return m_stdBytes.empty(); }
  std::uint8_t Byte() {
    if (IsEmpty()) return 0;
    const std::uint8_t byte = m_stdBytes.front();
    m_stdBytes = m_stdBytes.subspan(1);
    return byte;
  }
  bool Flag() { return (Byte() & 1) != 0; }
  /// One of the elements.
  template <class T, std::size_t N>
  T OneOf(const T (&choices)[N]) {
    return choices[Byte() % N];
  }

  /// Any float at all. A first byte below 160: a multiple of 1/128 up to 256 from the next two, in which two
  /// numbers are easily the same or touch; below 224: a border; else the next four bytes as they are.
  float Number() {
    const unsigned kind = Byte();
    if (kind >= 224) return Raw<float>();
    if (kind < 160) return static_cast<float>(Raw<std::int16_t>()) / 128.0f;
    static constexpr float inf = std::numeric_limits<float>::infinity();
    static constexpr float borders[] = {1e-45f,  1e-38f, 1e-30f, 1e-18f, 1e-12f, 1e-6f, 1e-3f, 0.005f,
                                        0.0075f, 0.01f,  0.1f,   1.0f,   1e3f,   1e6f,  1e8f,  1e9f,
                                        1e12f,   1e18f,  1e19f,  1e30f,  1e36f,  inf,   g_fPi, g_fTwoPi};
    const float border = borders[(kind - 160) / 2 % std::size(borders)];
    return kind % 2 == 0 ? border : -border;
  }
  Vector2 Vector() {
    const float x = Number(), y = Number();
    return {x, y};
  }

private:
  template <class T>
  T Raw() {
    std::uint8_t bytes[sizeof(T)];
    for (std::uint8_t& byte : bytes)
      byte = Byte();
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  std::span<const std::uint8_t> m_stdBytes;
};

} // namespace Shapes::Fuzz
