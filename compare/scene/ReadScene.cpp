// SPDX-License-Identifier: MIT
// From the fields of a scene file to the scene.
#include "Scene.h"

#include "SceneFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
                                                                        {"m_fLengthUnit", "length_unit"},
                                                                        {"p0", "p0"},
                                                                        {"p1", "p1"},
                                                                        {"r0", "radii"},
                                                                        {"r1", "radii"}};

constexpr CNumberRule g_cNumber{"a number"}, g_cNotNegative{"a number of at least 0", 0.0},
    g_cPositive{"a number above 0", std::numeric_limits<double>::denorm_min()},
    g_cLength{"a length of at least 0", 0.0}, g_cElasticity{"an elasticity of at least 0", 0.0},
    g_cRotSpeed{"a rotation speed in revolutions per second"},
    g_cAngle{"an angle in radians, from -2 pi to 2 pi", -6.2832, 6.2832},
    g_cTurn{"an angle in radians, from 0 to pi", 0.0, 3.1416},
    g_cFraction{"a fraction from 0 to 1", 0.0, 1.0}, g_cLasting{"a number from 0 to 3600", 0.0, 3600.0},
    g_cCount{"a whole number from 1 to 1000", 1.0, 1000.0};
constexpr CPairRule g_cPoint{"a point [x, y]", g_cNumber}, g_cVector{"a vector [x, y]", g_cNumber},
    g_cAngles{"two angles [from, to] in radians, counterclockwise", g_cAngle},
    g_cRadii{"two radii [r0, r1] above 0", g_cPositive},
    g_cHalfWidths{"two lengths [x, y] of at least 0", g_cLength},
    g_cFilter{"two whole numbers [category, mask] from 0 to 65535",
              {"a whole number from 0 to 65535", 0.0, 65535.0}};

// A ball that stands for rows and columns of equal ones.
struct CGrid {
  int m_nColumns = 1, m_nRows = 1;
  Vector2 m_vSpacing = Vector2::Zero();
};

constexpr std::string_view g_stdTypes[] = {"point", "line_segment", "circle", "arc", "capsule"},
                           g_stdMotions[] = {"static", "kinematic"}, g_stdSides[] = {"both", "front", "back"};

// The motion of a kinematic shape, or of the shapes of a compound, which move and turn as one.
struct CSceneMotion {
  eMotion m_eMotion = eMotion::Static;
  Vector2 m_vVel = Vector2::Zero();
  float m_fRotSpeed = 0.0f;
  Vector2 m_vRotCenter = Vector2::Zero();
  std::optional<CFlip> m_cFlip;
  std::optional<CShuttle> m_cShuttle;
};

class CSceneReader {
public:
  CSceneReader(const std::filesystem::path& file, const CJson& doc, const CMakeWorld& makeWorld)
      : m_sFile(file.string()), m_cDoc(doc), m_stdMakeWorld(makeWorld) {
    m_cScene.m_cPath = file;
  }

  CScene Read() {
    CSceneFields fields(m_sFile, m_cDoc, CJsonPath(), "an object that describes a scene");
    std::string schema; // for editors
    fields.Read("$schema", schema);
    fields.ReadName("name", m_cScene.m_sName);
    fields.Read("description", m_cScene.m_sDescription);
    ReadWorld(fields);
    fields.Has("bounds"); // required: refused where it is read
    const auto shapes = fields.ReadList("shapes", "a list of shapes", 0);
    const auto compounds = fields.ReadList("compounds", "a list of compounds", 0);
    const auto balls = fields.ReadList("balls", "a list of at least one ball", 1);
    fields.RefuseOthers();
    MakeCheckedWorld(fields.GetPath());
    ReadBounds(fields.GetPath() / "bounds");
    for (const CJsonPath& path : shapes)
      ReadShape(path);
    for (const CJsonPath& path : compounds)
      ReadCompound(path);
    for (const CJsonPath& path : balls)
      ReadBall(path);
    return std::move(m_cScene);
  }

private:
  [[noreturn]] void Refuse(const CJsonPath& path, const std::string& expected) const {
    RefuseField(m_sFile, path, expected, Got(m_cDoc, path));
  }

  CSceneFields Fields(const CJsonPath& path, const char* expected) const {
    return {m_sFile, m_cDoc, path, expected};
  }

