// SPDX-License-Identifier: MIT
#include "HardCase.h"

namespace Shapes::HardCases {

namespace {

std::string Cell(const CExpect& expect) {
  switch (expect.m_eKind) {
  case CExpect::eKind::Refused: return "refused: \"" + expect.m_sText + "\"";
  case CExpect::eKind::NotAsked: return "- (" + expect.m_sText + ")";
  case CExpect::eKind::Right:
  case CExpect::eKind::Deviates: break;
  }
  return expect.m_sText;
}

} // namespace

std::string MakeTable(const std::vector<CHardCase>& cases) {
  std::string text =
      "# Hard cases\n\n"
      "Inputs at which collision code is known to fail, the right answer, and what each engine makes of it.\n"
      "Written by the tests in `tests/hard_cases`, which hold every cell; do not edit it by hand.\n\n"
      "- **native** is the approximate mode, **continuous** the continuous one; **box2d** is as it ships,\n"
      "  **tuned** the tuned profile; **reference** is the exact reference of `compare`, in double.\n"
      "- *right*: within the bound. In bold: a deviation, with its figure, that the tests hold too: they "
      "fail if\n"
      "  it becomes larger, and if it goes away. *refused*: an exception with these words.\n"
      "- The engines compute in float: inputs are rounded to it first, and the right answer is that to the\n"
      "  rounded input.\n"
      "- The last column is the formula that fails; the tests hold that it does.\n";
  std::string group;
  for (const CHardCase& c : cases) {
    if (c.m_sGroup != group) {
      group = c.m_sGroup;
      text += "\n## " + group +
              "\n\n| case | right answer | bound | native | continuous | box2d | tuned | reference | what "
              "fails |\n"
              "|---|---|---|---|---|---|---|---|---|\n";
    }
    text += "| " + c.m_sInput + " | " + c.m_sRight + " | " + c.m_sBound;
    for (const CExpect& expect : c.m_stdExpect)
      text += " | " + Cell(expect);
    text += " | " + c.m_sControl + " |\n";
  }
  return text;
}

} // namespace Shapes::HardCases
