// SPDX-License-Identifier: MIT
#include "Report.h"

#include <fmt/format.h>

#include <iterator>

namespace Shapes::Compare {
namespace {

const char* Name(eOutcome e) {
  switch (e) {
  case eOutcome::Correct: return "correct";
  case eOutcome::Late: return "late";
  case eOutcome::WrongSide: return "wrong side";
  case eOutcome::Missed: break;
  }
  return "missed";
}

} // namespace

std::string MakeCsv(const CRunReport& report) {
  std::string text =
      "scene,trial,step,ball,pair,time_in_step,travel_radii,approach_speed,incidence_rad,apart_radii";
  for (const CEngine& engine : report.m_stdEngines)
    text += fmt::format(",{0}_outcome,{0}_setback_radii,{0}_setback_error_radii", engine.m_sName);
  text += '\n';
  // What was not measured is an empty field. Seven digits: the engines compute in float.
  for (const CSceneReport& scene : report.m_stdScenes)
    for (const CContact& c : scene.m_cRestart.m_stdContacts) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{:.7g},{:.7g},{:.7g},{:.7g},",
                     scene.m_cScene.m_sName, c.m_nTrial, c.m_nStep, c.m_nBall, c.m_sPair, c.m_fTime,
                     c.m_fTravel, c.m_fApproach, c.m_fIncidence);
      if (c.m_bHasDifference) fmt::format_to(std::back_inserter(text), "{:.7g}", c.m_fDifference);
      for (const CEngineContact& e : c.m_stdEngines) {
        fmt::format_to(std::back_inserter(text), ",{},", Name(e.m_eOutcome));
        if (e.m_bDetected)
          fmt::format_to(std::back_inserter(text), "{:.7g},{:.7g}", e.m_fSetback, e.m_fSetbackError);
        else
          text += ',';
      }
      text += '\n';
    }
  return text;
}

} // namespace Shapes::Compare
