// SPDX-License-Identifier: MIT
#include "Report.h"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

namespace Shapes::Compare {
namespace {

// A field as RFC 4180 wants it.
std::string Quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == field.npos) return field;
  std::string quoted = "\"";
  for (const char c : field)
    quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

// Each field with the comma before it; what was not measured is empty. Five digits: more than any figure is
// worth, and no two impacts are alike in them.
class CRow {
public:
  explicit CRow(std::string& text) : m_sText(text) {}
  void Add(bool isMeasured, float x) {
    m_sText += ',';
    if (isMeasured) fmt::format_to(std::back_inserter(m_sText), "{:.5g}", x);
  }

private:
  std::string& m_sText;
};

constexpr const char* g_stdEngineFields[] = {"outcome",
                                             "setback_radii",
                                             "setback_error_radii",
                                             "setback_error_normal_radii",
                                             "time_error_steps",
                                             "poi_error_radii",
                                             "normal_error_rad",
                                             "direction_error_rad",
                                             "speed_error_relative",
                                             "energy_error_relative",
                                             "position_error_radii",
                                             "penetration_radii"};

void Append(const CEngineContact& e, std::string& text) {
  text += ',';
  text += GetName(e.m_eOutcome);
  CRow row(text);
  for (const float x : {e.m_fSetback, e.m_fSetbackError, e.m_fSetbackErrorNormal, e.m_fTimeError})
    row.Add(e.m_bDetected, x);
  for (const float x : {e.m_fPOIError, e.m_fNormalError})
    row.Add(e.HasTurnedBack(), x);
  for (const float x : {e.m_fDirectionError, e.m_fSpeedError, e.m_fEnergyError, e.m_fPositionError})
    row.Add(e.m_bCompared, x);
  row.Add(true, e.m_fPenetration);
}

} // namespace

std::string MakeCsv(const CRunReport& report) {
  std::string text = "scene,trial,step,ball,pair,time_in_step,travel_radii,approach_speed_units_per_s,"
                     "incidence_rad,elasticity,apart_radii";
  for (const CEngine& engine : report.m_stdEngines)
    for (const char* pField : g_stdEngineFields)
      text += fmt::format(",{}_{}", engine.m_sName, pField);
  text += '\n';
  for (const CSceneReport& scene : report.m_stdScenes) {
    const std::string name = Quoted(scene.m_cScene.m_sName);
    for (const CContact& c : scene.m_cRestart.m_stdContacts) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", name, c.m_nTrial, c.m_nStep, c.m_nBall,
                     GetName(c.m_ePair));
      CRow row(text);
      for (const float x : {c.m_fTime, c.m_fTravel, c.m_fApproach, c.m_fIncidence, c.m_fElasticity})
        row.Add(true, x);
      row.Add(c.m_bHasDifference, c.m_fDifference);
      for (const CEngineContact& e : c.m_stdEngines)
        Append(e, text);
      text += '\n';
    }
  }
  return text;
}

} // namespace Shapes::Compare