  // Runs f, which makes something from values that stand in the objects at `paths`.
  template <class F>
  auto Checked(std::initializer_list<CJsonPath> paths, F f) const {
    try {
      return f();
    } catch (const std::invalid_argument& refusal) {
      const std::string_view text = refusal.what();
      const std::string_view field = text.substr(0, text.find(' '));
      const std::string_view marker = ": expected ";
      const std::size_t at = text.find(marker);
      const std::string expected(at == text.npos ? text : text.substr(at + marker.size()));
      for (const auto& [member, name] : g_stdFieldNames)
        for (const CJsonPath& path : paths)
          if (member == field && m_cDoc.contains(path / name)) Refuse(path / name, expected);
      Refuse(*paths.begin(), at == text.npos ? expected : fmt::format("{} of {}", expected, field));
    }
  }

  void ReadWorld(CSceneFields& fields) {
    CWorldDesc& world = m_cScene.m_cWorld;
    fields.Read("length_unit", world.m_cBox2D.m_fLengthUnit, g_cPositive);
    fields.Read("gravity", world.m_vGravity, g_cVector);
    fields.Read("time_step", world.m_fTimeStep, g_cPositive);
    fields.Read("duration", m_cScene.m_fDuration, g_cPositive, eNeed::Required);
    fields.Read("lasting", m_cScene.m_fLasting, g_cLasting);
  }

  void MakeCheckedWorld(const CJsonPath& path) {
    m_pWorld = Checked({path}, [&] { return m_stdMakeWorld(m_cScene); });
    if (!(m_cScene.m_fDuration >= m_cScene.m_cWorld.m_fTimeStep))
      Refuse(path / "duration", "at least one time_step");
    RequireSteps(path / "duration", m_cScene.m_fDuration);
    RequireSteps(path / "lasting", m_cScene.m_fLasting);
  }

  void RequireSteps(const CJsonPath& path, float seconds) const {
    const double dt = static_cast<double>(m_cScene.m_cWorld.m_fTimeStep);
    if (static_cast<double>(seconds) > dt * static_cast<double>(g_nMaxTrialSteps))
      Refuse(path, fmt::format("at most {} time_steps", g_nMaxTrialSteps));
  }

  void ReadBounds(const CJsonPath& path) {
    CSceneFields fields = Fields(path, "an object with left, bottom, right and top");
    Vector2 topLeft, bottomRight;
    fields.Read("left", topLeft.x(), g_cNumber, eNeed::Required);
    fields.Read("top", topLeft.y(), g_cNumber, eNeed::Required);
    fields.Read("right", bottomRight.x(), g_cNumber, eNeed::Required);
    fields.Read("bottom", bottomRight.y(), g_cNumber, eNeed::Required);
    fields.RefuseOthers();
    if (!(topLeft.x() < bottomRight.x())) Refuse(path / "right", "a number above left");
    if (!(bottomRight.y() < topLeft.y())) Refuse(path / "top", "a number above bottom");
    m_cScene.m_cBounds = CAabb2D(topLeft, bottomRight);
  }

  CSceneMotion ReadMotion(CSceneFields& fields) const {
    CSceneMotion turning;
    fields.Read("velocity", turning.m_vVel, g_cVector);
    fields.Read("rotation_speed", turning.m_fRotSpeed, g_cRotSpeed);
    fields.Read("rotation_center", turning.m_vRotCenter, g_cPoint);
    if (fields.Has("flip")) turning.m_cFlip = ReadFlip(fields.GetPath());
    if (fields.Has("shuttle")) turning.m_cShuttle = ReadShuttle(fields.GetPath());
    std::string motion = "static";
    fields.ReadWord("motion", motion, g_stdMotions);
    if (motion == "kinematic") turning.m_eMotion = eMotion::Kinematic;
    return turning;
  }

