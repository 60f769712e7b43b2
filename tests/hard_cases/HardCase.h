// SPDX-License-Identifier: MIT
// A hard case: an input at which collision code is known to fail, the right answer, what each engine makes of
// it, and the formula that fails. docs/hard_cases.md is written from these.
#pragma once

#include "../Testing.h"

namespace Shapes::HardCases {

/// The engines. Approximate is the approximate mode of native, Native its continuous one; Box2D is as it
/// ships, Tuned its tuned profile; Reference is the exact reference in double.
enum class eColumn { Approximate, Native, Box2D, Tuned, Reference, Size };
inline constexpr std::size_t g_nColumns = static_cast<std::size_t>(eColumn::Size);
/// "approximate", "native", "box2d", "tuned", "reference".
const char* GetName(eColumn column);

/// The expected result of an engine in a case.
struct CExpect {
  enum class eKind {
    Right,    ///< Its error is at most the bound of the case, or m_fMost if that is not 0.
    Deviates, ///< Its error is in [m_fLeast, m_fMost], above the bound: if it becomes right, the test fails.
    Refused,  ///< std::invalid_argument, whose text contains m_sText.
    NotAsked  ///< It has no such question; m_sText says why.
  };
  eKind m_eKind;
  double m_fLeast;
  double m_fMost;
  /// Of a deviation its figure and reason, for the table; of a wider bound its derivation, shown by a failing
  /// test.
  std::string m_sText;
};

CExpect Right();
/// A bound of its own, wider than that of the case: `derivation` says why it has to be.
CExpect RightWithin(double bound, const std::string& derivation);
CExpect Deviates(double least, double most, const std::string& figureAndReason);
CExpect Refused(const std::string& words);
CExpect NotAsked(const std::string& why);

using CExpectations = std::array<CExpect, g_nColumns>;
inline const CExpectations g_stdAllRight{Right(), Right(), Right(), Right(), Right()};

/// Largest error that is right, in the unit of CHardCase::m_fnError. The right answer is that to the input
/// rounded to float.
struct CBound {
  double m_fExact;     ///< For the reference.
  double m_fFloat;     ///< For the engines, whose numbers are floats.
  std::string m_sText; ///< Both and their origin, shown by a failing test: "8 roundings of t".
};
inline const CBound g_cBits{0.0, 0.0, "bit for bit"};
inline const CBound g_cEightRoundings{1e-12, 0x1p-21, "1e-12; engines 8 roundings of 1"};

struct CHardCase {
  std::string m_sName;  ///< CamelCase, unique: the name of its tests.
  std::string m_sInput; ///< In words and numbers, for the table. r is a ball's radius, v its velocity.
  std::string m_sRight; ///< The right answer.
  CBound m_cBound;
  CExpectations m_stdExpect = g_stdAllRight;
  /// The error of one of them, at least 0; infinity where nothing was found that had to be, or the other way
  /// round. Exceptions of the library pass through.
  std::function<double(eColumn)> m_fnError;
  std::string m_sControl; ///< What fails, and how: "quadratic equation in v^2: 0 / 0".
  /// The error of that, in the same unit; NaN counts as infinite.
  std::function<double()> m_fnControl;
  std::string m_sGroup = {}; ///< A heading of the table, from the list of all cases.
};

/// How GoogleTest prints one.
inline void PrintTo(const CHardCase& c, std::ostream* pOut) { *pOut << c.m_sName; }

/// All of them, in the order of the table. Each group has a file.
std::vector<CHardCase> AllCases();
std::vector<CHardCase> ValidationCases();
std::vector<CHardCase> CoincidentCases();
std::vector<CHardCase> LineCases();
std::vector<CHardCase> ArcCases();
std::vector<CHardCase> GrazingCases();
std::vector<CHardCase> FastCases();
std::vector<CHardCase> ScaleCases();
std::vector<CHardCase> MassCases();
std::vector<CHardCase> KinematicCases();
std::vector<CHardCase> SimultaneousCases();
std::vector<CHardCase> JointCases();
std::vector<CHardCase> LongRunCases();

/// The description of a world of that column; not for Reference.
CWorldDesc Desc(eColumn column, const Vector2& gravity = Vector2::Zero(), float dt = 1.0f / 60.0f);
std::unique_ptr<CWorld> MakeWorld(eColumn column, const CWorldDesc& desc);

/// The error of an event that did not happen.
inline constexpr double g_fNever = std::numeric_limits<double>::infinity();
/// Of two points or vectors; g_fNever if either is not finite.
double Distance(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// The text of docs/hard_cases.md: the cases in which an engine deviates, and counts of the others.
std::string MakeTable(const std::vector<CHardCase>& cases);

} // namespace Shapes::HardCases
