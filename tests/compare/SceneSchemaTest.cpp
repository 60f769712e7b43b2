// SPDX-License-Identifier: MIT
// compare/scene.schema.json, which editors read, and the reader of scene files accept and refuse the same;
// and the reader reads a scene that a program wrote.
#include "CommandCalls.h"
#include "MadeScenes.h"
#include "schema/Schema.h"

#include <bit>

namespace Shapes::Compare::Tests {
namespace {

using nlohmann::json;
using CPath = json::json_pointer;

const json& Schema() {
  static const json schema = ReadJsonSource("compare/scene.schema.json");
  return schema;
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
  VisitValues(good, [&](const json& value, const CPath& path) {
    for (const json& other : values)
      change(path, other);
    if (!value.is_object()) return;
    for (const auto& [name, other] : fields)
      if (!value.contains(name)) change(path / name, other);
    for (const auto& field : value.items()) {
      changes.push_back(good);
      changes.back()[path].erase(field.key());
    }
  });
  return changes;
}

// Why the reader refuses a document; empty if it does not.
std::string FindReaderFault(const json& doc) {
  return MessageOf<CSceneError>([&] { ParseScene("s.json", doc.dump()); });
}

// Rules that a schema cannot express: between two fields, or of the shapes themselves.
bool IsBeyondSchemas(const std::string& fault) {
  constexpr std::string_view reasons[] = {
      "expected at least one time_step", "expected a number above left",
      "expected a number above bottom",  "expected \"kinematic\" for a shape that",
      "expected the time to turn",       "expected none for what has a flip",
      "expected the time to go",         "expected none for what has a shuttle",
      "expected two angles at most",     "expected true for a drain",
      "expected a point in the bounds",  "expected a point farther from p0"};
  return std::any_of(std::begin(reasons), std::end(reasons),
                     [&](std::string_view reason) { return fault.find(reason) != std::string::npos; });
}

// The documents about which schema and reader differ.
std::vector<std::string> FindDifferences(const json& schema, const std::vector<json>& docs) {
  const std::vector<std::string> bySchema = FindSchemaFaults(schema, docs);
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
    docs.push_back(ReadJsonSource("compare/scenes/" + entry.path().filename().string()));
  EXPECT_GE(docs.size(), 23u);
  for (const std::string& fault : FindSchemaFaults(Schema(), docs))
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

using SceneDescTest = CFolderTest;

// That a program writes what the reader reads is tested by their texts. Mechanism of the last one: the reader
// rounds the text to double and that to float. The double nearest to 7.038531e-26, the shortest text of this
// float, lies exactly between it and the next one. A search through all floats found no other.
TEST_F(SceneDescTest, EveryFloatAndEveryNoteSurvives) {
  const auto between = std::bit_cast<float>(0x15AE43FDu);
  EXPECT_NE(static_cast<float>(7.038531e-26), between); // the control: double first
  CRandom random(5);
  for (int n = 0; n < 20; ++n) {
    CSceneDesc desc;
    desc.m_stdNotes = {"A note with \"quotes\", \\ and \t."};
    desc.m_stdBalls = {CDynamicCircleDesc({between, -between}, 1)};
    for (int i = 0; i < 500; ++i) {
      const Vector2 p = random.Vector(-60, 50);
      desc.m_stdShapes.emplace_back(CPointDesc(p, random.Scale(-40, 18)));
    }
    const CScene scene = LoadScene(Write("s.json", desc.ToJson("imported", 0.5f)));
    EXPECT_EQ(scene.m_sDescription, desc.m_stdNotes[0]);
    EXPECT_EQ(scene.m_stdBalls.at(0).m_cDesc.m_vPos, Vector2(between, -between));
    const std::vector<CAnyShapeDesc> loaded = GetShapes(scene);
    ASSERT_EQ(loaded.size(), desc.m_stdShapes.size());
    for (std::size_t i = 0; i < loaded.size(); ++i) {
      const auto &a = std::get<CPointDesc>(desc.m_stdShapes[i]), &b = std::get<CPointDesc>(loaded[i]);
      ASSERT_TRUE(a.m_vPos == b.m_vPos && a.m_fElasticity == b.m_fElasticity)
          << "seed " << random.GetSeed() << ": " << a.m_vPos.transpose() << ", " << a.m_fElasticity;
    }
  }
}

} // namespace
} // namespace Shapes::Compare::Tests
