// SPDX-License-Identifier: MIT
// compare/scene.schema.json, which editors read, and the reader of scene files accept and refuse the same.
#include "scene/Scene.h"
#include "schema/Schema.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Compare {
namespace {

using nlohmann::json;
using CPath = json::json_pointer;

const json& Schema() {
  static const json schema = Tests::ReadJsonSource("compare/scene.schema.json");
  return schema;
}

json OneOfEach() {
  return json::parse(R"({
    "$schema": "scene.schema.json", "name": "all", "description": "one of each", "length_unit": 2,
    "gravity": [1, -9.5], "time_step": 0.0078125, "duration": 3, "lasting": 4,
    "bounds": {"left": -5, "bottom": -6, "right": 7, "top": 8},
    "shapes": [
      {"type": "point", "name": "post", "position": [1, 2], "elasticity": 0.5, "filter": [2, 3], "motion": "kinematic",
       "rotation_speed": 1, "rotation_center": [0, 4],
       "shuttle": {"way": [1, 0], "speed": 2, "period": 1, "phase": 0.5}},
      {"type": "line_segment", "p0": [3, 0], "p1": [-3, 1], "sides": "back", "sensor": true, "motion": "static",
       "filter": [0, 65535]},
      {"type": "circle", "position": [4, 4], "radius": 0.25, "drain": true, "motion": "kinematic",
       "flip": {"angle": 1, "speed": 1, "period": 2}},
      {"type": "arc", "position": [0, 5], "radius": 2, "angles": [3, 0.5], "sides": "front"}],
    "compounds": [
      {"rotation_center": [-2, -2], "flip": {"angle": -1, "speed": 1, "period": 2, "phase": 0.5},
       "shapes": [{"type": "line_segment", "p0": [-2, -2], "p1": [-1, -2], "elasticity": 0.75, "sides": "both"},
                  {"type": "point", "position": [-1, -2], "name": "tip"},
                  {"type": "circle", "position": [-1, -2], "radius": 0.5, "sensor": true},
                  {"type": "arc", "position": [-1, -2], "radius": 0.5, "angles": [0, 1], "drain": false}]},
      {"rotation_center": [0, 0], "rotation_speed": 1, "shapes": [{"type": "point", "position": [-1, -2]}]}],
    "balls": [
      {"position": [0, 0], "velocity": [3, 4], "radius": 0.5, "mass": 2, "elasticity": 0.25, "filter": [4, 1],
       "spread": {"position": [0.5, 1], "direction": 0.125, "speed": 0.5},
       "grid": {"columns": 2, "rows": 3, "spacing": [0.5, 0.5]}}]})");
}

// Each field left out, each field with each of these values, and each of these fields in each object.
std::vector<json> MakeChanges(const json& good) {
  const std::vector<json> values = {
      nullptr,        true, -1,      0.5,      7,          "",        "x",      "arc",  json::array(),
      json::object(), {0},  {1, -1}, {1, 0.5}, {65536, 0}, {0, 0, 0}, {0, "x"}, {7, 0}, {{"speed", 1}}};
  const std::vector<std::pair<const char*, json>> fields = {
      {"surplus", 1},          {"name", "n"},         {"radius", 1},
      {"sides", "both"},       {"sensor", false},     {"filter", {1, 2}},
      {"motion", "kinematic"}, {"rotation_speed", 0}, {"phase", 0}};
  std::vector<json> changes;
  const auto change = [&](const CPath& path, const json& value) {
    changes.push_back(good);
    changes.back()[path] = value;
  };
  const std::function<void(const json&, const CPath&)> visit = [&](const json& value, const CPath& path) {
    for (const json& other : values)
      change(path, other);
    if (value.is_object()) {
      for (const auto& [name, other] : fields)
        if (!value.contains(name)) change(path / name, other);
      for (const auto& field : value.items()) {
        changes.push_back(good);
        changes.back()[path].erase(field.key());
        visit(field.value(), path / field.key());
      }
    } else if (value.is_array())
      for (std::size_t i = 0; i < value.size(); ++i)
        visit(value[i], path / i);
  };
  visit(good, CPath());
  return changes;
}

