// SPDX-License-Identifier: MIT
// run.json fits compare/run.schema.json, which is strict and describes every field.
#include "app/Run.h"

#include "SampleReport.h"
#include "schema/Schema.h"

namespace Shapes::Compare {
namespace {

using nlohmann::json;

// The schema of an engine allows any figure by its form; here it has each row of the table, and no other.
json MakeStrictSchema() {
  json schema = Tests::ReadJsonSource("compare/run.schema.json");
  json& engine = schema.at("/definitions/engine"_json_pointer);
  engine["additionalProperties"] = false;
  for (const CFigure& figure : GetFigures()) {
    const char* pForm = figure.m_pRate != nullptr                     ? "rate"
                        : figure.m_pOfImpact != nullptr               ? "summary"
                        : std::string_view(figure.m_sUnit) == "balls" ? "count"
                                                                      : "number_or_null";
    engine["properties"][figure.m_sKey] = {{"$ref", std::string("#/definitions/") + pForm}};
    engine["required"].push_back(figure.m_sKey);
  }
  return schema;
}

const json& SchemaJson() {
  static const json schema = MakeStrictSchema();
  return schema;
}

// Where a document does not fit the schema; empty if it does.
std::string FindFault(const json& doc) { return Tests::FindSchemaFaults(SchemaJson(), {doc}).front(); }

TEST(RunJsonTest, ARealRunFitsTheSchema) {
  CProgress progress(2, false);
  const json doc = json::parse(MakeJson(RunScenes({LoadBundled("bowl"), LoadBundled("pinball")}, GetEngines(),
                                                  g_cQuickSizes.ForContacts(40), 3, progress, [] {})));
  EXPECT_EQ(FindFault(doc), "");
  ASSERT_EQ(doc.at("scenes").size(), 2u);
  EXPECT_EQ(doc.at("/scenes/1/engines/2/settings/velocity_iterations"_json_pointer), 8);
}

TEST(RunJsonTest, TheSampleFitsTheSchema) {
  CRunReport report = MakeSampleReport(); // as it is: AChangedDocumentIsRefused
  report.m_stdScenes.push_back(MakeUndecidedScene());
  report.m_bInterrupted = true;
  report.m_nSeed = std::numeric_limits<std::uint64_t>::max();
  report.m_sCommand = "shapes-compare run --out \xff"; // no text
  EXPECT_EQ(FindFault(json::parse(MakeJson(report))), "");
  report.m_stdScenes.clear();
  EXPECT_EQ(FindFault(json::parse(MakeJson(report))), "");
}

// One engine alone, and two profiles of one.
TEST(RunJsonTest, WithoutTwoBackendsNothingIsApart) {
  using CNumbers = std::vector<std::size_t>;
  for (const CNumbers& engines : {CNumbers{Tests::g_nNative}, {Tests::g_nBox2D, Tests::g_nTuned}}) {
    const json doc = json::parse(MakeJson(MakeSampleReport(engines)));
    EXPECT_EQ(FindFault(doc), "");
    EXPECT_TRUE(doc.at("/scenes/0/apart"_json_pointer).is_null());
  }
}

TEST(RunJsonTest, FiguresAreWhereTheyBelong) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes.push_back(MakeUndecidedScene());
  const json doc = json::parse(MakeJson(report));
  const auto at = [&](const std::string& path) { return doc.at(json::json_pointer(path)); };
  const std::pair<const char*, const char*> expected[] = {
      {"", R"({"version": 5, "seed": 5, "contacts_per_scene": 1000})"},
      {"/scenes/0", R"({"features": ["kinematics"], "shapes": 3, "take": "box2d-tuned", "not_counted": null,
          "set_aside": {"resting": 1, "ambiguous": 2, "simultaneous": 3, "undecided": 0,
                        "first_undecided": null}})"},
      {"/scenes/0/apart", R"({"p95": 0.5})"},
      {"/scenes/0/engines/0", R"({"contacts": 1000, "correct": 983, "features": ["kinematics", "continuous"],
          "grade": "poor", "energy_drift": -0.03, "free_path_error": null})"},
      {"/scenes/0/engines/0/ghost", R"({"rate": 0.0025})"},
      {"/scenes/0/engines/0/settings", R"({"forced": [], "forbidden": []})"},
      {"/scenes/0/engines/1", R"({"features": ["kinematics"], "ns_per_contact": 5000.0})"},
      {"/scenes/0/engines/1/missed", R"({"count": 101})"},
      {"/scenes/0/engines/1/wrong_side", R"({"count": 102})"},
      {"/scenes/0/engines/1/tunneled", R"({"rate": 0.203})"},
      {"/scenes/0/engines/1/settings", R"({"forbidden": ["continuous"]})"},
      {"/scenes/0/engines/2/settings", R"({"profile": "shipped"})"},
      {"/scenes/0/engines/3", R"({"features": ["kinematics", "continuous"], "grade": "good"})"},
      {"/scenes/0/engines/3/settings", R"({"forced": [], "profile": "tuned"})"},
      {"/scenes/0/answers/0", R"({"without": ["native"]})"},
      {"/scenes/0/answers/0/choices/0", R"({"engine": "box2d"})"},
      {"/scenes/0/answers/0/choices/1", R"({"ns_ratio": 1.0})"},
      {"/scenes/0/answers/1/closest", R"({"direction_error_p95": 0.02})"},
      {"/scenes/0/heat_map/cells/0", R"({"tunneled": [1, 3, 2, 0]})"},
      {"/scenes/1", R"({"take": null})"},
      {"/engines/1", R"({"name": "native-approximate"})"},
      {"/overall", R"({"impacts": 1000, "scenes": 1, "take": "box2d-tuned"})"},
      {"/overall/engines/1", R"({"direction_error_p95": 2.0})"},
      {"/overall/engines/1/tunneled", R"({"count": 203})"},
      {"/overall/engines/2", R"({"direction_error_p95": null})"},
      {"/work_precision/0", R"({"direction_error_p95": null})"},
      {"/work_precision/0/tunneled_rate", R"({"rate": 0.2})"},
      {"/work_precision/2/settings", R"({"profile": "tuned"})"},
      {"/work_precision/3", R"({"engine": "exact", "settings": {}})"},
      {"/work_precision/4", R"({"scene": "hopeless"})"},
      {"/effects/1", R"({"scene": "spinner", "engine": "native", "effect": "kinematics", "runs": 0.25,
          "why": "3 shapes rotate"})"},
      {"/effects/1/with", R"({"instructions_per_ball_step": 1000})"},
      {"/effects/1/without", R"({"instructions_per_ball_step": 700})"},
      {"/effects/2", R"({"effect": "ball_pairs"})"},
      {"/effects/4/without/tunneled", R"({"rate": null})"}, // nobody tells of impacts
      {"/effects/4/with/touches_missed", R"({"rate": null})"},
      {"/effects/5/without/tunneled", R"({"rate": 0.5})"},
      {"/effects/5/with/flight_error", R"({"p95": 0.5})"},
      {"/effects/6", R"({"scene": "hopeless"})"}};
  for (const auto& [pPath, pFields] : expected) {
    const json fields = json::parse(pFields);
    for (const auto& field : fields.items())
      EXPECT_EQ(at(pPath).at(field.key()), field.value()) << pPath << "/" << field.key();
  }
  EXPECT_EQ(at("/histogram_edges/0"), 1e-6);
  EXPECT_EQ(at("/histogram_edges/24"), 1.0);
  EXPECT_EQ(at("/scenes/0/engines/0/setback_error_histogram/31"), 28);
  EXPECT_NEAR(at("/scenes/0/engines/1/tunneled/low").get<double>(), 0.179, 5e-4);
  EXPECT_NEAR(at("/overall/engines/0/ns_box2d_ratio").get<double>(), 500.0 / 70.0, 0.2);
  EXPECT_NEAR(at("/effects/1/ns_ratio").get<double>(), 1.5, 1e-9);
  EXPECT_FALSE(at("/scenes/0/engines/0/settings").contains("profile")); // native has none
  EXPECT_EQ(at("/figures").size(), GetFigures().size());
  for (const auto& figure : at("/figures"))
    EXPECT_TRUE(at("/scenes/0/engines/0").contains(figure.at("key").get<std::string>())) << figure;
}

