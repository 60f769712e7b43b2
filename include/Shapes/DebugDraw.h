// SPDX-License-Identifier: MIT
// Drawing a world with a few calls that any renderer has. It has none itself, but for one that writes SVG.
#pragma once

#include <Shapes/Aabb2D.h>
#include <Shapes/ShapeMath.h>

#include <string>
#include <string_view>

namespace Shapes {

class CWorld;

/// The role of a drawn thing: renderers choose a colour by it.
enum class eRole { Static, Kinematic, Ball, Sensor, Off, Contact, Text };

/// The calls that a renderer answers. Places and lengths are user units, angles radians counterclockwise.
class CDebugDraw {
public:
  virtual ~CDebugDraw() = default;
  virtual void DrawPoint(const Vector2& p, eRole role) = 0;
  virtual void DrawSegment(const Vector2& p0, const Vector2& p1, eRole role) = 0;
  virtual void DrawCircle(const Vector2& center, float radius, eRole role) = 0;
  /// Counterclockwise from angle 0 by `span`, which is above 0 and less than a whole turn.
  virtual void DrawArc(const Vector2& center, float radius, float angle0, float span, eRole role) = 0;
  virtual void DrawText(const Vector2& p, std::string_view text, eRole role) = 0;
};

/// Draws all shapes and then all balls by id, and the contacts of the last step: each as a point and its
/// normal, as long as the ball's radius. What is turned off is Off, whatever it is.
void Draw(const CWorld& world, CDebugDraw& draw);

/// A drawing as the text of an SVG file.
class CSvgDraw final : public CDebugDraw {
public:
  /// @param view   what is seen, user units
  /// @param scale  pixels per user unit, above 0
  CSvgDraw(const CAabb2D& view, float scale);

  void DrawPoint(const Vector2& p, eRole role) override;
  void DrawSegment(const Vector2& p0, const Vector2& p1, eRole role) override;
  void DrawCircle(const Vector2& center, float radius, eRole role) override;
  void DrawArc(const Vector2& center, float radius, float angle0, float span, eRole role) override;
  void DrawText(const Vector2& p, std::string_view text, eRole role) override;

  /// The whole file.
  std::string GetText() const { return m_sText + "</svg>\n"; }

private:
  std::string ToPixels(float length) const;
  std::string Place(const Vector2& p, const char* x, const char* y) const;
  void Add(const std::string& element, eRole role);

  Vector2 m_vTopLeft;
  float m_fScale;
  std::string m_sText;
};

} // namespace Shapes