  // Rules between two fields, checked after all fields are read: a misspelled one is the better reason.
  void CheckMotion(const CJsonPath& path, const CSceneMotion& turning) const {
    if (turning.m_cFlip && turning.m_fRotSpeed != 0.0f)
      Refuse(path / "rotation_speed", "none for what has a flip");
    if (turning.m_cShuttle && !turning.m_vVel.isZero(0.0f))
      Refuse(path / "velocity", "none for what has a shuttle");
    if (turning.m_eMotion == eMotion::Static && (turning.m_cFlip || turning.m_fRotSpeed != 0.0f))
      Refuse(path / "motion", "\"kinematic\" for a shape that turns");
    if (turning.m_eMotion == eMotion::Static && (turning.m_cShuttle || !turning.m_vVel.isZero(0.0f)))
      Refuse(path / "motion", "\"kinematic\" for a shape that moves");
  }

  // The fields that shuttles and flips share.
  template <class TMotion>
  void ReadTimes(const CJsonPath& path, CSceneFields& fields, float mostSpeed, TMotion& motion) const {
    fields.Read("speed", motion.m_fSpeed, g_cPositive, eNeed::Required);
    fields.Read("period", motion.m_fPeriod, g_cPositive, eNeed::Required);
    fields.Read("phase", motion.m_fPhase, g_cNotNegative);
    fields.RefuseOthers();
    if (!(motion.m_fSpeed > 0.0f && motion.m_fSpeed <= mostSpeed))
      Refuse(path / "speed", fmt::format("a number above 0, up to {}", mostSpeed));
  }
  void CheckPeriod(const CJsonPath& path, const char* sMove, float shortest, float period) const {
    if (!(period > 0.0f && period >= shortest))
      Refuse(path / "period", fmt::format("the time to {} at speed and back, {} or more", sMove, shortest));
  }

  CShuttle ReadShuttle(const CJsonPath& owner) const {
    const CJsonPath path = owner / "shuttle";
    CSceneFields fields = Fields(path, "an object with way, speed, period and perhaps phase");
    CShuttle shuttle;
    fields.Read("way", shuttle.m_vWay, g_cVector, eNeed::Required);
    ReadTimes(path, fields, g_fMaxSpeed, shuttle);
    CheckPeriod(path, "go the way", 2.0f * Length(shuttle.m_vWay) / shuttle.m_fSpeed, shuttle.m_fPeriod);
    return shuttle;
  }

  CFlip ReadFlip(const CJsonPath& owner) const {
    const CJsonPath path = owner / "flip";
    CSceneFields fields = Fields(path, "an object with angle, speed, period and perhaps phase");
    CFlip flip;
    fields.Read("angle", flip.m_fAngle, g_cAngle, eNeed::Required);
    ReadTimes(path, fields, g_fMaxRotSpeed, flip);
    CheckPeriod(path, "turn by angle", std::abs(flip.m_fAngle) / (g_fPi * flip.m_fSpeed), flip.m_fPeriod);
    return flip;
  }

  void ReadCompound(const CJsonPath& path) {
    CSceneFields fields = Fields(path, "an object that describes a compound");
    CSceneMotion turning;
    turning.m_eMotion = eMotion::Kinematic;
    fields.Read("velocity", turning.m_vVel, g_cVector);
    fields.Read("rotation_speed", turning.m_fRotSpeed, g_cRotSpeed);
    fields.Read("rotation_center", turning.m_vRotCenter, g_cPoint, eNeed::Required);
    if (fields.Has("flip")) turning.m_cFlip = ReadFlip(path);
    if (fields.Has("shuttle")) turning.m_cShuttle = ReadShuttle(path);
    const auto shapes = fields.ReadList("shapes", "a list of at least one shape", 1);
    fields.RefuseOthers();
    CheckMotion(path, turning);
    for (const CJsonPath& shape : shapes)
      ReadShape(shape, &turning, path);
  }

  // The one shape that the fields describe, or those of which it consists.
  std::vector<CAnyShapeDesc> ReadGeometry(CSceneFields& fields) const {
    std::string type;
    fields.ReadWord("type", type, g_stdTypes, eNeed::Required);
    if (type == "line_segment" || type == "capsule") {
      Vector2 p0, p1;
      fields.Read("p0", p0, g_cPoint, eNeed::Required);
      fields.Read("p1", p1, g_cPoint, eNeed::Required);
      RequireEnd(fields.GetPath() / "p0", p0);
      RequireEnd(fields.GetPath() / "p1", p1);
      if (type == "capsule") return ReadCapsule(fields, p0, p1);
      CLineSegDesc desc(p0, p1);
      desc.m_eSides = ReadSides(fields);
      return {desc};
    }
    Vector2 p;
    fields.Read("position", p, g_cPoint, eNeed::Required);
    if (type == "point") return {CPointDesc(p)};
    float r = 0.0f;
    fields.Read("radius", r, g_cLength, eNeed::Required);
    if (type == "circle") return {CCircleDesc(p, r)};

    CArcDesc desc;
    desc.m_vPos = p;
    desc.m_fRadius = r;
    desc.m_eSides = ReadSides(fields);
    ReadAngles(fields, desc);
    return {desc};
  }