TEST(RunJsonTest, WhatWasNotMeasuredOrIsNotFiniteIsNullAndNotZero) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes.insert(report.m_stdScenes.begin(), MakeUndecidedScene());
  CEngineReport& wild = report.m_stdScenes[1].m_stdEngines[0];
  wild.m_cLongRun.m_fEnergyDrift = std::numeric_limits<double>::quiet_NaN();
  wild.m_cTotals["penetration"].m_fMax = std::numeric_limits<double>::infinity();
  const json doc = json::parse(MakeJson(report));
  EXPECT_EQ(FindFault(doc), "");
  EXPECT_TRUE(doc.at("/scenes/1/engines/0/energy_drift"_json_pointer).is_null());
  EXPECT_TRUE(doc.at("/scenes/1/engines/0/penetration/max"_json_pointer).is_null());
  const json& scene = doc.at("scenes")[0];
  EXPECT_EQ(scene.at("set_aside").at("undecided"), 40);
  EXPECT_EQ(scene.at("set_aside").at("first_undecided"), "trial 0, step 2: ball 0 is jammed at (1, 2)");
  const json& engine = scene.at("engines")[0];
  EXPECT_EQ(engine.at("tunneled"), json::parse(R"({"count": 0, "rate": null, "low": 0.0, "high": 1.0})"));
  EXPECT_EQ(engine.at("setback_error"),
            json::parse(R"({"count": 0, "median": null, "p95": null, "max": null})"));
  for (const char* pKey : {"ns_per_contact", "energy_drift"})
    EXPECT_TRUE(engine.at(pKey).is_null()) << pKey;
}

