// SPDX-License-Identifier: MIT
// What is tried with any bytes at all. Each throws CBroken where something does not hold that has to hold for
// every input; sanitizers and Box2D's asserts end the process.
#pragma once

#include <cstdint>
#include <span>
#include <sstream>
#include <stdexcept>

namespace Shapes::Fuzz {

class CBroken : public std::logic_error {
public:
  using std::logic_error::logic_error;
};

/// @throws CBroken with what was expected, and the values, unless it holds
template <class... T>
void Require(bool holds, const char* what, const T&... values) {
  if (holds) return;
  std::ostringstream text;
  text.precision(9);
  text << what;
  ((text << ' ' << values), ...);
  throw CBroken(text.str());
}

/// The text of a scene file: the loader refuses it by CSceneError, or both engines can play it.
void FuzzScene(std::span<const std::uint8_t> bytes);
/// A shape and a ball, asked of the native kernels and of Box2D.
void FuzzPairs(std::span<const std::uint8_t> bytes);
/// A world of either engine, and what is done to it.
void FuzzWorld(std::span<const std::uint8_t> bytes);

} // namespace Shapes::Fuzz
