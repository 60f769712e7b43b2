// SPDX-License-Identifier: MIT
#include "Machine.h"
#include "Report.h"
#include "metrics/Overall.h"
#include "metrics/Totals.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <string_view>

namespace Shapes::Compare {
namespace {

using nlohmann::ordered_json;

ordered_json Number(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }

ordered_json Number(const std::optional<double>& x) { return x ? Number(*x) : ordered_json(nullptr); }

// Where nothing was measured there is no number: a zero would look like a good one.
ordered_json ToJson(const CSummary& s) {
  const auto figure = [&](double x) { return s.m_nCount == 0 ? ordered_json(nullptr) : Number(x); };
  return {{"count", s.m_nCount},
          {"median", figure(s.m_fMedian)},
          {"p95", figure(s.m_fP95)},
          {"max", figure(s.m_fMax)}};
}

ordered_json ToJson(const CInterval& i) { return ordered_json::array({Number(i.m_fLow), Number(i.m_fHigh)}); }

ordered_json Rate(std::size_t hits, std::size_t n) {
  const CInterval i = Wilson(hits, n);
  return {
      {"count", hits},
      {"of", n},
      {"rate", n == 0 ? ordered_json(nullptr) : Number(static_cast<double>(hits) / static_cast<double>(n))},
      {"low", i.m_fLow},
      {"high", i.m_fHigh}};
}

// "BallPairs" as "ball_pairs".
std::string GetKey(eEffect e) {
  std::string key;
  for (const char c : GetName(e)) {
    if (c >= 'A' && c <= 'Z' && !key.empty()) key += '_';
    key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return key;
}

ordered_json ToJson(CEffects effects) {
  ordered_json json = ordered_json::array();
  for (const eEffect e : g_stdEffects)
    if (effects.Has(e)) json.push_back(GetKey(e));
  return json;
}

ordered_json Settings(const CEngine& engine, const CScene& scene) {
  ordered_json settings = ordered_json::object();
  if (engine.m_pBackend == nullptr) return settings;
  const CWorldDesc desc = engine.MakeWorldDesc(scene);
  settings["time_step"] = desc.m_fTimeStep;
  settings["substeps"] = desc.m_nSubsteps;
  settings["forced"] = ToJson(desc.m_cEffects.m_cForced);
  settings["forbidden"] = ToJson(desc.m_cEffects.m_cForbidden);
  if (engine.m_pBackend == GetBackend(eBackend::Box2D)) {
    settings["profile"] = GetName(desc.m_cBox2D.m_eProfile);
    settings["length_unit"] = desc.m_cBox2D.m_fLengthUnit;
    settings["sagitta_tolerance"] = desc.m_cBox2D.m_fSagittaTolerance;
    settings["velocity_iterations"] = desc.m_cBox2D.m_nVelocityIterations;
    settings["position_iterations"] = desc.m_cBox2D.m_nPositionIterations;
  }
  return settings;
}

// The effects that a scene calls for, but Events and Continuous.
ordered_json Features(const CScene& scene) {
  bool moves = false, senses = false;
  for (const CSceneShape& shape : scene.m_stdShapes) {
    moves |= Moves(shape);
    senses |= GetBase(shape.m_cDesc).m_bIsSensor;
  }
  ordered_json features = ordered_json::array();
  if (!scene.m_cWorld.m_vGravity.isZero(0.0f)) features.push_back("gravity");
  if (moves) features.push_back("kinematics");
  if (scene.m_stdBalls.size() > 1) features.push_back("ball_pairs");
  if (senses) features.push_back("sensors");
  return features;
}

// Every engine runs what the scene calls for and its settings do not forbid.
ordered_json Features(const CEngine& engine, const CScene& scene) {
  ordered_json features = Features(scene);
  if (!engine.m_cEffects.m_cForbidden.Has(eEffect::Continuous)) features.push_back("continuous");
  return features;
}

ordered_json ToJson(const CBin& bin) {
  const CTotals& t = bin.m_cTotals;
  return {{"by", bin.m_sBy},
          {"label", bin.m_sLabel},
          {"contacts", t.m_nContacts},
          {"tunneled", Rate(t.GetTunneled(), t.m_nContacts)},
          {"setback_error", ToJson(t["setback_error"])},
          {"direction_error", ToJson(t["direction_error"])}};
}

ordered_json FigureToJson(const CFigure& figure, const CSceneReport& scene, const CEngineReport& report) {
  if (figure.m_pRate != nullptr) {
    const CHits rate = figure.m_pRate(scene, report);
    return Rate(rate.m_nHits, rate.m_nOf);
  }
  if (figure.m_pOfImpact != nullptr) return ToJson(report.m_cTotals[figure.m_sKey]);
  const auto value = figure.m_pOfRun(scene, report);
  return figure.m_bIsCount && value ? ordered_json(static_cast<std::size_t>(*value)) : Number(value);
}

// The name of an engine, or null.
ordered_json Name(const CRunReport& report, std::optional<std::size_t> e) {
  return e ? ordered_json(report.m_stdEngines[*e].m_sName) : ordered_json(nullptr);
}

ordered_json EngineToJson(const CRunReport& run, const CSceneReport& scene, std::size_t e) {
  const CEngine& engine = run.m_stdEngines[e];
  const CEngineReport& report = scene.m_stdEngines[e];
  const CTotals& t = report.m_cTotals;
  const CCost& cost = report.m_cCost;
  const std::size_t n = t.m_nContacts;
  ordered_json json{{"name", engine.m_sName},
                    {"settings", Settings(engine, scene.m_cScene)},
                    {"features", Features(engine, scene.m_cScene)},
                    {"grade", GetName(GradeOf(t))},
                    {"contacts", n},
                    {"correct", n - t.GetTunneled() - t.m_nLate}};
  for (const CFigure& figure : GetFigures())
    json[figure.m_sKey] = FigureToJson(figure, scene, report);
  json["setback_error_histogram"] = report.m_cHistogram.m_stdSetbackError;
  json["penetration_histogram"] = report.m_cHistogram.m_stdPenetration;
  json["bins"] = ordered_json::array();
  for (const CBin& bin : report.m_stdBins)
    json["bins"].push_back(ToJson(bin));
  json["bounces"] =
      FindKept(scene.m_cScene).IsAnything() ? ordered_json(report.m_cLongRun.m_nBounces) : nullptr;
  json["ns_per_ball_step_interval"] = ToJson(cost.m_cNsPerBallStep.m_cInterval);
  json["simulated_seconds"] = Number(cost.m_fSimulatedSeconds);
  return json;
}

// The table of figures, by which the page draws them.
ordered_json FiguresToJson() {
  ordered_json json = ordered_json::array();
  for (const CFigure& figure : GetFigures())
    json.push_back({{"key", figure.m_sKey},
                    {"kind", GetKind(figure)},
                    {"group", figure.m_sGroup},
                    {"label", figure.m_sLabel},
                    {"unit", figure.m_sUnit},
                    {"signed", figure.m_bIsSigned}});
  return json;
}

ordered_json ToJson(const CExcluded& aside) {
  return {{"resting", aside.m_nResting},
          {"ambiguous", aside.m_nAmbiguous},
          {"simultaneous", aside.m_nSimultaneous},
          {"undecided", aside.m_nUndecided},
          {"first_undecided",
           aside.m_nUndecided == 0 ? ordered_json(nullptr) : ordered_json(aside.m_sUndecided)}};
}

ordered_json ToJson(const CHeatMap& map) {
  if (map.m_stdCells.empty()) return nullptr;
  ordered_json json{{"speeds", map.m_stdSpeeds},
                    {"sizes", map.m_stdSizes},
                    {"travel", Number(map.m_fTravel)},
                    {"cells", ordered_json::array()}};
  for (const CHeatCell& cell : map.m_stdCells)
    json["cells"].push_back({{"contacts", cell.m_nContacts}, {"tunneled", cell.m_stdTunneled}});
  return json;
}

ordered_json ToJson(const CRecommendation& recommendation, const std::vector<CSetting>& settings) {
  ordered_json choices = ordered_json::array();
  const auto cost = [&](std::size_t i) { return settings[i].m_cNsPerBallSecond.m_fMedian; };
  for (const std::size_t i : recommendation.m_stdChoices)
    choices.push_back({{"engine", settings[i].m_cEngine.m_sName},
                       {"label", settings[i].m_cEngine.GetLabel()},
                       {"ns_per_ball_second", Number(cost(i))},
                       {"ns_ratio", Number(cost(i) / cost(recommendation.m_stdChoices.front()))}});
  ordered_json closest;
  if (recommendation.m_nClosest) {
    const CSetting& setting = settings[*recommendation.m_nClosest];
    closest = {{"engine", setting.m_cEngine.m_sName},
               {"label", setting.m_cEngine.GetLabel()},
               {"direction_error_p95", Number(setting.m_fDirectionErrorP95)},
               {"tunneled", Rate(setting.GetAllTunneled(), setting.GetAllContacts())}};
  }
  return {{"demand", recommendation.m_sDemand},
          {"choices", std::move(choices)},
          {"without", recommendation.m_stdWithout},
          {"closest", std::move(closest)}};
}

ordered_json SceneToJson(const CRunReport& report, const CSceneReport& scene) {
  const CScene& s = scene.m_cScene;
  const Vector2& g = s.m_cWorld.m_vGravity;
  ordered_json json{
      {"name", s.m_sName},
      {"description", s.m_sDescription},
      {"length_unit", s.m_cWorld.m_cBox2D.m_fLengthUnit},
      {"time_step", s.m_cWorld.m_fTimeStep},
      {"gravity", ordered_json::array({g.x(), g.y()})},
      {"duration", s.m_fDuration},
      {"features", Features(s)},
      {"shapes", s.m_stdShapes.size()},
      {"balls", s.m_stdBalls.size()},
      {"trials", scene.m_cImpactTrials.m_nTrials},
      {"quiet_steps", scene.m_cImpactTrials.m_nQuietSteps},
      {"set_aside", ToJson(scene.m_cImpactTrials.m_cExcluded)},
      {"apart", FindOther(report.m_stdEngines) ? ToJson(scene.m_cDifference) : ordered_json(nullptr)},
      {"take", Name(report, FindTake(report, scene))},
      {"verdict", MakeVerdict(report, scene)},
      {"remarks", MakeRemarks(report, scene)},
      {"answers", ordered_json::array()},
      {"engines", ordered_json::array()},
      {"heat_map", ToJson(scene.m_cHeatMap)},
      {"sensor_touches", scene.m_cEffects.m_nTouches},
      {"not_counted", scene.m_cEffects.m_sNotCounted.empty() ? ordered_json(nullptr)
                                                             : ordered_json(scene.m_cEffects.m_sNotCounted)}};
  for (const CRecommendation& recommendation : scene.m_cWork.m_stdRecommendations)
    json["answers"].push_back(ToJson(recommendation, scene.m_cWork.m_stdSettings));
  for (std::size_t e = 0; e < scene.m_stdEngines.size(); ++e)
    json["engines"].push_back(EngineToJson(report, scene, e));
  return json;
}

ordered_json ToJson(const CSetting& setting, const CScene& scene) {
  ordered_json proof;
  if (setting.m_nConfirmationContacts > 0)
    proof = {{"contacts", setting.m_nConfirmationContacts}, {"tunneled", setting.m_nConfirmationTunneled}};
  return {{"scene", scene.m_sName},
          {"engine", setting.m_cEngine.m_sName},
          {"label", setting.m_cEngine.GetLabel()},
          {"settings", Settings(setting.m_cEngine, scene)},
          {"ns_per_ball_second", Number(setting.m_cNsPerBallSecond.m_fMedian)},
          {"ns_per_ball_second_interval", ToJson(setting.m_cNsPerBallSecond.m_cInterval)},
          {"direction_error_p95", Number(setting.m_fDirectionErrorP95)},
          {"contacts", setting.m_nContacts},
          {"miss_rate", Rate(setting.m_nMissed, setting.m_nContacts)},
          {"tunneled_rate", Rate(setting.m_nTunneled, setting.m_nContacts)},
          {"proof", std::move(proof)},
          {"front_by_error", setting.m_bFrontByError},
          {"front_by_misses", setting.m_bFrontByMisses}};
}

ordered_json ToJson(const CEffectWorld& world, std::size_t touches) {
  const CTotals& t = world.m_cTotals;
  return {{"ns_per_ball_step", Number(world.m_cCost.m_cNsPerBallStep.m_fMedian)},
          {"ns_per_ball_step_interval", ToJson(world.m_cCost.m_cNsPerBallStep.m_cInterval)},
          {"instructions_per_ball_step", Number(world.m_fInstructions)},
          {"contacts", t.m_nContacts},
          {"tunneled", Rate(t.GetTunneled(), t.m_nContacts)},
          {"direction_error", ToJson(t["direction_error"])},
          {"speed_error", ToJson(t["speed_error"])},
          {"flight_error", ToJson(world.m_cFlightError)},
          {"touches_missed", Rate(world.m_nTouchesMissed, touches)}};
}

ordered_json ToJson(const CEffectCost& cost, const CSceneReport& scene) {
  const CMedian ratio = cost.GetRatio();
  const std::size_t touches = scene.m_cEffects.m_nTouches;
  return {{"scene", scene.m_cScene.m_sName},
          {"engine", cost.m_sEngine},
          {"effect", GetKey(cost.m_eEffect)},
          {"runs", cost.m_fRuns},
          {"why", cost.m_sWhy},
          {"ns_ratio", Number(ratio.m_fMedian)},
          {"ns_ratio_interval", ToJson(ratio.m_cInterval)},
          {"with", ToJson(cost.m_cWith, touches)},
          {"without", ToJson(cost.m_cWithout, touches)}};
}

// The table of engines, as far as they ran.
ordered_json EnginesToJson(const CRunReport& report) {
  ordered_json json = ordered_json::array();
  for (const CEngine& engine : report.m_stdEngines) {
    const CEngineRow& row = GetEngineRow(engine.m_sName);
    json.push_back(
        {{"name", row.m_sName}, {"short", row.m_sShort}, {"meaning", row.m_sMeaning}, {"mark", row.m_sMark}});
  }
  return json;
}

ordered_json OverallToJson(const CRunReport& report) {
  const COverall overall = MakeOverall(report);
  ordered_json json{{"impacts", overall.m_nImpacts},
                    {"scenes", overall.m_nScenes},
                    {"take", Name(report, overall.m_nTake)},
                    {"result", MakeResult(report, overall)},
                    {"engines", ordered_json::array()}};
  for (std::size_t e = 0; e < overall.m_stdEngines.size(); ++e) {
    const CEngineOverall& engine = overall.m_stdEngines[e];
    const bool isCompared = engine.m_nCompared > 0;
    const auto angle = [&](const CInterval& i) { return isCompared ? ToJson(i) : ordered_json(nullptr); };
    json["engines"].push_back(
        {{"name", report.m_stdEngines[e].m_sName},
         {"grade", GetName(overall.GetGrade(e))},
         {"tunneled", Rate(engine.m_nLost, overall.m_nImpacts)},
         {"compared", engine.m_nCompared},
         {"direction_error_p95", isCompared ? Number(engine.m_cDirection.m_fValue) : ordered_json(nullptr)},
         {"direction_error_p95_interval", angle(engine.m_cDirection.m_cInterval)},
         {"direction_error_p95_scenes", angle(engine.m_cDirectionScenes)},
         {"ns_per_ball_step", Number(engine.m_cNs.m_fMedian)},
         {"ns_per_ball_step_interval", ToJson(engine.m_cNs.m_cInterval)},
         {"ns_per_ball_step_scenes", ToJson(engine.m_cNsScenes)},
         {"ns_box2d_ratio", engine.m_cTimes ? Number(engine.m_cTimes->m_fMedian) : ordered_json(nullptr)},
         {"ns_box2d_ratio_interval",
          engine.m_cTimes ? ToJson(engine.m_cTimes->m_cInterval) : ordered_json(nullptr)},
         {"ns_box2d_ratio_scenes", engine.m_cTimes ? ToJson(engine.m_cTimesScenes) : ordered_json(nullptr)},
         {"front", engine.m_bFront}});
  }
  return json;
}

ordered_json HistogramEdges() {
  ordered_json edges = ordered_json::array();
  for (std::size_t i = 0; i <= g_nHistogramBins; ++i)
    edges.push_back(GetHistogramEdge(i));
  return edges;
}

ordered_json RunToJson(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  ordered_json json{{"version", g_nRunVersion},
                    {"command", report.m_sCommand},
                    {"seed", report.m_nSeed},
                    {"contacts_per_scene", report.m_nContacts},
                    {"interrupted", report.m_bInterrupted},
                    {"machine",
                     {{"shapes", machine.m_sShapes},
                      {"box2d", machine.m_sBox2D},
                      {"compiler", machine.m_sCompiler},
                      {"cpu", machine.m_sCpu},
                      {"cores", machine.m_nCores}}},
                    {"engines", EnginesToJson(report)},
                    {"overall", OverallToJson(report)},
                    {"figures", FiguresToJson()},
                    {"histogram_edges", HistogramEdges()},
                    {"scenes", ordered_json::array()},
                    {"work_precision", ordered_json::array()},
                    {"effects", ordered_json::array()}};
  for (const CSceneReport& scene : report.m_stdScenes) {
    json["scenes"].push_back(SceneToJson(report, scene));
    for (const CSetting& setting : scene.m_cWork.m_stdSettings)
      json["work_precision"].push_back(ToJson(setting, scene.m_cScene));
    for (const CEffectCost& cost : scene.m_cEffects.m_stdCosts)
      json["effects"].push_back(ToJson(cost, scene));
  }
  return json;
}

// Bytes of a command line or a scene's name that are no UTF-8 are replaced, not refused at the very end.
std::string Dump(const ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

// More digits than are shown anywhere.
void RoundFigures(ordered_json& json) {
  if (json.is_number_float())
    json = std::stod(fmt::format("{:.6g}", json.get<double>()));
  else if (json.is_structured())
    for (ordered_json& part : json)
      RoundFigures(part);
}

} // namespace

std::string MakeJson(const CRunReport& report) { return Dump(RunToJson(report), 1); }

std::string MakePageJson(const CRunReport& report) {
  ordered_json json = RunToJson(report);
  RoundFigures(json);
  json["seed"] = std::to_string(report.m_nSeed); // numbers of JavaScript are whole up to 2^53 only
  return Dump(json, -1);
}

} // namespace Shapes::Compare
