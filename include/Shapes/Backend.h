// SPDX-License-Identifier: MIT
// The engines behind the shared interface.
#pragma once

#include <memory>
#include <string_view>

namespace Shapes {

class CContactDesc;
class CWorld;
class CWorldDesc;

enum class eBackend { Native, Box2D };

/// An engine. There is one object for each engine that was built; it has no state.
class CBackend {
public:
  virtual ~CBackend() = default;

  /// "native" or "box2d".
  virtual std::string_view GetName() const = 0;

  /// Whether the ball c.m_pCircle meets the shape c.m_pShape; fills in POI, normal, setback and approach
  /// speed if so. True for sensors too; false if either cannot collide at present. Native looks at where both
  /// are now. Box2D looks at the way of the ball since its last move as well.
  /// @throws std::invalid_argument if a pointer of c is null
  bool CollisionDetected(CContactDesc& c) const;

  /// An empty world that is stepped by this engine.
  /// @throws std::invalid_argument naming the field of the description that is not valid
  virtual std::unique_ptr<CWorld> MakeWorld(const CWorldDesc& desc) const = 0;

private:
  virtual bool Detect(CContactDesc& c) const = 0;
};

/// The engine asked for; nullptr where it was not built. Never another one in its place.
const CBackend* GetBackend(eBackend e);

/// The engine that the CMake option SHAPES_BACKEND chose.
const CBackend& GetDefaultBackend();

} // namespace Shapes
