// SPDX-License-Identifier: MIT
#include "Scene.h"

#include "SceneDocument.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>

namespace Shapes::Compare {
namespace {

using nlohmann::json;
using CPath = json::json_pointer;

// The fields of descriptors by the names that they have in files.
constexpr std::pair<std::string_view, const char*> g_stdFieldNames[] = {{"m_vPos", "position"},
                                                                        {"m_fRadius", "radius"},
                                                                        {"m_fElasticity", "elasticity"},
                                                                        {"m_fRotSpeed", "rotation_speed"},
                                                                        {"m_vRotCenter", "rotation_center"},
                                                                        {"m_vVel", "velocity"},
                                                                        {"m_fMass", "mass"},
                                                                        {"m_vGravity", "gravity"},
                                                                        {"m_fTimeStep", "time_step"},
                                                                        {"m_fLengthUnit", "length_unit"}};

// What is turned in one piece: a kinematic shape, or the shapes of a compound.
struct CTurning {
  eMotion m_eMotion = eMotion::Static;
  float m_fRotSpeed = 0.0f;
  Vector2 m_vRotCenter = Vector2::Zero();
  std::optional<CFlip> m_cFlip;
};

class CSceneReader {
public:
  CSceneReader(const std::filesystem::path& file, const json& doc) : m_sFile(file.string()), m_cDoc(doc) {
    m_cScene.m_cPath = file;
  }

  CScene Read() {
    const CPath root;
    m_cScene.m_sName = m_cDoc.at("name").get<std::string>();
    m_cScene.m_sDescription = m_cDoc.value("description", "");
    ReadWorld(root);
    ReadBounds(root / "bounds");
    for (std::size_t i = 0; i < Count(root / "shapes"); ++i)
      ReadShape(root / "shapes" / i, ReadTurning(root / "shapes" / i));
    for (std::size_t i = 0; i < Count(root / "compounds"); ++i)
      ReadCompound(root / "compounds" / i);
    for (std::size_t i = 0; i < Count(root / "balls"); ++i)
      ReadBall(root / "balls" / i);
    return std::move(m_cScene);
  }

private:
  [[noreturn]] void Refuse(const CPath& path, const std::string& expected) const {
    RefuseField(m_sFile, path, expected, Got(m_cDoc, path));
  }

  // Runs f, which makes something from values that stand in the objects at `paths`.
  template <class F>
  auto Checked(std::initializer_list<CPath> paths, F f) const {
    try {
      return f();
    } catch (const std::invalid_argument& refusal) {
      const std::string_view text = refusal.what();
      const std::string_view field = text.substr(0, text.find(' '));
      const std::string_view marker = ": expected ";
      const std::size_t at = text.find(marker);
      const std::string expected(at == text.npos ? text : text.substr(at + marker.size()));
      for (const auto& [member, name] : g_stdFieldNames)
        for (const CPath& path : paths)
          if (member == field && m_cDoc.contains(path / name)) Refuse(path / name, expected);
      Refuse(*paths.begin(), at == text.npos ? expected : fmt::format("{} of {}", expected, field));
    }
  }

  std::size_t Count(const CPath& path) const { return m_cDoc.contains(path) ? m_cDoc.at(path).size() : 0; }

  void Get(const CPath& path, bool& value) const {
    if (m_cDoc.contains(path)) value = m_cDoc.at(path).get<bool>();
  }
  void Get(const CPath& path, float& value) const {
    if (!m_cDoc.contains(path)) return;
    const double number = m_cDoc.at(path).get<double>();
    if (!(std::abs(number) <= std::numeric_limits<float>::max()))
      Refuse(path, "a number that a float can hold, at most 3.4e38 in size");
    value = static_cast<float>(number);
  }
  void Get(const CPath& path, Vector2& value) const {
    if (!m_cDoc.contains(path)) return;
    Get(path / 0, value.x());
    Get(path / 1, value.y());
  }
  void Get(const CPath& path, eSides& value) const {
    if (!m_cDoc.contains(path)) return;
    const json& sides = m_cDoc.at(path);
    value = sides == "front" ? eSides::Front : sides == "back" ? eSides::Back : eSides::Both;
  }

  void ReadWorld(const CPath& path) {
    CWorldDesc& world = m_cScene.m_cWorld;
    Get(path / "length_unit", world.m_fLengthUnit);
    Get(path / "gravity", world.m_vGravity);
    Get(path / "time_step", world.m_fTimeStep);
    Get(path / "duration", m_cScene.m_fDuration);
    m_pWorld = Checked({path}, [&] { return GetBackend(eBackend::Native)->MakeWorld(world); });
    if (!(m_cScene.m_fDuration >= world.m_fTimeStep)) Refuse(path / "duration", "at least one time_step");
  }

