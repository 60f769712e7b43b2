// SPDX-License-Identifier: MIT
#include <Shapes/DebugDraw.h>

#include "../shapes/Validate.h"

#include <cmath>

namespace Shapes {
namespace {

// Of lines; dashed where nothing is solid.
const char* GetStyle(eRole role) {
  switch (role) {
  case eRole::Static: return "stroke=\"#333\"";
  case eRole::Kinematic: return "stroke=\"#b50\"";
  case eRole::Ball: return "stroke=\"#06c\"";
  case eRole::Sensor: return "stroke=\"#292\" stroke-dasharray=\"4 3\"";
  case eRole::Off: return "stroke=\"#bbb\" stroke-dasharray=\"4 3\"";
  case eRole::Contact: return "stroke=\"#d00\"";
  case eRole::Text: break;
  }
  return "stroke=\"#000\"";
}

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : text)
    if (c == '<')
      escaped += "&lt;";
    else if (c == '&')
      escaped += "&amp;";
    else
      escaped += c;
  return escaped;
}

} // namespace

CSvgDraw::CSvgDraw(const CAabb2D& view, float scale) : m_vTopLeft(view.GetTopLeft()), m_fScale(scale) {
  RequireVector("view", view.GetTopLeft(), g_fMaxLength);
  RequireVector("view", view.GetBottomRt(), g_fMaxLength);
  RequirePositive("scale", scale, g_fMaxLength);
  const std::string width = ToPixels(view.GetWidth()), height = ToPixels(view.GetHt());
  m_sText = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
            "\" fill=\"none\" stroke-width=\"1.5\" font-family=\"sans-serif\" font-size=\"13\">\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
}

// Hundredths are enough.
std::string CSvgDraw::ToPixels(float length) const {
  const double hundredths = std::round(static_cast<double>(length) * static_cast<double>(m_fScale) * 100.0);
  return ToText(static_cast<float>(hundredths / 100.0 + 0.0)); // no -0
}

// As two attributes. y is down there.
std::string CSvgDraw::Place(const Vector2& p, const char* x, const char* y) const {
  return std::string(" ") + x + "=\"" + ToPixels(p.x() - m_vTopLeft.x()) + "\" " + y + "=\"" +
         ToPixels(m_vTopLeft.y() - p.y()) + "\"";
}

void CSvgDraw::Add(const std::string& element, eRole role) {
  m_sText += "<" + element + " " + GetStyle(role) + "/>\n";
}

void CSvgDraw::DrawPoint(const Vector2& p, eRole role) {
  Add("circle" + Place(p, "cx", "cy") + " r=\"2\"", role);
}

void CSvgDraw::DrawSegment(const Vector2& p0, const Vector2& p1, eRole role) {
  Add("line" + Place(p0, "x1", "y1") + Place(p1, "x2", "y2"), role);
}

void CSvgDraw::DrawCircle(const Vector2& center, float radius, eRole role) {
  Add("circle" + Place(center, "cx", "cy") + " r=\"" + ToPixels(radius) + "\"", role);
}

void CSvgDraw::DrawArc(const Vector2& center, float radius, float angle0, float span, eRole role) {
  const auto at = [&](float angle) {
    const Vector2 p = center + radius * AngleToVector(angle);
    return ToPixels(p.x() - m_vTopLeft.x()) + " " + ToPixels(m_vTopLeft.y() - p.y());
  };
  const std::string r = ToPixels(radius);
  Add("path d=\"M" + at(angle0) + "A" + r + " " + r + " 0 " + (span > g_fPi ? "1" : "0") + " 0 " +
          at(angle0 + span) + "\"",
      role);
}

void CSvgDraw::DrawText(const Vector2& p, std::string_view text, eRole) {
  m_sText += "<text" + Place(p, "x", "y") + " fill=\"#000\">" + Escaped(text) + "</text>\n";
}

} // namespace Shapes
