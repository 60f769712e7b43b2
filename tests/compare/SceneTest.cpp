// SPDX-License-Identifier: MIT
#include "CommandCalls.h"
#include "MadeScenes.h"
#include "schema/Schema.h"

#include <sys/stat.h>

namespace Shapes::Compare {
namespace {

using nlohmann::json;
using Tests::OneOfEach, Tests::ToDesc;

// A change of the valid scene: what is an object there is merged with the value, and loses its nulls;
// anything else is replaced by it. Then what the error says after the name of the file, and after the path if
// that is the one of the change.
struct CChange {
  const char* m_sPath;
  const char* m_sValue; // JSON
  const char* m_sError;
};

class SceneTest : public Tests::CFolderTest {
protected:
  CScene Load(const json& doc) const { return LoadScene(Write("s.json", doc.dump())); }

  // The words of the error after the name of the file.
  std::string ErrorOf(const std::string& text) const {
    const std::string file = Write("s.json", text);
    const std::string what = MessageOf<CSceneError>([&] { LoadScene(file); });
    if (what.empty()) return "no error";
    EXPECT_EQ(what.rfind(file + ":", 0), 0u) << what;
    return what.substr(file.size() + 1);
  }
  std::string ErrorWith(const CChange& change) const {
    json doc = OneOfEach();
    const json value = json::parse(change.m_sValue);
    json& place = doc[json::json_pointer(change.m_sPath)];
    if (place.is_object() && value.is_object())
      place.merge_patch(value);
    else
      place = value;
    return ErrorOf(doc.dump());
  }
  static std::string ExpectedOf(const CChange& change) {
    const std::string error = change.m_sError;
    return " " + (error.starts_with('/') ? error : std::string(change.m_sPath) + ": " + error);
  }
};

TEST_F(SceneTest, EveryFieldArrives) {
  const CScene scene = Load(OneOfEach());
  EXPECT_EQ(scene.m_sName, "all");
  EXPECT_EQ(scene.m_sDescription, "one of each");
  EXPECT_EQ(scene.m_cPath, m_cFolder / "s.json");
  EXPECT_EQ(scene.m_fDuration, 3.0f);
  EXPECT_EQ(scene.m_fLasting, 4.0f);
  EXPECT_EQ(scene.m_cBounds.GetTopLeft(), Vector2(-5.0f, 8.0f));
  EXPECT_EQ(scene.m_cBounds.GetBottomRt(), Vector2(7.0f, -6.0f));

  CSceneDesc expected;
  expected.m_stdNotes = {"one of each"};
  expected.m_cWorld.m_cBox2D.m_fLengthUnit = 2.0f;
  expected.m_cWorld.m_vGravity = {1.0f, -9.5f};
  expected.m_cWorld.m_fTimeStep = 0.0078125f;
  expected.m_stdShapes = {Filtered(Turning(CPointDesc({1, 2}, 0.5f)), {2, 3}),
                          Filtered(Sensor(Sided(CLineSegDesc({3, 0}, {-3, 1}), eSides::Back)), {0, 65535}),
                          Turning(MakeZone({4, 4}, 0.25f)), // a drain without being called a sensor
                          Turning(Sided(CArcDesc({0, 5}, 2, 3, 0.5f), eSides::Front), -0.5f, {0, 4})};
  const auto add = [&](const std::vector<CAnyShapeDesc>& shapes) {
    expected.m_stdShapes.insert(expected.m_stdShapes.end(), shapes.begin(), shapes.end());
  };
  add(MakeCapsule({1, 1}, 0.5f, {2, 3}, 0.25f, Sensor(CLineSegDesc())));
  const Vector2 hinge(-2, -2), tip(-1, -2);
  add({Turning(CLineSegDesc(hinge, tip, 0.75f), 0, hinge), Turning(CPointDesc(tip), 0, hinge),
       Turning(MakeZone(tip, 0.5f), 0, hinge), Turning(CArcDesc(tip, 0.5f, 0, 1), 0, hinge)});
  add(MakeCapsule({0, 0}, 0.5f, {3, 1}, 0.25f, Filtered(Turning(CLineSegDesc(), 0, hinge), {2, 1})));
  add({Turning(CPointDesc(tip), 1)});
  for (int i = 0; i < 6; ++i) // row by row
    expected.m_stdBalls.push_back(
        Filtered(CDynamicCircleDesc(Vector2(0.5f * static_cast<float>(i % 2), static_cast<float>(i / 2)),
                                    0.5f, {3, 4}, 2, 0.25f),
                 {4, 1}));
  EXPECT_EQ(ToDesc(scene).ToJson("all", 3), expected.ToJson("all", 3));

  ASSERT_EQ(scene.m_stdShapes.size(), 17u);
  for (std::size_t i = 0; i < 17; ++i) {
    SCOPED_TRACE(i);
    const CSceneShape& shape = scene.m_stdShapes[i];
    const bool flips = i == 2 || (i >= 8 && i < 16);
    EXPECT_EQ(shape.m_sName, i == 0 ? "post" : i >= 4 && i < 8 ? "finger" : i == 9 ? "tip" : "");
    EXPECT_EQ(shape.m_bIsDrain, i == 2);
    ASSERT_EQ(shape.m_cFlip.has_value(), flips);
    ASSERT_EQ(shape.m_cShuttle.has_value(), i == 0);
    if (!flips) continue;
    EXPECT_EQ(shape.m_cFlip->m_fAngle, i == 2 ? 1.0f : -1.0f);
    EXPECT_EQ(shape.m_cFlip->m_fSpeed, 1.0f);
    EXPECT_EQ(shape.m_cFlip->m_fPeriod, 2.0f);
    EXPECT_EQ(shape.m_cFlip->m_fPhase, i == 2 ? 0.0f : 0.5f);
  }
  const CShuttle& shuttle = *scene.m_stdShapes[0].m_cShuttle;
  EXPECT_EQ(shuttle.m_vWay, Vector2(1.0f, 0.0f));
  EXPECT_EQ(Eigen::Vector3f(shuttle.m_fSpeed, shuttle.m_fPeriod, shuttle.m_fPhase),
            Eigen::Vector3f(2.0f, 1.0f, 0.5f));
  for (const CSceneBall& ball : scene.m_stdBalls) {
    EXPECT_EQ(ball.m_vSpread, Vector2(0.5f, 1.0f));
    EXPECT_EQ(ball.m_fTurn, 0.125f);
    EXPECT_EQ(ball.m_fSpeedSpread, 0.5f);
  }
}

TEST_F(SceneTest, LeftOutFieldsAreThoseOfTheDescriptors) {
  const CScene scene = Load(json::parse(R"({"name": "n", "duration": 1,
    "bounds": {"left": -1, "bottom": -1, "right": 1, "top": 1}, "balls": [{"position": [0, 0], "radius": 0}],
    "shapes": [{"type": "line_segment", "p0": [0, 0], "p1": [1, 0]},
               {"type": "arc", "position": [0, 0], "radius": 1}]})"));
  CSceneDesc expected;
  expected.m_stdNotes = {""};
  expected.m_stdShapes = {CLineSegDesc({0, 0}, {1, 0}), CArcDesc({0, 0}, 1, 0, 0)};
  expected.m_stdBalls = {CDynamicCircleDesc({0, 0}, 0)};
  EXPECT_EQ(ToDesc(scene).ToJson("n", 1), expected.ToJson("n", 1));
  EXPECT_FALSE(scene.m_stdShapes[0].m_cFlip.has_value());
  EXPECT_EQ(scene.m_stdBalls[0].m_vSpread, Vector2(0.0f, 0.0f));
}

TEST_F(SceneTest, AWholeTurnIsAFullCircle) {
  const auto arc = [&](double a0, double a1) {
    json doc = OneOfEach();
    doc["shapes"][3]["angles"] = {a0, a1};
    return CArc(std::get<CArcDesc>(Load(doc).m_stdShapes[3].m_cDesc));
  };
  EXPECT_TRUE(arc(0.0, 6.283185307179586).IsFullCircle());
  EXPECT_TRUE(arc(0.0, 6.2832).IsFullCircle());
  EXPECT_TRUE(arc(-std::numbers::pi, std::numbers::pi).IsFullCircle());
  EXPECT_TRUE(arc(1.25, 1.25).IsFullCircle());
  EXPECT_FALSE(arc(0.0, 6.28).IsFullCircle());
  EXPECT_NEAR(arc(-0.5, 0.5).GetSpan(), 1.0f, 4.0f * 4.8e-7f); // 4 roundings of an angle below 2 pi
}

TEST_F(SceneTest, AWrongFieldIsNamedWithWhatWasExpected) {
  const CChange changes[] = {
      {"/shapes/2/radius", R"("big")", R"(expected a length of at least 0, got "big")"},
      {"/shapes/2/radius", "-1", "expected a length of at least 0, got -1"},
      {"/shapes/2", R"({"radius": null})", "/shapes/2/radius: expected a length of at least 0, got nothing"},
      {"/shapes/0/position/1", "null", "expected a number, got null"},
      {"/shapes/0/position", "[1, 2, 3]", "expected a point [x, y], got [1,2,3]"},
      // A misspelled field comes before what its absence leads to.
      {"/shapes/3", R"({"motion": null, "moton": "kinematic"})",
       "/shapes/3/moton: expected no such field (known are angles, drain, elasticity, filter, flip, motion, "
       "name, position, radius, rotation_center, rotation_speed, sensor, shuttle, sides, type, velocity), "
       "got \"kinematic\""},
      {"/shapes/1", R"({"a/b: 'c'": true})",
       "/shapes/1/a~1b: 'c': expected no such field (known are drain, elasticity, filter, flip, motion, "
       "name, p0, p1, rotation_center, rotation_speed, sensor, shuttle, sides, type, velocity), got true"},
      // A name that would colour the terminal.
      {"/shapes/1", R"({"\u001b[31m": 1})",
       R"(/shapes/1/\u001b[31m: expected no such field (known are drain, elasticity, filter, flip, motion, )"
       R"(name, p0, p1, rotation_center, rotation_speed, sensor, shuttle, sides, type, velocity), got 1)"},
      {"/shapes/1/type", R"("square")",
       R"(expected one of "point", "line_segment", "circle", "arc", "capsule", got "square")"},
      {"/shapes/1", "5", "expected an object that describes a shape, got 5"},
      {"/shapes/1/sides", R"("left")", R"(expected one of "both", "front", "back", got "left")"},
      {"/shapes/3/motion", R"("dynamic")", R"(expected one of "static", "kinematic", got "dynamic")"},
      {"/shapes/3/angles/1", "90", "expected an angle in radians, from -2 pi to 2 pi, got 90"},
      {"/compounds/0/shapes/1/type", R"("compound")",
       R"(expected one of "point", "line_segment", "circle", "arc", "capsule", got "compound")"},
      {"/compounds/0/shapes/1", R"({"motion": "static"})",
       "/compounds/0/shapes/1/motion: expected no such field (known are drain, elasticity, filter, name, "
       "position, sensor, type), got \"static\""},
      {"/shapes/4/radii", "0.5", "expected two radii [r0, r1] above 0, got 0.5"},
      {"/shapes/4/radii/1", "0", "expected a number above 0, got 0"},
      {"/shapes/4", R"({"sides": "front"})",
       "/shapes/4/sides: expected no such field (known are drain, elasticity, filter, flip, motion, "
       "name, p0, p1, radii, rotation_center, rotation_speed, sensor, shuttle, type, velocity), got "
       "\"front\""},
      {"/compounds/0/flip/speed", "0", "expected a number above 0, got 0"},
      {"/balls/0/spread/speed", "1.5", "expected a fraction from 0 to 1, got 1.5"},
      {"/balls/0/mass", "0", "expected a number above 0, got 0"},
      {"/balls", "[]", "expected a list of at least one ball, got []"},
      {"", R"({"bounds": null})",
       "/bounds: expected an object with left, bottom, right and top, got nothing"},
      {"/gravity", "-9.81", "expected a vector [x, y], got -9.81"},
      {"/name", R"("")", R"(expected a text of at least one letter, got "")"},
      {"", "[1]", "/: expected an object that describes a scene, got [1]"},
      {"", R"("scene")", R"(/: expected an object that describes a scene, got "scene")"},
      // Fields that contradict each other.
      {"/shapes/2", R"({"sensor": false})", "/shapes/2/sensor: expected true for a drain, got false"},
      {"/shapes/3", R"({"motion": null})",
       R"(/shapes/3/motion: expected "kinematic" for a shape that turns, got nothing)"},
      {"/compounds/0", R"({"rotation_speed": 1})",
       "/compounds/0/rotation_speed: expected none for what has a flip, got 1"},
      {"/compounds/0/flip/period", "0.3", // 2 * 1 / (2 pi) = 0.318
       "expected the time to turn by angle at speed and back, 0.31830987 or more, got 0.3"},
      {"/shapes/3", R"({"velocity": [1, 0], "shuttle": {"way": [1, 0], "speed": 2, "period": 1}})",
       "/shapes/3/velocity: expected none for what has a shuttle, got [1,0]"},
      {"/shapes/1", R"({"shuttle": {"way": [1, 0], "speed": 2, "period": 1}})",
       R"(/shapes/1/motion: expected "kinematic" for a shape that moves, got "static")"},
      {"/shapes/3", R"({"shuttle": {"way": [1, 0], "speed": 2, "period": 0.5}})",
       "/shapes/3/shuttle/period: expected the time to go the way at speed and back, 1 or more, got 0.5"},
      {"/balls/0", R"({"grid": {"columns": 1.5, "rows": 1, "spacing": [1, 1]}})",
       "/balls/0/grid/columns: expected a whole number from 1 to 1000, got 1.5"},
      {"", R"({"lasting": 4e17})", "/lasting: expected a number from 0 to 3600, got 4e+17"},
      {"/compounds/0/flip/speed", "1e10", "expected a number above 0, up to 1000000000, got 10000000000.0"},
      {"/shapes/3/angles", "[-4, 4]", "expected two angles at most 2 pi apart, got [-4,4]"},
      {"/bounds/right", "-5", "expected a number above left, got -5"},
      {"/bounds/top", "-7", "expected a number above bottom, got -7"},
      {"/duration", "0.007", "expected at least one time_step, got 0.007"},
      {"/duration", "4e17", "expected at most 10000000 time_steps, got 4e+17"},
      {"", R"({"duration": 1e-4, "time_step": 1e-4, "lasting": 3600})",
       "/lasting: expected at most 10000000 time_steps, got 3600"},
      {"/balls/0/position", "[6.75, 0]",
       "expected a point in the bounds, the spread of the position included, got [6.75,0]"},
  };
  for (const CChange& change : changes)
    EXPECT_EQ(ErrorWith(change), ExpectedOf(change));
  EXPECT_EQ(ErrorWith({"", "{}", ""}), "no error");
}

TEST_F(SceneTest, WhatTheShapesRefuseIsNamedByItsPath) {
  const CChange changes[] = {
      {"/shapes/0/position/0", "1e19", "/shapes/0/position: expected finite"},
      {"/shapes/1/p0/1", "-1e19", "/shapes/1/p0: expected coordinates"},
      {"/shapes/1/p1/1", "3e38", "/shapes/1/p1: expected coordinates"},
      {"/shapes/2/radius", "1e19", "expected a number from 0"},
      {"/shapes/2/radius", "1e39",
       "expected a number that a float can hold, at most 3.4e38 in size, got 1e+39"},
      {"/shapes/2", R"({"elasticity": 1e7})", "/shapes/2/elasticity: expected a number from"},
      {"/shapes/3/rotation_speed", "1e10", "expected a"},
      {"/shapes/3/rotation_center/0", "1e19", "/shapes/3/rotation_center: expected finite"},
      {"/shapes/4/p1", "[1, 1.25]", "expected a point farther from p0 than the radii differ, got [1,1.25]"},
      {"/shapes/4/radii/0", "1e19", "/shapes/4/radii: expected a number above 0, up to"},
      {"/compounds/0/shapes/4/p0/0", "1e19", "/compounds/0/shapes/4/p0: expected coordinates"},
      {"/compounds/0/rotation_center/0", "1e19", "/compounds/0/rotation_center: expected finite"},
      {"/compounds/0/shapes/0/elasticity", "1e7", "expected a number from"},
      {"/time_step", "1e-60", "expected a number above 0"},
      {"/time_step", "1e7", "expected a number above 0, up to"},
      {"/gravity/0", "1e19", "/gravity: expected finite"},
      {"/length_unit", "1e19", "expected a number from 1e-18 to 1e+18"},
      {"/balls/0/mass", "1e-60", "expected a number"},
      {"/balls/0/mass", "1e37", "expected a number"},
      {"/balls/0/velocity/1", "1e19", "/balls/0/velocity: expected finite"},
      // Each coordinate could pass, but a turned start would be too fast.
      {"/balls/0/velocity", "[9e17, 9e17]", "expected finite"},
  };
  for (const CChange& change : changes)
    EXPECT_TRUE(ErrorWith(change).starts_with(ExpectedOf(change)))
        << ErrorWith(change) << "\nis not " << ExpectedOf(change);
}

TEST_F(SceneTest, SyntaxErrorsHaveLineAndColumn) {
  for (const auto& [pText, pError] : {std::pair("", "1:1: expected a scene, got an empty file"),
                                      {" \n\n", "3:1: expected a scene, got an empty file"},
                                      {"{\n  \"name\": tru\n}", "2:"},
                                      {"{\n  \"name\" 1}", "2:10: syntax error"},
                                      {"{} x", "1:4: "},
                                      {"{\"name\": \"\xff\"}", "1:11: "},
                                      {"{\"gravity\": [0, NaN]}", "1:17: "}})
    EXPECT_TRUE(ErrorOf(pText).starts_with(pError)) << ErrorOf(pText);
}

// Wherever a file ends too early, the error is a place in the text. The whole file is the control.
TEST_F(SceneTest, NoTruncatedFileGetsThrough) {
  const std::string text = OneOfEach().dump(1);
  const auto lines = [](const std::string& part) { return 1 + std::count(part.begin(), part.end(), '\n'); };
  for (std::size_t n = 0; n < text.size(); ++n) {
    const std::string part = text.substr(0, n);
    const std::string error = ErrorOf(part);
    EXPECT_EQ(error.rfind(std::to_string(lines(part)) + ":", 0), 0u) << n << " bytes: " << error;
  }
  EXPECT_EQ(ErrorOf(text), "no error");
}

TEST_F(SceneTest, WhatNoSceneHoldsIsRefused) {
  std::string text = OneOfEach().dump();
  const std::string radius = "\"radius\":0.25";
  text.replace(text.find(radius), radius.size(), "\"radius\":1e999");
  EXPECT_EQ(ErrorOf(text), " /shapes/2/radius: expected a number that a double can hold, got 1e999");
  EXPECT_EQ(ErrorOf("[-1e999]"), " /0: expected a number that a double can hold, got -1e999");
  EXPECT_EQ(ErrorOf(R"({"balls": [{"radius": 1, "radius": 2}]})"),
            " /balls/0/radius: expected each field once, got it a second time");
  EXPECT_TRUE(Says(ErrorOf(std::string(200000, '[')), "expected at most 16 levels, got another one"));
  EXPECT_EQ(ErrorWith({"/gravity", ('"' + std::string(1000, 'g') + '"').c_str(), ""}), // shortened
            " /gravity: expected a vector [x, y], got \"" + std::string(59, 'g') + "...");
}

TEST_F(SceneTest, FilesThatCannotBeReadAreRefused) {
  const auto what = [](const std::filesystem::path& file) {
    return MessageOf<CSceneError>([&] { LoadScene(file); });
  };
  const auto missing = m_cFolder / "missing.json";
  EXPECT_EQ(what(missing),
            missing.string() + ": expected a file that can be read, got No such file or directory");
  EXPECT_EQ(what(m_cFolder), m_cFolder.string() + ": expected a file that can be read, got a folder");
  EXPECT_THROW(LoadScenes(missing), CSceneError);
  // Neither ends when it is read.
  const auto pipe = m_cFolder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::filesystem::path& file : {pipe, std::filesystem::path("/dev/zero")})
    EXPECT_EQ(what(file), file.string() + ": expected a file that can be read, got a device or a pipe");
  const std::string large = Write("large.json", "{}");
  std::filesystem::resize_file(large, 65u << 20); // takes no place on the disk
  EXPECT_EQ(what(large), large + ": expected a file that can be read, got 65 MB, more than the 64 MB "
                                 "of the largest scene");
  std::filesystem::resize_file(large, 2);
  EXPECT_EQ(what(large), large + ": /name: expected a text of at least one letter, got nothing");
}

TEST_F(SceneTest, AFolderIsLoadedInTheOrderOfItsFileNames) {
  json doc = OneOfEach();
  for (const char* name : {"b", "c", "a"}) {
    doc["name"] = std::string("scene ") + name;
    Write(std::string(name) + ".json", doc.dump());
  }
  Write("readme.txt", "not a scene");
  const auto scenes = LoadScenes(m_cFolder);
  ASSERT_EQ(scenes.size(), 3u);
  EXPECT_EQ(scenes[0].m_sName, "scene a");
  EXPECT_EQ(scenes[1].m_sName, "scene b");
  EXPECT_EQ(scenes[2].m_sName, "scene c");

  const std::string again = Write("d.json", doc.dump());
  EXPECT_EQ(MessageOf<CSceneError>([&] { LoadScenes(m_cFolder); }),
            again + ": /name: expected a name that no other scene of the folder has, got \"scene a\"");
}

} // namespace
} // namespace Shapes::Compare
