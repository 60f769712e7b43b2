// SPDX-License-Identifier: MIT
// The engines behind the shared interface.
#pragma once

#include <memory>
#include <span>
#include <string_view>

namespace Shapes {

class CContactDesc;
class CWorld;
class CWorldDesc;

enum class eBackend { Native, Box2D };

/// An engine. There is one object for each engine that was built; it has no state.
class CBackend final {
public:
  /// A row of the table of engines.
  struct CEntry;
  explicit constexpr CBackend(const CEntry& entry) : m_cEntry(entry) {}

  /// "native" or "box2d".
  std::string_view GetName() const;

  /// Whether the ball c.m_pCircle meets the shape c.m_pShape; fills in POI, normal, setback and approach
  /// speed if so. True for sensors too; false if either cannot collide at present, if their filters do not
  /// meet, and for a ball with itself. Native looks at where both are now. Box2D looks at the path of the
  /// ball since its last move as well.
  /// @throws std::invalid_argument if a pointer of c is null
  bool CollisionDetected(CContactDesc& c) const;

  /// An empty world that is stepped by this engine.
  /// @throws std::invalid_argument naming the field of the description that is not valid
  std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) const;

private:
  const CEntry& m_cEntry;
};

/// All engines that were built, in the order of the table; there is at least one.
std::span<const CBackend> GetBackends();

/// The engine asked for; nullptr where it was not built. Never another one in its place.
const CBackend* GetBackend(eBackend e);
const CBackend* GetBackend(std::string_view name);

/// The engine that the CMake option SHAPES_BACKEND chose.
const CBackend& GetDefaultBackend();

} // namespace Shapes