  std::vector<CAnyShapeDesc> ReadCapsule(CSceneFields& fields, const Vector2& p0, const Vector2& p1) const {
    std::array<double, 2> r{};
    fields.Read("radii", r, g_cRadii, eNeed::Required);
    return Checked({fields.GetPath()},
                   [&] { return MakeCapsule(p0, static_cast<float>(r[0]), p1, static_cast<float>(r[1])); });
  }

  static eSides ReadSides(CSceneFields& fields) {
    std::string sides = "both";
    fields.ReadWord("sides", sides, g_stdSides);
    return sides == "front" ? eSides::Front : sides == "back" ? eSides::Back : eSides::Both;
  }

  CFilter ReadFilter(CSceneFields& fields) const {
    std::array<double, 2> bits{CFilter().m_nCategory, CFilter().m_nMask};
    fields.Read("filter", bits, g_cFilter);
    for (std::size_t i = 0; i < 2; ++i)
      if (bits[i] != std::floor(bits[i]))
        Refuse(fields.GetPath() / "filter" / i, g_cFilter.m_cNumber.m_sExpected);
    return {static_cast<std::uint16_t>(bits[0]), static_cast<std::uint16_t>(bits[1])};
  }

  // An end by itself, so that it is named and not the midpoint.
  void RequireEnd(const CJsonPath& path, const Vector2& p) const {
    try {
      CPoint(CPointDesc(p));
    } catch (const std::invalid_argument&) {
      Refuse(path, fmt::format("coordinates of at most {} in size", g_fMaxLength));
    }
  }

  // In double, and with room for a 2 pi of five digits: [0, 2 pi] is the full circle, but the float nearest
  // to 2 pi is an angle of 1.7e-7.
  void ReadAngles(CSceneFields& fields, CArcDesc& desc) const {
    constexpr double turn = 2.0 * std::numbers::pi, rounding = 2e-5;
    std::array<double, 2> a{desc.GetAngle0(), desc.GetAngle1()};
    fields.Read("angles", a, g_cAngles);
    const double span = std::abs(a[1] - a[0]);
    if (span > turn + rounding) Refuse(fields.GetPath() / "angles", "two angles at most 2 pi apart");
    desc.SetAngles(static_cast<float>(a[0]), static_cast<float>(span < turn - rounding ? a[1] : a[0]));
  }

  /// @param pCompound  how its compound moves; null for a shape by itself  @param mover  what moves
  void ReadShape(const CJsonPath& path, const CSceneMotion* pCompound, const CJsonPath& mover) {
    CSceneFields fields = Fields(path, pCompound != nullptr ? "an object that describes a shape of a compound"
                                                            : "an object that describes a shape");
    std::vector<CAnyShapeDesc> descs = ReadGeometry(fields);
    const CSceneMotion turning = pCompound != nullptr ? *pCompound : ReadMotion(fields);
    CSceneShape shape{descs.front(), {}, turning.m_cFlip, false, turning.m_cShuttle};
    fields.Read("name", shape.m_sName);
    fields.Read("drain", shape.m_bIsDrain);
    for (CAnyShapeDesc& any : descs)
      std::visit(
          [&](auto& desc) {
            fields.Read("elasticity", desc.m_fElasticity, g_cElasticity);
            desc.m_bIsSensor = shape.m_bIsDrain;
            fields.Read("sensor", desc.m_bIsSensor);
            desc.m_cFilter = ReadFilter(fields);
            desc.m_eMotionType = turning.m_eMotion;
            desc.m_vVel = turning.m_vVel;
            desc.m_fRotSpeed = turning.m_fRotSpeed;
            desc.m_vRotCenter = turning.m_vRotCenter;
          },
          any);
    fields.RefuseOthers();
    if (pCompound == nullptr) CheckMotion(path, turning);
    if (shape.m_bIsDrain && !GetBase(descs.front()).m_bIsSensor) Refuse(path / "sensor", "true for a drain");
    for (const CAnyShapeDesc& desc : descs) {
      Checked({path, mover}, [&] { return m_pWorld->Add(desc); });
      shape.m_cDesc = desc;
      m_cScene.m_stdShapes.push_back(shape);
    }
  }

