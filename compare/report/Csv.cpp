// SPDX-License-Identifier: MIT
#include "Report.h"

#include <fmt/format.h>

#include <iterator>

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
void Add(bool isMeasured, float x, std::string& text) {
  text += ',';
  if (isMeasured) fmt::format_to(std::back_inserter(text), "{:.5g}", x);
}

void Append(const CEngineContact& e, std::string& text) {
  text += ',';
  text += GetName(e.m_eOutcome);
  for (const CFigure& figure : GetImpactFigures())
    Add(figure.m_pIsMeasured(e), e.*figure.m_pOfImpact, text);
}

// "units/s" as "units_per_s".
std::string UnitName(std::string unit) {
  if (const std::size_t slash = unit.find('/'); slash != unit.npos) unit.replace(slash, 1, "_per_");
  return unit;
}

} // namespace

std::string MakeCsv(const CRunReport& report) {
  std::string text = "scene,trial,step,ball,pair,time_in_step,travel_radii,approach_speed_units_per_s,"
                     "incidence_rad,elasticity,apart_radii";
  for (const CEngine& engine : report.m_stdEngines) {
    text += fmt::format(",{}_outcome", engine.m_sName);
    for (const CFigure& figure : GetImpactFigures())
      text += fmt::format(",{}_{}_{}", engine.m_sName, figure.m_sKey, UnitName(figure.m_sUnit));
  }
  text += '\n';
  for (const CSceneReport& scene : report.m_stdScenes) {
    const std::string name = Quoted(scene.m_cScene.m_sName);
    for (const CContact& c : scene.m_cImpactTrials.m_stdContacts) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}", name, c.m_nTrial, c.m_nStep, c.m_nBall,
                     GetName(c.m_ePair));
      for (const float x : {c.m_fTime, c.m_fTravel, c.m_fApproach, c.m_fIncidence, c.m_fElasticity})
        Add(true, x, text);
      Add(c.m_bHasDifference, c.m_fDifference, text);
      for (const CEngineContact& e : c.m_stdEngines)
        Append(e, text);
      text += '\n';
    }
  }
  return text;
}

} // namespace Shapes::Compare
