// SPDX-License-Identifier: MIT
#include "HardCase.h"

namespace Shapes::HardCases {

const char* GetName(eColumn column) {
  switch (column) {
  case eColumn::Approximate: return "approximate";
  case eColumn::Native: return "native";
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
  desc.m_cEffects = column == eColumn::Approximate ? g_cApproximate : g_cContinuous;
  if (column == eColumn::Tuned) desc.m_cBox2D.m_eProfile = eProfile::Tuned;
  return desc;
}

std::unique_ptr<CWorld> MakeWorld(eColumn column, const CWorldDesc& desc) {
  const bool native = column == eColumn::Approximate || column == eColumn::Native;
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

namespace {

bool HasDeviation(const CHardCase& c) {
  return std::ranges::any_of(
      c.m_stdExpect, [](const CExpect& expect) { return expect.m_eKind == CExpect::eKind::Deviates; });
}

std::string Row(const CHardCase& c) {
  std::string deviations;
  for (std::size_t i = 0; i < g_nColumns; ++i) {
    const CExpect& expect = c.m_stdExpect[i];
    if (expect.m_eKind != CExpect::eKind::Deviates) continue;
    deviations += (deviations.empty() ? "**" : "<br>**") + std::string(GetName(static_cast<eColumn>(i))) +
                  "** " + expect.m_sText;
  }
  return "| " + c.m_sInput + " | " + c.m_sRight + " | " + deviations + " | " + c.m_sControl + " |\n";
}

} // namespace

std::string MakeTable(const std::vector<CHardCase>& cases) {
  const auto deviating = std::ranges::count_if(cases, HasDeviation);
  std::string text =
      "# Hard cases\n\n"
      "Inputs at which collision code is known to fail, and the engines that deviate from the right answer.\n"
      "Written by the tests in `tests/hard_cases`; do not edit it by hand. Of " +
      std::to_string(cases.size()) + " cases\n" + std::to_string(deviating) +
      " are listed; in the others every engine is within the bound, or refuses the input.\n\n"
      "- **approximate** is the approximate mode of native, **native** the continuous one; **box2d** is as "
      "it\n"
      "  ships, **tuned** the tuned profile; **reference** is the exact reference of `compare`, in double. "
      "An\n"
      "  engine that a row does not name is right. The tests fail if a deviation grows, and if it goes "
      "away.\n"
      "- The engines compute in float: inputs are rounded to it first, and the right answer is that to the\n"
      "  rounded input. The bounds are in the tests, most of them a few roundings.\n"
      "- The last column is a formula that fails; the tests hold that it does.\n";
  std::map<std::string, std::ptrdiff_t> listed, right;
  for (const CHardCase& c : cases)
    ++(HasDeviation(c) ? listed : right)[c.m_sGroup];
  std::string group;
  for (const CHardCase& c : cases) {
    if (c.m_sGroup != group) {
      group = c.m_sGroup;
      text += "\n## " + group + "\n\nNot listed: " + std::to_string(right[group]) + ".\n";
      if (listed[group] > 0)
        text += "\n| case | right answer | deviations | formula that fails |\n|---|---|---|---|\n";
    }
    if (HasDeviation(c)) text += Row(c);
  }
  return text;
}

} // namespace Shapes::HardCases