// The control: every single field of the document matters to the schema.
TEST(RunJsonTest, AChangedDocumentIsRefused) {
  const json good = json::parse(MakeJson(MakeSampleReport()));
  ASSERT_EQ(FindFault(good), "");
  std::vector<json> docs;
  std::vector<std::string> changes;
  const auto expectRefused = [&](json bad, const std::string& what) {
    docs.push_back(std::move(bad));
    changes.push_back(what);
  };
  std::set<std::string> seen; // each kind of object once
  const std::function<void(const json&, const json::json_pointer&)> visit =
      [&](const json& value, const json::json_pointer& path) {
        if (value.is_array())
          for (std::size_t i = 0; i < value.size(); ++i)
            visit(value[i], path / i);
        if (!value.is_object()) return;
        std::string kind;
        for (const auto& field : value.items())
          kind += field.key() + " ";
        if (!seen.insert(kind).second) return;
        json bad = good;
        bad[path]["surplus"] = 1;
        expectRefused(bad, (path / "surplus").to_string());
        for (const auto& field : value.items()) {
          const json::json_pointer here = path / field.key();
          bad = good;
          bad[path].erase(field.key());
          expectRefused(bad, "without " + here.to_string());
          bad = good;
          bad[here] = field.value().is_boolean() ? json(1) : json(true);
          expectRefused(bad, "of another type: " + here.to_string());
          visit(field.value(), here);
        }
      };
  visit(good, json::json_pointer());
  EXPECT_GT(changes.size(), 200u);

  for (const auto& [pPath, value] :
       std::initializer_list<std::pair<const char*, json>>{{"/scenes/0/engines/0/missed/rate", 1.5},
                                                           {"/scenes/0/engines/0/contacts", -1},
                                                           {"/scenes/0/engines/0/name", "jolt"},
                                                           {"/version", 1}}) {
    json bad = good;
    bad[json::json_pointer(pPath)] = value;
    expectRefused(bad, pPath);
  }

  const std::vector<std::string> faults = Tests::FindSchemaFaults(SchemaJson(), docs);
  for (std::size_t i = 0; i < docs.size(); ++i)
    EXPECT_NE(faults[i], "") << changes[i];
}

void VisitObjects(const json& schema, const std::function<void(const json&)>& visit) {
  if (schema.is_object() && schema.contains("properties")) visit(schema);
  if (schema.is_structured())
    for (const json& part : schema)
      VisitObjects(part, visit);
}

TEST(RunJsonTest, TheSchemaAllowsNoOtherFieldAndRequiresEach) {
  VisitObjects(SchemaJson(), [&](const json& object) {
    EXPECT_EQ(object.at("additionalProperties"), false);
    // The settings are those of one engine or the other.
    const bool isSettings = object.at("properties").contains("substeps");
    EXPECT_TRUE(isSettings || object.at("required").size() == object.at("properties").size()) << object;
  });
}

// The names of fields that have no description, neither of their own nor of the definition that they refer
// to.
std::vector<std::string> FindUndescribed(const json& schema) {
  std::vector<std::string> undescribed;
  VisitObjects(schema, [&](const json& object) {
    for (const auto& field : object.at("properties").items()) {
      const json& value = field.value();
      const std::string reference = value.value("$ref", "");
      const json& definition = reference.empty() ? value : schema.at(json::json_pointer(reference.substr(1)));
      if (value.value("description", definition.value("description", "")).empty())
        undescribed.push_back(field.key());
    }
  });
  return undescribed;
}

TEST(RunJsonTest, TheSchemaDescribesEveryField) {
  json schema = Tests::ReadJsonSource("compare/run.schema.json");
  EXPECT_EQ(FindUndescribed(schema), std::vector<std::string>());
  // The control: a field without a description.
  schema["properties"]["extra"] = {{"$ref", "#/definitions/count"}};
  EXPECT_EQ(FindUndescribed(schema), std::vector<std::string>{"extra"});
}

} // namespace
} // namespace Shapes::Compare