  void ReadShape(const CJsonPath& path) { ReadShape(path, nullptr, path); }

  void ReadSpread(const CJsonPath& path, CSceneBall& ball) const {
    CSceneFields fields = Fields(path, "an object with position, direction or speed");
    fields.Read("position", ball.m_vSpread, g_cHalfWidths);
    fields.Read("direction", ball.m_fTurn, g_cTurn);
    fields.Read("speed", ball.m_fSpeedSpread, g_cFraction);
    fields.RefuseOthers();
  }

  int ReadCount(CSceneFields& fields, const char* name) const {
    float count = 1.0f;
    fields.Read(name, count, g_cCount, eNeed::Required);
    if (count != std::floor(count)) Refuse(fields.GetPath() / name, g_cCount.m_sExpected);
    return static_cast<int>(count);
  }

  CGrid ReadGrid(const CJsonPath& path) const {
    CSceneFields fields = Fields(path, "an object with columns, rows and spacing");
    CGrid grid;
    grid.m_nColumns = ReadCount(fields, "columns");
    grid.m_nRows = ReadCount(fields, "rows");
    fields.Read("spacing", grid.m_vSpacing, g_cVector, eNeed::Required);
    fields.RefuseOthers();
    return grid;
  }

  void ReadBall(const CJsonPath& path) {
    CSceneFields fields = Fields(path, "an object that describes a ball");
    CSceneBall ball;
    fields.Read("position", ball.m_cDesc.m_vPos, g_cPoint, eNeed::Required);
    fields.Read("velocity", ball.m_cDesc.m_vVel, g_cVector);
    fields.Read("radius", ball.m_cDesc.m_fRadius, g_cLength, eNeed::Required);
    fields.Read("mass", ball.m_cDesc.m_fMass, g_cPositive);
    fields.Read("elasticity", ball.m_cDesc.m_fElasticity, g_cElasticity);
    ball.m_cDesc.m_cFilter = ReadFilter(fields);
    if (fields.Has("spread")) ReadSpread(path / "spread", ball);
    CGrid grid;
    if (fields.Has("grid")) grid = ReadGrid(path / "grid");
    fields.RefuseOthers();
    const Vector2 first = ball.m_cDesc.m_vPos;
    for (int row = 0; row < grid.m_nRows; ++row)
      for (int column = 0; column < grid.m_nColumns; ++column) {
        ball.m_cDesc.m_vPos =
            first +
            Vector2(static_cast<float>(column), static_cast<float>(row)).cwiseProduct(grid.m_vSpacing);
        AddBall(path, ball);
      }
  }

  void AddBall(const CJsonPath& path, const CSceneBall& ball) {
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
  const CJson& m_cDoc;
  const CMakeWorld& m_stdMakeWorld;
  CScene m_cScene;
  std::unique_ptr<CWorld> m_pWorld; // takes every descriptor once: what it refuses, no scene may have
};

} // namespace

std::unique_ptr<CWorld> MakeNativeWorld(const CScene& scene) {
  return GetBackend(eBackend::Native)->MakeWorld(scene.m_cWorld);
}

CScene LoadScene(const std::filesystem::path& file, const CMakeWorld& makeWorld) {
  const CJson doc = ReadSceneDocument(file);
  return CSceneReader(file, doc, makeWorld).Read();
}

CScene ParseScene(const std::filesystem::path& file, const std::string& text) {
  const CJson doc = ParseSceneDocument(file.string(), text);
  return CSceneReader(file, doc, &MakeNativeWorld).Read();
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
      RefuseField(file.string(), CJsonPath("/name"), "a name that no other scene of the folder has",
                  CJson(scenes.back().m_sName).dump());
  }
  return scenes;
}

} // namespace Shapes::Compare
