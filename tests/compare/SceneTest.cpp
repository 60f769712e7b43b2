// SPDX-License-Identifier: MIT
#include "MadeScenes.h"
#include "OwnFolder.h"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include <numbers>

namespace Shapes::Compare {
namespace {

using nlohmann::json;
using Tests::ToDesc;

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

  // What the error says after the name of the file.
  std::string ErrorOf(const std::string& text) const {
    const std::string file = Write("s.json", text);
    const std::string what = MessageOf<CSceneError>([&] { LoadScene(file); });
    if (what.empty()) return "no error";
    EXPECT_EQ(what.rfind(file + ":", 0), 0u) << what;
    return what.substr(file.size() + 1);
  }
  std::string ErrorWith(const CChange& change) const {
    json doc = Valid();
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

  static json Valid() {
    return json::parse(R"({
      "name": "all", "description": "one of each", "length_unit": 2, "gravity": [1, -9.5],
      "time_step": 0.0078125, "duration": 3, "bounds": {"left": -5, "bottom": -6, "right": 7, "top": 8},
      "shapes": [
        {"type": "point", "name": "post", "position": [1, 2], "elasticity": 0.5},
        {"type": "line_segment", "p0": [3, 0], "p1": [-3, 1], "sides": "back", "sensor": true},
        {"type": "circle", "position": [4, 4], "radius": 0.25, "drain": true},
        {"type": "arc", "position": [0, 5], "radius": 2, "angles": [3, 0.5], "sides": "front",
         "motion": "kinematic", "rotation_speed": -0.5, "rotation_center": [0, 4]}],
      "compounds": [
        {"rotation_center": [-2, -2], "flip": {"angle": -1, "speed": 1, "period": 2, "phase": 0.5},
         "shapes": [{"type": "line_segment", "p0": [-2, -2], "p1": [-1, -2], "elasticity": 0.75},
                    {"type": "point", "position": [-1, -2], "name": "tip"}]}],
      "balls": [
        {"position": [0, 0], "velocity": [3, 4], "radius": 0.5, "mass": 2, "elasticity": 0.25,
         "spread": {"position": [0.5, 1], "direction": 0.125, "speed": 0.5}}]})");
  }
};

TEST_F(SceneTest, EveryFieldArrives) {
  const CScene scene = Load(Valid());
  EXPECT_EQ(scene.m_sName, "all");
  EXPECT_EQ(scene.m_sDescription, "one of each");
  EXPECT_EQ(scene.m_cPath, m_cFolder / "s.json");
  EXPECT_EQ(scene.m_fDuration, 3.0f);
  EXPECT_EQ(scene.m_cBounds.GetTopLeft(), Vector2(-5.0f, 8.0f));
  EXPECT_EQ(scene.m_cBounds.GetBottomRt(), Vector2(7.0f, -6.0f));

  CSceneDesc expected;
  expected.m_stdNotes = {"one of each"};
  expected.m_cWorld.m_cBox2D.m_fLengthUnit = 2.0f;
  expected.m_cWorld.m_vGravity = {1.0f, -9.5f};
  expected.m_cWorld.m_fTimeStep = 0.0078125f;
  expected.m_stdShapes = {CPointDesc({1, 2}, 0.5f),
                          Sensor(Sided(CLineSegDesc({3, 0}, {-3, 1}), eSides::Back)),
                          MakeZone({4, 4}, 0.25f), // a drain without being called one
                          Turning(Sided(CArcDesc({0, 5}, 2, 3, 0.5f), eSides::Front), -0.5f, {0, 4}),
                          Turning(CLineSegDesc({-2, -2}, {-1, -2}, 0.75f), 0, {-2, -2}),
                          Turning(CPointDesc({-1, -2}), 0, {-2, -2})};
  expected.m_stdBalls = {CDynamicCircleDesc({0, 0}, 0.5f, {3, 4}, 2, 0.25f)};
  EXPECT_EQ(ToDesc(scene).ToJson("all", 3), expected.ToJson("all", 3));
  for (std::size_t i = 0; i < 6; ++i) {
    const CSceneShape& shape = scene.m_stdShapes.at(i);
    EXPECT_EQ(shape.m_sName, i == 0 ? "post" : i == 5 ? "tip" : "");
    EXPECT_EQ(shape.m_bIsDrain, i == 2);
    ASSERT_EQ(shape.m_cFlip.has_value(), i >= 4);
    if (i < 4) continue;
    EXPECT_EQ(shape.m_cFlip->m_fAngle, -1.0f);
    EXPECT_EQ(shape.m_cFlip->m_fSpeed, 1.0f);
    EXPECT_EQ(shape.m_cFlip->m_fPeriod, 2.0f);
    EXPECT_EQ(shape.m_cFlip->m_fPhase, 0.5f);
  }
  const CSceneBall& ball = scene.m_stdBalls.at(0);
  EXPECT_EQ(ball.m_vSpread, Vector2(0.5f, 1.0f));
  EXPECT_EQ(ball.m_fTurn, 0.125f);
  EXPECT_EQ(ball.m_fSpeedSpread, 0.5f);
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

TEST_F(SceneTest, ACapsuleIsTheShapesOfMakeCapsule) {
  json doc = Valid();
  const json capsule = {{"type", "capsule"}, {"p0", {1, 1}},         {"p1", {2, 3}},
                        {"name", "finger"},  {"radii", {0.5, 0.25}}, {"elasticity", 0.5}};
  doc["shapes"] = json::array({capsule});
  doc["compounds"][0]["shapes"] = json::array({capsule});
  const CScene scene = Load(doc);
  CLineSegDesc like({0, 0}, {0, 0}, 0.5f);
  CSceneDesc expected;
  expected.m_stdNotes = {"one of each"};
  expected.m_cWorld = scene.m_cWorld;
  expected.m_stdShapes = MakeCapsule({1, 1}, 0.5f, {2, 3}, 0.25f, like);
  for (const CAnyShapeDesc& any : MakeCapsule({1, 1}, 0.5f, {2, 3}, 0.25f, Turning(like, 0, {-2, -2})))
    expected.m_stdShapes.push_back(any);
  expected.m_stdBalls = {scene.m_stdBalls.at(0).m_cDesc};
  EXPECT_EQ(ToDesc(scene).ToJson("all", 3), expected.ToJson("all", 3));
  ASSERT_EQ(scene.m_stdShapes.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(scene.m_stdShapes[i].m_sName, "finger");
    EXPECT_EQ(scene.m_stdShapes[i].m_cFlip.has_value(), i >= 4);
  }
}

TEST_F(SceneTest, AWholeTurnIsAFullCircle) {
  const auto arc = [&](double a0, double a1) {
    json doc = Valid();
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

TEST_F(SceneTest, FieldsThatContradictEachOtherAreRefused) {
  const CChange changes[] = {
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
       R"(/shapes/1/motion: expected "kinematic" for a shape that moves, got nothing)"},
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
}

TEST_F(SceneTest, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_EQ(ErrorOf(""), "1:1: expected a scene, got an empty file");
  EXPECT_EQ(ErrorOf(" \n\n"), "3:1: expected a scene, got an empty file");
  EXPECT_EQ(ErrorOf("{\n  \"name\": tru\n}").rfind("2:", 0), 0u) << ErrorOf("{\n  \"name\": tru\n}");
  EXPECT_EQ(ErrorOf("{\n  \"name\" 1}").rfind("2:10: syntax error", 0), 0u) << ErrorOf("{\n  \"name\" 1}");
  EXPECT_EQ(ErrorOf("{} x").rfind("1:4: ", 0), 0u) << ErrorOf("{} x");
  EXPECT_EQ(ErrorOf("{\"name\": \"\xff\"}").rfind("1:11: ", 0), 0u) << ErrorOf("{\"name\": \"\xff\"}");
  EXPECT_EQ(ErrorOf("{\"gravity\": [0, NaN]}").rfind("1:17: ", 0), 0u);
}

// Wherever a file ends too early, the error is a place in the text. The whole file is the control.
TEST_F(SceneTest, NoTruncatedFileGetsThrough) {
  const std::string text = Valid().dump(1);
  const auto lines = [](const std::string& part) { return 1 + std::count(part.begin(), part.end(), '\n'); };
  for (std::size_t n = 0; n < text.size(); ++n) {
    const std::string part = text.substr(0, n);
    const std::string error = ErrorOf(part);
    EXPECT_EQ(error.rfind(std::to_string(lines(part)) + ":", 0), 0u) << n << " bytes: " << error;
  }
  EXPECT_EQ(ErrorOf(text), "no error");
}

TEST_F(SceneTest, NumbersBeyondDoubleAreNamedByTheirPath) {
  const std::string text = Valid().dump();
  const std::string radius = "\"radius\":0.25";
  const std::size_t at = text.find(radius);
  ASSERT_NE(at, std::string::npos);
  const std::string wrong = text.substr(0, at) + "\"radius\":1e999" + text.substr(at + radius.size());
  EXPECT_EQ(ErrorOf(wrong), " /shapes/2/radius: expected a number that a double can hold, got 1e999");
  EXPECT_EQ(ErrorOf("[-1e999]"), " /0: expected a number that a double can hold, got -1e999");
}

TEST_F(SceneTest, RepeatedFieldsAndEndlessNestingAreRefused) {
  EXPECT_EQ(ErrorOf(R"({"balls": [{"radius": 1, "radius": 2}]})"),
            " /balls/0/radius: expected each field once, got it a second time");
  EXPECT_TRUE(Says(ErrorOf(std::string(200000, '[')), "expected at most 16 levels, got another one"));
}

TEST_F(SceneTest, LongValuesAreShortened) {
  EXPECT_EQ(ErrorWith({"/gravity", ('"' + std::string(1000, 'g') + '"').c_str(), ""}),
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
  json doc = Valid();
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

TEST(GridTest, StandsForRowsAndColumnsOfBalls) {
  const CScene scene = ParseScene("s.json", R"({"name": "n", "duration": 1, "lasting": 2,
    "bounds": {"left": 0, "bottom": 0, "right": 9, "top": 9},
    "balls": [{"position": [1, 2], "radius": 0.1, "elasticity": 0.5,
               "grid": {"columns": 3, "rows": 2, "spacing": [0.5, 4]}}]})");
  EXPECT_EQ(scene.m_fLasting, 2.0f);
  ASSERT_EQ(scene.m_stdBalls.size(), 6u);
  EXPECT_EQ(scene.m_stdBalls[0].m_cDesc.m_vPos, Vector2(1, 2));
  EXPECT_EQ(scene.m_stdBalls[2].m_cDesc.m_vPos, Vector2(2, 2));
  EXPECT_EQ(scene.m_stdBalls[3].m_cDesc.m_vPos, Vector2(1, 6));
  EXPECT_EQ(scene.m_stdBalls[5].m_cDesc.m_fElasticity, 0.5f);
}

} // namespace
} // namespace Shapes::Compare
