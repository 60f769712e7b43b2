// SPDX-License-Identifier: MIT
#include "Machine.h"
#include "Report.h"

#include <nlohmann/json.hpp>

namespace Shapes::Compare {
namespace {

using nlohmann::ordered_json;

ordered_json ToJson(const CSummary& s) {
  return {{"count", s.m_nCount}, {"median", s.m_fMedian}, {"p95", s.m_fP95}, {"max", s.m_fMax}};
}

ordered_json ToJson(const CInterval& i) { return ordered_json::array({i.m_fLow, i.m_fHigh}); }

ordered_json Settings(const CEngine& engine, const CScene& scene) {
  const CWorldDesc desc = engine.MakeWorldDesc(scene);
  ordered_json settings{{"time_step", desc.m_fTimeStep}, {"substeps", desc.m_nSubsteps}};
  if (engine.m_sName == "box2d") {
    settings["length_unit"] = desc.m_fLengthUnit;
    settings["sagitta_tolerance"] = desc.m_fSagittaTolerance;
    settings["velocity_iterations"] = desc.m_nVelocityIterations;
    settings["position_iterations"] = desc.m_nPositionIterations;
  }
  return settings;
}

ordered_json EngineToJson(const CEngine& engine, const CSceneReport& scene, std::size_t e) {
  const CEngineTotals& t = scene.m_cRestart.m_stdEngines[e];
  const CCost& cost = scene.m_stdCosts[e];
  const std::size_t n = scene.m_cRestart.m_stdContacts.size();
  return {{"name", engine.m_sName},
          {"settings", Settings(engine, scene.m_cScene)},
          {"contacts", n},
          {"missed", t.m_nMissed},
          {"missed_rate_interval", ToJson(Wilson(t.m_nMissed, n))},
          {"tunneled", t.GetTunneled()},
          {"tunneled_rate_interval", ToJson(Wilson(t.GetTunneled(), n))},
          {"late", t.m_nLate},
          {"setback", ToJson(t.m_cSetback)},
          {"setback_error", ToJson(t.m_cSetbackError)},
          {"ns_per_ball_step", cost.m_cNsPerBallStep.m_fMedian},
          {"ns_per_ball_step_interval", ToJson(cost.m_cNsPerBallStep.m_cInterval)},
          {"simulated_seconds", cost.m_fSimulatedSeconds},
          {"escaped", cost.m_nEscaped},
          {"not_finite", cost.m_nNotFinite}};
}

} // namespace

std::string MakeJson(const CRunReport& report) {
  const CMachine machine = DescribeMachine();
  ordered_json json{{"version", 1},
                    {"command", report.m_sCommand},
                    {"seed", report.m_nSeed},
                    {"contacts_per_scene", report.m_nContacts},
                    {"machine",
                     {{"shapes", machine.m_sShapes},
                      {"box2d", machine.m_sBox2D},
                      {"compiler", machine.m_sCompiler},
                      {"cpu", machine.m_sCpu},
                      {"cores", machine.m_nCores}}}};
  json["scenes"] = ordered_json::array();
  for (const CSceneReport& scene : report.m_stdScenes) {
    ordered_json s{{"name", scene.m_cScene.m_sName},
                   {"description", scene.m_cScene.m_sDescription},
                   {"trials", scene.m_cRestart.m_nTrials},
                   {"resting", scene.m_cRestart.m_nResting},
                   {"ambiguous", scene.m_cRestart.m_nAmbiguous},
                   {"setback_difference", ToJson(scene.m_cRestart.m_cDifference)}};
    s["engines"] = ordered_json::array();
    for (std::size_t e = 0; e < report.m_stdEngines.size(); ++e)
      s["engines"].push_back(EngineToJson(report.m_stdEngines[e], scene, e));
    json["scenes"].push_back(std::move(s));
  }
  return json.dump(2) + "\n";
}

} // namespace Shapes::Compare