// Why the reader refuses a document; empty if it does not.
std::string FindReaderFault(const json& doc) {
  try {
    ParseScene("s.json", doc.dump());
    return {};
  } catch (const CSceneError& error) {
    return error.what();
  }
}

// Rules that a schema cannot express: between two fields, or of the shapes themselves.
bool IsBeyondSchemas(const std::string& fault) {
  constexpr std::string_view reasons[] = {
      "expected at least one time_step", "expected a number above left",
      "expected a number above bottom",  "expected \"kinematic\" for a shape that",
      "expected the time to turn",       "expected none for what has a flip",
      "expected the time to go",         "expected none for what has a shuttle",
      "expected two angles at most",     "expected true for a drain",
      "expected a point in the bounds"};
  return std::any_of(std::begin(reasons), std::end(reasons),
                     [&](std::string_view reason) { return fault.find(reason) != std::string::npos; });
}

// The documents about which schema and reader differ.
std::vector<std::string> FindDifferences(const json& schema, const std::vector<json>& docs) {
  const std::vector<std::string> bySchema = Tests::FindSchemaFaults(schema, docs);
  std::vector<std::string> differences;
  for (std::size_t i = 0; i < docs.size(); ++i) {
    const std::string byReader = FindReaderFault(docs[i]);
    const bool readerRefuses = !byReader.empty() && !IsBeyondSchemas(byReader);
    if (readerRefuses == bySchema[i].empty())
      differences.push_back("schema: '" + bySchema[i] + "', reader: '" + byReader + "', " + docs[i].dump());
  }
  return differences;
}

TEST(SceneSchemaTest, BundledScenesFitTheSchema) {
  std::vector<json> docs;
  for (const auto& entry : std::filesystem::directory_iterator(SHAPES_SCENES_DIR))
    docs.push_back(Tests::ReadJsonSource("compare/scenes/" + entry.path().filename().string()));
  EXPECT_GE(docs.size(), 23u);
  for (const std::string& fault : Tests::FindSchemaFaults(Schema(), docs))
    EXPECT_EQ(fault, "");
}

TEST(SceneSchemaTest, ReaderAndSchemaRefuseTheSameChanges) {
  ASSERT_EQ(FindReaderFault(OneOfEach()), "");
  const std::vector<json> docs = MakeChanges(OneOfEach());
  EXPECT_GT(docs.size(), 1500u);
  const auto accepted =
      std::count_if(docs.begin(), docs.end(), [](const json& doc) { return FindReaderFault(doc).empty(); });
  EXPECT_GT(accepted, 100);
  EXPECT_GT(static_cast<std::ptrdiff_t>(docs.size()) - accepted, 1000);
  for (const std::string& difference : FindDifferences(Schema(), docs))
    ADD_FAILURE() << difference;
}

// Controls: a rule too few and a rule too many are seen.
TEST(SceneSchemaTest, AnotherSchemaDiffers) {
  const std::vector<json> docs = MakeChanges(json::parse(R"({"name": "n", "duration": 3,
    "bounds": {"left": -5, "bottom": -6, "right": 7, "top": 8},
    "compounds": [{"rotation_center": [0, 0], "shapes": [{"type": "point", "position": [1, 2]}]}],
    "shapes": [{"type": "arc", "position": [0, 0], "radius": 2, "sides": "back", "elasticity": 0}],
    "balls": [{"position": [0, 0], "radius": 1}]})"));
  ASSERT_TRUE(FindDifferences(Schema(), docs).empty());
  for (const auto& [path, value] : std::vector<std::pair<const char*, json>>{
           {"/properties/balls/minItems", 0},
           {"/definitions/length", {{"type", "number"}}},
           {"/definitions/elasticity/maximum", 0.25},
           {"/definitions/ball/required", {"position", "radius", "mass"}},
           {"/definitions/compound_point/additionalProperties", true},
           {"/definitions/sides/enum", {"both", "front"}}}) {
    json other = Schema();
    other[CPath(path)] = value;
    EXPECT_GT(FindDifferences(other, docs).size(), 0u) << path;
  }
}

} // namespace
} // namespace Shapes::Compare