  void ReadBounds(const CPath& path) {
    Vector2 topLeft, bottomRight;
    Get(path / "left", topLeft.x());
    Get(path / "top", topLeft.y());
    Get(path / "right", bottomRight.x());
    Get(path / "bottom", bottomRight.y());
    if (!(topLeft.x() < bottomRight.x())) Refuse(path / "right", "a number above left");
    if (!(bottomRight.y() < topLeft.y())) Refuse(path / "top", "a number above bottom");
    m_cScene.m_cBounds = CAabb2D(topLeft, bottomRight);
  }

  CTurning ReadTurning(const CPath& path) const {
    CTurning turning;
    Get(path / "rotation_speed", turning.m_fRotSpeed);
    Get(path / "rotation_center", turning.m_vRotCenter);
    turning.m_cFlip = ReadFlip(path);
    if (m_cDoc.at(path).value("motion", "static") == "kinematic")
      turning.m_eMotion = eMotion::Kinematic;
    else if (turning.m_cFlip || turning.m_fRotSpeed != 0.0f)
      Refuse(path / "motion", "\"kinematic\" for a shape that turns");
    return turning;
  }

  std::optional<CFlip> ReadFlip(const CPath& owner) const {
    const CPath path = owner / "flip";
    if (!m_cDoc.contains(path)) return std::nullopt;
    CFlip flip;
    Get(path / "angle", flip.m_fAngle);
    Get(path / "speed", flip.m_fSpeed);
    Get(path / "period", flip.m_fPeriod);
    Get(path / "phase", flip.m_fPhase);
    if (!(flip.m_fSpeed > 0.0f && flip.m_fSpeed <= g_fMaxRotSpeed))
      Refuse(path / "speed", fmt::format("a number above 0, up to {}", g_fMaxRotSpeed));
    const float shortest = std::abs(flip.m_fAngle) / (g_fPi * flip.m_fSpeed);
    if (!(flip.m_fPeriod > 0.0f && flip.m_fPeriod >= shortest))
      Refuse(path / "period",
             fmt::format("the time to turn by angle at speed and back, {} or more", shortest));
    if (float speed = 0.0f; Get(owner / "rotation_speed", speed), speed != 0.0f)
      Refuse(owner / "rotation_speed", "none for what has a flip");
    return flip;
  }

  void ReadCompound(const CPath& path) {
    CTurning turning;
    turning.m_eMotion = eMotion::Kinematic;
    Get(path / "rotation_speed", turning.m_fRotSpeed);
    Get(path / "rotation_center", turning.m_vRotCenter);
    turning.m_cFlip = ReadFlip(path);
    for (std::size_t i = 0; i < Count(path / "shapes"); ++i)
      ReadShape(path / "shapes" / i, turning, path);
  }

  CAnyShapeDesc ReadGeometry(const CPath& path) const {
    const auto& type = m_cDoc.at(path / "type").get_ref<const std::string&>();
    if (type == "line_segment") {
      Vector2 p0, p1;
      Get(path / "p0", p0);
      Get(path / "p1", p1);
      CLineSegDesc desc(p0, p1);
      Get(path / "sides", desc.m_eSides);
      return desc;
    }
    Vector2 p;
    Get(path / "position", p);
    if (type == "point") return CPointDesc(p);
    float r = 0.0f;
    Get(path / "radius", r);
    if (type == "circle") return CCircleDesc(p, r);

    CArcDesc desc;
    desc.m_vPos = p;
    desc.m_fRadius = r;
    Get(path / "sides", desc.m_eSides);
    if (m_cDoc.contains(path / "angles")) ReadAngles(path / "angles", desc);
    return desc;
  }

  // In double, and with room for a 2 pi of five digits: [0, 2 pi] is the full circle, but the float nearest
  // to 2 pi is an angle of 1.7e-7.
  void ReadAngles(const CPath& path, CArcDesc& desc) const {
    constexpr double turn = 2.0 * std::numbers::pi, rounding = 2e-5;
    const double a0 = m_cDoc.at(path / 0).get<double>(), a1 = m_cDoc.at(path / 1).get<double>();
    const double span = std::abs(a1 - a0);
    if (span > turn + rounding) Refuse(path, "two angles at most 2 pi apart");
    desc.SetAngles(static_cast<float>(a0), static_cast<float>(span < turn - rounding ? a1 : a0));
  }

