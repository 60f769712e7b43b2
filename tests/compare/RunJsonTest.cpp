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
    const char* pForm = figure.m_pRate != nullptr       ? "rate"
                        : figure.m_pOfImpact != nullptr ? "summary"
                        : figure.m_bIsCount             ? "count"
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

TEST(RunJsonTest, ARealRunMeasuresEverythingAndFitsTheSchema) {
  constexpr std::size_t contacts = 40;
  std::size_t checks = 0;
  CProgress progress(2, false);
  const CRunReport report = RunScenes({LoadBundled("bowl"), LoadBundled("pinball")}, GetEngines(),
                                      g_cQuickSizes.ForContacts(contacts), 3, progress, [&] { ++checks; });
  EXPECT_FALSE(report.m_bInterrupted);
  EXPECT_GT(checks, 100u);
  ASSERT_EQ(report.m_stdScenes.size(), 2u);
  for (const CSceneReport& scene : report.m_stdScenes) {
    SCOPED_TRACE(scene.m_cScene.m_sName);
    EXPECT_EQ(scene.m_cImpactTrials.m_stdContacts.size(), contacts);
    EXPECT_GT(scene.m_cDifference.m_nCount, 0u);
    EXPECT_EQ(scene.m_cWork.m_stdSettings.size(), GetParameterSweep().size() + 1);
    EXPECT_FALSE(scene.m_cWork.m_stdRecommendations.empty());
    EXPECT_EQ(scene.m_cHeatMap.m_stdCells.empty(), scene.m_cScene.m_stdBalls.size() != 1);
    EXPECT_EQ(scene.m_stdClips.size(), 1 + GetEngineRows().size());
    EXPECT_EQ(scene.m_cEffects.m_sNotCounted, "only a full run does");
    ASSERT_EQ(scene.m_cEffects.m_stdCosts.size(), 6 * GetBackends().size());
    for (std::size_t i = 0; i < scene.m_cEffects.m_stdCosts.size(); ++i) {
      const CEffectCost& cost = scene.m_cEffects.m_stdCosts[i];
      EXPECT_EQ(cost.m_sEngine, GetBackends()[i / 6].GetName());
      EXPECT_EQ(cost.m_eEffect, g_stdEffects[i % 6]);
      EXPECT_FALSE(cost.m_sWhy.empty());
      for (const CEffectWorld* pWorld : {&cost.m_cWith, &cost.m_cWithout}) {
        EXPECT_GT(pWorld->m_cCost.m_cNsPerBallStep.m_fMedian, 0.0);
        EXPECT_FALSE(pWorld->m_fInstructions.has_value());
      }
    }
    ASSERT_EQ(scene.m_stdEngines.size(), GetEngineRows().size());
    for (const CEngineReport& engine : scene.m_stdEngines) {
      EXPECT_EQ(engine.m_cTotals.m_nContacts, contacts);
      EXPECT_FALSE(engine.m_stdBins.empty());
      EXPECT_EQ(engine.m_cHistogram.m_stdSetbackError.size(), g_nHistogramBins);
      EXPECT_GT(engine.m_cCost.m_cNsPerBallStep.m_fMedian, 0.0);
      EXPECT_EQ(engine.m_cLongRun.m_nBounces > 0, scene.m_cScene.m_sName == "bowl"); // which keeps something
    }
  }
  for (const CFigure& figure : GetImpactFigures()) {
    double most = 0.0;
    for (const CSceneReport& scene : report.m_stdScenes)
      for (const CEngineReport& engine : scene.m_stdEngines)
        most = std::max(most, std::abs(engine.m_cTotals[figure.m_sKey].m_fMax));
    EXPECT_GT(most, 0.0) << figure.m_sKey << ": nothing calculates it";
  }
  const json doc = json::parse(MakeJson(report));
  EXPECT_EQ(FindFault(doc), "");
  EXPECT_EQ(doc.at("/scenes/1/engines/2/settings/velocity_iterations"_json_pointer), 8);
}

