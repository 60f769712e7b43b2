// SPDX-License-Identifier: MIT
#include "HardCase.h"

#include <cmath>
#include <stdexcept>

namespace Shapes::HardCases {

const char* GetName(eColumn column) {
  switch (column) {
  case eColumn::Native: return "native";
  case eColumn::Continuous: return "continuous";
  case eColumn::Box2D: return "box2d";
  case eColumn::Tuned: return "tuned";
  case eColumn::Reference: return "reference";
  case eColumn::Size: break;
  }
  throw std::logic_error("no such column");
}

CExpect Right() { return {CExpect::eKind::Right, 0.0, 0.0, "right"}; }
CExpect RightWithin(double bound, const std::string& derivation) {
  return {CExpect::eKind::Right, 0.0, bound, "right: " + derivation};
}
CExpect Deviates(double least, double most, const std::string& figureAndReason) {
  return {CExpect::eKind::Deviates, least, most, figureAndReason};
}
CExpect Refused(const std::string& words) { return {CExpect::eKind::Refused, 0.0, 0.0, words}; }
CExpect NotAsked(const std::string& why) { return {CExpect::eKind::NotAsked, 0.0, 0.0, why}; }

CWorldDesc Desc(eColumn column, const Vector2& gravity, float dt) {
  CWorldDesc desc;
  desc.m_vGravity = gravity;
  desc.m_fTimeStep = dt;
  desc.m_cEffects = column == eColumn::Native ? g_cApproximate : g_cContinuous;
  if (column == eColumn::Tuned) desc.m_cBox2D.m_eProfile = eProfile::Tuned;
  return desc;
}

std::unique_ptr<CWorld> MakeWorld(eColumn column, const CWorldDesc& desc) {
  const bool native = column == eColumn::Native || column == eColumn::Continuous;
  if (column == eColumn::Reference) throw std::logic_error("the reference is no world");
  return GetBackend(native ? eBackend::Native : eBackend::Box2D)->MakeWorld(desc);
}

double Distance(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double d = (a - b).norm();
  return std::isfinite(d) ? d : g_fNever;
}

std::vector<CHardCase> AllCases() {
  const std::pair<const char*, std::vector<CHardCase>> groups[] = {
      {"Inputs that are no numbers, or of no extent", ValidationCases()},
      {"Centres that coincide", CoincidentCases()},
      {"Lines in float", LineCases()},
      {"Arcs", ArcCases()},
      {"Grazes and curved ways", GrazingCases()},
      {"Deep and fast", FastCases()},
      {"Scale", ScaleCases()},
      {"Mass and elasticity", MassCases()},
      {"Kinematic", KinematicCases()},
      {"Simultaneous", SimultaneousCases()},
      {"Joints and ends", JointCases()},
      {"Long runs", LongRunCases()}};
  std::vector<CHardCase> all;
  for (const auto& [pName, cases] : groups)
    for (const CHardCase& c : cases)
      all.emplace_back(c).m_sGroup = pName;
  return all;
}

} // namespace Shapes::HardCases