  void ReadShape(const CPath& path, const CTurning& turning, const CPath& turner) {
    CSceneShape shape{ReadGeometry(path), m_cDoc.at(path).value("name", ""), turning.m_cFlip, false};
    Get(path / "drain", shape.m_bIsDrain);
    std::visit(
        [&](auto& desc) {
          Get(path / "elasticity", desc.m_fElasticity);
          desc.m_bIsSensor = shape.m_bIsDrain;
          Get(path / "sensor", desc.m_bIsSensor);
          desc.m_eMotionType = turning.m_eMotion;
          desc.m_fRotSpeed = turning.m_fRotSpeed;
          desc.m_vRotCenter = turning.m_vRotCenter;
          if (shape.m_bIsDrain && !desc.m_bIsSensor) Refuse(path / "sensor", "true for a drain");
        },
        shape.m_cDesc);
    CheckEnds(path);
    Checked({path, turner}, [&] { return m_pWorld->Add(shape.m_cDesc); });
    m_cScene.m_stdShapes.push_back(std::move(shape));
  }
  void ReadShape(const CPath& path, const CTurning& turning) { ReadShape(path, turning, path); }

  // The ends of a segment as points, so that the end that is wrong is named and not the midpoint.
  void CheckEnds(const CPath& path) const {
    for (const char* end : {"p0", "p1"}) {
      Vector2 p = Vector2::Zero();
      Get(path / end, p);
      try {
        CPoint(CPointDesc(p));
      } catch (const std::invalid_argument&) {
        Refuse(path / end, fmt::format("coordinates of at most {} in size", g_fMaxLength));
      }
    }
  }

  void ReadBall(const CPath& path) {
    CSceneBall ball;
    Get(path / "position", ball.m_cDesc.m_vPos);
    Get(path / "velocity", ball.m_cDesc.m_vVel);
    Get(path / "radius", ball.m_cDesc.m_fRadius);
    Get(path / "mass", ball.m_cDesc.m_fMass);
    Get(path / "elasticity", ball.m_cDesc.m_fElasticity);
    Get(path / "spread" / "position", ball.m_vSpread);
    Get(path / "spread" / "direction", ball.m_fTurn);
    Get(path / "spread" / "speed", ball.m_fSpeedSpread);
    Checked({path}, [&] { return m_pWorld->Add(ball.m_cDesc); });
    const Vector2 low = ball.m_cDesc.m_vPos - ball.m_vSpread, high = ball.m_cDesc.m_vPos + ball.m_vSpread;
    if (!(m_cScene.m_cBounds && low) || !(m_cScene.m_cBounds && high))
      Refuse(path / "position", "a point in the bounds, the spread of the position included");
    // The fastest start, in whichever direction.
    CDynamicCircleDesc fastest = ball.m_cDesc;
    fastest.m_vVel = {Length(ball.m_cDesc.m_vVel) * (1.0f + ball.m_fSpeedSpread), 0.0f};
    Checked({path}, [&] { return m_pWorld->Add(fastest); });
    m_cScene.m_stdBalls.push_back(ball);
  }

  std::string m_sFile;
  const json& m_cDoc;
  CScene m_cScene;
  std::unique_ptr<CWorld> m_pWorld; // takes every descriptor once: what it refuses, no scene may have
};

} // namespace

CScene LoadScene(const std::filesystem::path& file) {
  const json doc = ReadSceneDocument(file);
  return CSceneReader(file, doc).Read();
}

CScene ParseScene(const std::filesystem::path& file, const std::string& text) {
  const json doc = ParseSceneDocument(file.string(), text);
  return CSceneReader(file, doc).Read();
}

std::vector<CScene> LoadScenes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".json") files.push_back(it->path());
  if (error)
    throw CSceneError(
        fmt::format("{}: expected a folder of scenes, got {}", folder.string(), error.message()));
  if (files.empty())
    throw CSceneError(fmt::format("{}: expected a folder of scenes (*.json), got none", folder.string()));
  std::sort(files.begin(), files.end());

  std::vector<CScene> scenes;
  std::set<std::string> names;
  for (const auto& file : files) {
    scenes.push_back(LoadScene(file));
    if (!names.insert(scenes.back().m_sName).second)
      RefuseField(file.string(), CPath("/name"), "a name that no other scene of the folder has",
                  json(scenes.back().m_sName).dump());
  }
  return scenes;
}

const CShapeDesc& GetBase(const CAnyShapeDesc& any) {
  return std::visit([](const auto& desc) -> const CShapeDesc& { return desc; }, any);
}

std::vector<CAnyShapeDesc> GetShapes(const CScene& scene) {
  std::vector<CAnyShapeDesc> shapes;
  for (const CSceneShape& shape : scene.m_stdShapes)
    shapes.push_back(shape.m_cDesc);
  return shapes;
}

float FlipOrientation(const CFlip& flip, double t) {
  const double period = flip.m_fPeriod, half = 0.5 * period;
  double u = std::fmod(t + flip.m_fPhase, period);
  if (u < 0.0) u += period;
  const double angle = flip.m_fAngle;
  const double way = 2.0 * std::numbers::pi * flip.m_fSpeed * (u < half ? u : u - half);
  const double turned = std::min(way, std::abs(angle));
  return static_cast<float>(std::copysign(u < half ? turned : std::abs(angle) - turned, angle));
}

} // namespace Shapes::Compare
