// SPDX-License-Identifier: MIT
#include <Shapes/SceneDesc.h>

#include "../shapes/Validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace Shapes {
namespace {

std::string Quoted(std::string_view text) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      json += {'\\', c};
    else if (const auto code = static_cast<unsigned char>(c); code < 0x20)
      json += {'\\', 'u', '0', '0', digits[code / 16], digits[code % 16]};
    else
      json += c;
  }
  return json += '"';
}

// Readers of JSON go through double, and so round twice. Of the shortest texts of all floats that changes
// 7.038531e-26 alone, which is written as the double that it is.
std::string Number(float value) {
  if (std::abs(value) != 7.038531e-26f) return ToText(value);
  return value < 0.0f ? "-7.038530691851209e-26" : "7.038530691851209e-26";
}

std::string ToJson(const Vector2& v) {
  return std::string("[").append(Number(v.x())).append(", ").append(Number(v.y())).append("]");
}

// One object on one line.
class CObject {
public:
  CObject& Add(std::string_view field, const std::string& json) {
    m_sText.append(m_sText.empty() ? "\"" : ", \"").append(field).append("\": ").append(json);
    return *this;
  }
  CObject& Add(std::string_view field, float value) { return Add(field, Number(value)); }
  CObject& Add(std::string_view field, const Vector2& v) { return Add(field, Shapes::ToJson(v)); }
  std::string Text() const { return "{" + m_sText + "}"; }

private:
  std::string m_sText;
};

void AddGeometry(CObject& json, const CPointDesc& desc) {
  json.Add("type", Quoted("point")).Add("position", desc.m_vPos);
}

void AddFilter(CObject& json, const CFilter& filter) {
  if (filter == CFilter()) return;
  std::string text = "["; // g++ 12 warns of the sum
  text.append(std::to_string(filter.m_nCategory)).append(", ").append(std::to_string(filter.m_nMask));
  json.Add("filter", text.append("]"));
}

void AddSides(CObject& json, eSides sides) {
  if (sides != eSides::Both) json.Add("sides", Quoted(sides == eSides::Front ? "front" : "back"));
}

void AddGeometry(CObject& json, const CLineSegDesc& desc) {
  json.Add("type", Quoted("line_segment")).Add("p0", desc.GetEndPt0()).Add("p1", desc.GetEndPt1());
  AddSides(json, desc.m_eSides);
}

void AddGeometry(CObject& json, const CCircleDesc& desc) {
  json.Add("type", Quoted("circle")).Add("position", desc.m_vPos).Add("radius", desc.m_fRadius);
}

void AddGeometry(CObject& json, const CArcDesc& desc) {
  json.Add("type", Quoted("arc")).Add("position", desc.m_vPos).Add("radius", desc.m_fRadius);
  json.Add("angles", ToJson(Vector2(desc.GetAngle0(), desc.GetAngle1())));
  AddSides(json, desc.m_eSides);
}

std::string Written(const CDynamicCircleDesc&) {
  Refuse("m_stdShapes", "a ball", "static and kinematic shapes; balls are in m_stdBalls");
}

template <class TDesc>
std::string Written(const TDesc& desc) {
  if (desc.m_cLimits != CMotionLimits()) Refuse("m_cLimits", "set", "none: a scene file has no stops");
  CObject json;
  AddGeometry(json, desc);
  json.Add("elasticity", desc.m_fElasticity);
  if (desc.m_bIsSensor) json.Add("sensor", "true");
  AddFilter(json, desc.m_cFilter);
  if (desc.m_eMotionType == eMotion::Kinematic)
    json.Add("motion", Quoted("kinematic"))
        .Add("velocity", desc.m_vVel)
        .Add("rotation_speed", desc.m_fRotSpeed)
        .Add("rotation_center", desc.m_vRotCenter);
  return json.Text();
}

std::string WrittenBall(const CDynamicCircleDesc& ball) {
  if (ball.m_bIsSensor) Refuse("m_bIsSensor", "true", "false: a scene file has no balls that are sensors");
  CObject json;
  json.Add("position", ball.m_vPos)
      .Add("velocity", ball.m_vVel)
      .Add("radius", ball.m_fRadius)
      .Add("mass", ball.m_fMass)
      .Add("elasticity", ball.m_fElasticity);
  AddFilter(json, ball.m_cFilter);
  return json.Text();
}

