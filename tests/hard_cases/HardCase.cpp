// SPDX-License-Identifier: MIT
#include "HardCase.h"

namespace Shapes::HardCases {

CExpectations RefusedByAll(const std::string& words) {
  CExpectations all;
  for (std::size_t i = 0; i < g_nColumns; ++i)
    all.emplace_back(static_cast<eColumn>(i), Refused(words));
  return all;
}

CHardCase Named(CHardCase c, const std::string& name, const std::string& input, const std::string& right,
                const CExpectations& expect, const std::string& control,
                const std::function<double()>& naive) {
  c.m_sName = name;
  c.m_sInput = input;
  if (!right.empty()) c.m_sRight = right;
  for (const auto& [column, expected] : expect)
    c.m_stdExpect.at(static_cast<std::size_t>(column)) = expected;
  c.m_sControl = control;
  c.m_fnControl = naive;
  return c;
}

CHardCase Case(const std::string& name, const std::string& input, const std::string& right,
               const CBound& bound, const CExpectations& expect, const std::function<double(eColumn)>& error,
               const std::string& control, const std::function<double()>& naive) {
  CHardCase c;
  c.m_cBound = bound;
  c.m_fnError = error;
  return Named(c, name, input, right, expect, control, naive);
}

std::unique_ptr<CWorld> MakeWorld(eColumn column, const Vector2& gravity, float dt) {
  if (column == Reference) throw std::logic_error("the reference is no world");
  const CWorldDesc desc = Described(gravity, dt, 1, column == Approximate ? g_cApproximate : g_cContinuous,
                                    column == Tuned ? eProfile::Tuned : eProfile::Shipped);
  return GetBackend(IsNative(column) ? eBackend::Native : eBackend::Box2D)->MakeWorld(desc);
}

std::vector<CHardCase> AllCases() {
  const std::pair<const char*, std::vector<CHardCase>> groups[] = {
      {"Balls and shapes of no extent", NoExtentCases()},
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