TEST(RunJsonTest, TheSampleFitsTheSchema) {
  CRunReport report = MakeSampleReport(); // as it is: AChangedDocumentIsRefused
  report.m_stdScenes.push_back(MakeUndecidedScene());
  report.m_bInterrupted = true;
  report.m_nSeed = std::numeric_limits<std::uint64_t>::max();
  report.m_sCommand = "shapes-compare run --out \xff";                                  // no text
  report.m_stdScenes[0].m_cHeatMap.m_fTravel = std::numeric_limits<double>::infinity(); // of radius 0
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

TEST(RunJsonTest, FiguresAreWhereTheyBelongAndNullWhereNoneWasMeasured) {
  CRunReport report = MakeSampleReport();
  report.m_stdScenes.push_back(MakeUndecidedScene());
  report.m_stdScenes[0].m_cWork.m_stdSettings[0].m_fDirectionErrorP95 = {};
  CEngineReport& wild = report.m_stdScenes[0].m_stdEngines[3];
  wild.m_cLongRun.m_fEnergyDrift = std::numeric_limits<double>::quiet_NaN();
  wild.m_cTotals["penetration"].m_fMax = std::numeric_limits<double>::infinity();
  const json doc = json::parse(MakeJson(report));
  EXPECT_EQ(FindFault(doc), "");
  const auto at = [&](const std::string& path) { return doc.at(json::json_pointer(path)); };
  const std::pair<const char*, const char*> expected[] = {
      {"", R"({"version": 5, "seed": 5, "contacts_per_scene": 1000})"},
      {"/scenes/0", R"({"features": ["kinematics"], "shapes": 3, "take": "box2d-tuned", "not_counted": null,
          "set_aside": {"resting": 1, "ambiguous": 2, "simultaneous": 3, "undecided": 0,
                        "first_undecided": null}})"},
      {"/scenes/0/apart", R"({"p95": 0.5})"},
      {"/scenes/0/engines/0", R"({"contacts": 1000, "correct": 983, "features": ["kinematics", "continuous"],
          "grade": "rough", "energy_drift": -0.03, "free_path_error": null})"},
      {"/scenes/0/engines/0/ghost", R"({"rate": 0.0025})"},
      {"/scenes/0/engines/0/settings", R"({"forced": [], "forbidden": []})"},
      {"/scenes/0/engines/1", R"({"features": ["kinematics"], "ns_per_contact": 5000.0})"},
      {"/scenes/0/engines/1/missed", R"({"count": 101})"},
      {"/scenes/0/engines/1/wrong_side", R"({"count": 102})"},
      {"/scenes/0/engines/1/tunneled", R"({"count": 203, "of": 1000, "rate": 0.203})"},
      {"/scenes/0/engines/1/lasting_lost", R"({"count": 3, "of": 200, "rate": 0.015})"},
      {"/scenes/0/engines/1/settings", R"({"forbidden": ["continuous"]})"},
      {"/scenes/0/engines/2/settings", R"({"profile": "shipped"})"},
      {"/scenes/0/engines/3", R"({"features": ["kinematics", "continuous"], "grade": "good",
          "energy_drift": null})"},
      {"/scenes/0/engines/3/penetration", R"({"max": null})"},
      {"/scenes/0/engines/3/settings", R"({"forced": [], "profile": "tuned"})"},
      {"/scenes/0/answers/0", R"({"without": ["native-approximate"]})"},
      {"/scenes/0/answers/0/choices/0", R"({"engine": "native", "ns_ratio": 1.0})"},
      {"/scenes/0/answers/0/choices/1", R"({"engine": "box2d"})"},
      {"/scenes/0/answers/1/closest", R"({"direction_error_p95": 0.002})"},
      {"/scenes/0/heat_map/cells/1", R"({"tunneled": [0, 1200, 0, 86]})"},
      {"/scenes/1", R"({"take": null})"},
      {"/scenes/1/set_aside", R"({"undecided": 40})"},
      {"/scenes/1/engines/0", R"({"ns_per_contact": null, "energy_drift": null,
          "tunneled": {"count": 0, "of": 0, "rate": null, "low": 0.0, "high": 1.0},
          "setback_error": {"count": 0, "median": null, "p95": null, "max": null}})"},
      {"/engines/1", R"({"name": "native-approximate"})"},
      {"/overall", R"({"impacts": 1000, "scenes": 1, "take": "box2d-tuned"})"},
      {"/overall/engines/1", R"({"direction_error_p95": 2.0})"},
      {"/overall/engines/1/tunneled", R"({"count": 203})"},
      {"/overall/engines/2", R"({"direction_error_p95": null})"},
      {"/work_precision/0", R"({"direction_error_p95": null})"},
      {"/work_precision/0/tunneled_rate", R"({"rate": 0.2})"},
      {"/work_precision/12/settings", R"({"profile": "tuned"})"},
      {"/work_precision/16", R"({"engine": "exact", "settings": {}})"},
      {"/work_precision/17", R"({"scene": "hopeless"})"},
      {"/effects/1", R"({"scene": "spinner", "engine": "native", "effect": "kinematics", "runs": 0.35,
          "why": "it moves 2 radii a substep, </script><b>1 < 2</b>"})"},
      {"/effects/1/with", R"({"instructions_per_ball_step": 5500})"},
      {"/effects/1/without", R"({"instructions_per_ball_step": 1000})"},
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
  EXPECT_EQ(at("/scenes/1/set_aside/first_undecided"), "trial 0, step 2: ball 0 is jammed at (1, 2)");
  EXPECT_EQ(at("/histogram_edges/0"), 1e-6);
  EXPECT_EQ(at("/histogram_edges/24"), 1.0);
  EXPECT_EQ(at("/scenes/0/engines/0/setback_error_histogram/31"), 28);
  EXPECT_NEAR(at("/scenes/0/engines/1/tunneled/low").get<double>(), 0.179, 5e-4);
  EXPECT_NEAR(at("/overall/engines/0/ns_box2d_ratio").get<double>(), 500.0 / 70.0, 0.2);
  EXPECT_NEAR(at("/scenes/0/answers/0/choices/1/ns_ratio").get<double>(), 15.0, 1e-9);
  EXPECT_NEAR(at("/effects/1/ns_ratio").get<double>(), 5.5, 1e-9);
  EXPECT_FALSE(at("/scenes/0/engines/0/settings").contains("profile")); // native has none
  EXPECT_EQ(at("/figures").size(), GetFigures().size());
  for (const auto& figure : at("/figures"))
    EXPECT_TRUE(at("/scenes/0/engines/0").contains(figure.at("key").get<std::string>())) << figure;
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
  Tests::VisitValues(good, [&](const json& value, const json::json_pointer& path) {
    if (!value.is_object()) return;
    std::string kind;
    for (const auto& field : value.items())
      kind += field.key() + (field.value().is_array() ? "[] " : " ");
    if (!seen.insert(kind).second) return;
    json bad = good;
    bad[path]["surplus"] = 1;
    expectRefused(bad, (path / "surplus").to_string());
    for (const auto& field : value.items()) {
      const json::json_pointer here = path / field.key();
      bad = good;
      bad[path].erase(field.key());
      if (field.key() != "profile") expectRefused(bad, "without " + here.to_string()); // of Box2D only
      bad = good;
      bad[here] = field.value().is_boolean() ? json(1) : json(true);
      expectRefused(bad, "of another type: " + here.to_string());
    }
  });
  EXPECT_GT(changes.size(), 200u);

  for (const auto& [pPath, value] :
       std::initializer_list<std::pair<const char*, json>>{{"/scenes/0/engines/0/missed/rate", 1.5},
                                                           {"/scenes/0/engines/0/contacts", -1},
                                                           {"/scenes/0/engines/0/name", "a jolt"},
                                                           {"/version", 1}}) {
    json bad = good;
    bad[json::json_pointer(pPath)] = value;
    expectRefused(bad, pPath);
  }

  const std::vector<std::string> faults = Tests::FindSchemaFaults(SchemaJson(), docs);
  for (std::size_t i = 0; i < docs.size(); ++i)
    EXPECT_NE(faults[i], "") << changes[i];
}

// The names of fields that have no description, neither of their own nor of the definition that they refer
// to.
std::vector<std::string> FindUndescribed(const json& schema) {
  std::vector<std::string> undescribed;
  Tests::VisitValues(schema, [&](const json& object, const json::json_pointer&) {
    if (!object.is_object() || !object.contains("properties")) return;
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