template <class TDesc>
CAabb2D ReachOf(const TDesc& desc) {
  CAabb2D box = MakeShape(desc)->GetAABB();
  if (desc.m_eMotionType != eMotion::Kinematic) return box;
  const Vector2 &c = desc.m_vRotCenter, &p = box.GetTopLeft(), &q = box.GetBottomRt();
  const float x = std::max(std::abs(p.x() - c.x()), std::abs(q.x() - c.x()));
  const float y = std::max(std::abs(p.y() - c.y()), std::abs(q.y() - c.y()));
  const float r = Length(Vector2(x, y));
  return CAabb2D(c + Vector2(-r, r), c + Vector2(r, -r));
}

CAabb2D BoundsOf(const CSceneDesc& scene) {
  CAabb2D box;
  for (const CAnyShapeDesc& any : scene.m_stdShapes)
    box += std::visit([](const auto& desc) { return ReachOf(desc); }, any);
  for (const CDynamicCircleDesc& ball : scene.m_stdBalls)
    box += CDynamicCircle(ball).GetAABB();
  const Vector2 &p = box.GetTopLeft(), &q = box.GetBottomRt();
  // Far from the origin a small scene would get no margin at all: coordinates are rounded there.
  const float far = std::max(p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff());
  float margin = std::max(0.5f * std::max(box.GetWidth(), box.GetHt()), 1e-6f * far);
  if (margin == 0.0f) margin = 1.0f;
  return CAabb2D(p + Vector2(-margin, margin), q + Vector2(margin, -margin));
}

template <class T, class F>
std::string List(const std::vector<T>& items, F write) {
  std::string text;
  for (const T& item : items)
    text.append(text.empty() ? "[\n    " : ",\n    ").append(write(item));
  return text.empty() ? "[]" : text + "\n  ]";
}

} // namespace

std::vector<CShapeId> CSceneDesc::AddTo(CWorld& world) const {
  std::vector<CShapeId> ids;
  try {
    for (std::size_t i = 0; i < m_stdShapes.size(); ++i)
      ids.push_back(OfElement("shape", i, [&] { return world.Add(m_stdShapes[i]); }));
    for (std::size_t i = 0; i < m_stdBalls.size(); ++i)
      ids.push_back(OfElement("ball", i, [&] { return world.Add(m_stdBalls[i]); }));
  } catch (const std::invalid_argument&) {
    for (const CShapeId id : ids)
      world.Remove(id);
    throw;
  }
  return ids;
}

std::string CSceneDesc::ToJson(const std::string& name, float seconds) const {
  if (name.empty()) Refuse("name", "empty", "a name of at least one letter");
  if (m_stdBalls.empty()) Refuse("m_stdBalls", "empty", "at least one ball: shapes-compare follows balls");
  RequireRange("m_fLengthUnit", m_cWorld.m_cBox2D.m_fLengthUnit, g_fMinLengthUnit, g_fMaxLength);
  RequireVector("m_vGravity", m_cWorld.m_vGravity, g_fMaxSpeed);
  RequirePositive("m_fTimeStep", m_cWorld.m_fTimeStep, g_fMaxTimeStep);
  RequireRange("seconds", seconds, m_cWorld.m_fTimeStep, std::numeric_limits<float>::max());
  const CAabb2D bounds = BoundsOf(*this);

  std::string description;
  for (const std::string& note : m_stdNotes)
    description.append(description.empty() ? "" : " ").append(note);
  const std::string shapes = List(m_stdShapes, [](const CAnyShapeDesc& any) {
    return std::visit([](const auto& desc) { return Written(desc); }, any);
  });

  std::string json = "{";
  const auto add = [&json](const char* field, const std::string& value) {
    json.append(json.size() > 1 ? ",\n  \"" : "\n  \"").append(field).append("\": ").append(value);
  };
  add("name", Quoted(name));
  if (!description.empty()) add("description", Quoted(description));
  add("length_unit", Number(m_cWorld.m_cBox2D.m_fLengthUnit));
  add("gravity", Shapes::ToJson(m_cWorld.m_vGravity));
  add("time_step", Number(m_cWorld.m_fTimeStep));
  add("duration", Number(seconds));
  add("bounds", CObject()
                    .Add("left", bounds.GetTopLeft().x())
                    .Add("bottom", bounds.GetBottomRt().y())
                    .Add("right", bounds.GetBottomRt().x())
                    .Add("top", bounds.GetTopLeft().y())
                    .Text());
  add("shapes", shapes);
  add("balls", List(m_stdBalls, WrittenBall));
  return json + "\n}\n";
}

} // namespace Shapes
