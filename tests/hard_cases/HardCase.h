// SPDX-License-Identifier: MIT
// A hard case: an input at which collision code is known to fail, the right answer, what each engine makes of
// it, and the formula that fails. docs/hard_cases.md is written from these.
#pragma once

#include "../Testing.h"

namespace Shapes::HardCases {

/// The engines. Approximate is the approximate mode of native, Native its continuous one; Box2D is as it
/// ships, Tuned its tuned profile; Reference is the exact reference in double.
enum class eColumn { Approximate, Native, Box2D, Tuned, Reference, Size };
using enum eColumn;
inline constexpr std::size_t g_nColumns = static_cast<std::size_t>(eColumn::Size);
/// "approximate", "native", "box2d", "tuned", "reference".
inline const char* GetName(eColumn column) {
  constexpr std::array names{"approximate", "native", "box2d", "tuned", "reference"};
  return names.at(static_cast<std::size_t>(column));
}
inline bool IsNative(eColumn column) { return column == Approximate || column == Native; }

/// The error of an event that did not happen.
inline constexpr double g_fNever = std::numeric_limits<double>::infinity();

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

inline CExpect Right() { return {CExpect::eKind::Right, 0.0, 0.0, "right"}; }
/// A bound of its own, wider than that of the case: `derivation` says why it has to be.
inline CExpect RightWithin(double bound, const std::string& derivation) {
  return {CExpect::eKind::Right, 0.0, bound, "right: " + derivation};
}
inline CExpect Deviates(double least, double most, const std::string& figureAndReason) {
  return {CExpect::eKind::Deviates, least, most, figureAndReason};
}
/// A deviation by this figure: held to between half of it and twice of it.
inline CExpect Off(double figure, const std::string& figureAndReason) {
  return Deviates(0.5 * figure, 2.0 * figure, figureAndReason);
}
/// A case that is not met at all.
inline CExpect Missed(const std::string& reason) { return Deviates(g_fNever, g_fNever, reason); }
inline CExpect Refused(const std::string& words) { return {CExpect::eKind::Refused, 0.0, 0.0, words}; }
inline CExpect NotAsked(const std::string& why) { return {CExpect::eKind::NotAsked, 0.0, 0.0, why}; }

/// Of the engines that are not just right.
using CExpectations = std::vector<std::pair<eColumn, CExpect>>;

/// Largest error that is right, in the unit of CHardCase::m_fnError. The right answer is that to the input
/// rounded to float.
struct CBound {
  double m_fExact;     ///< For the reference.
  double m_fFloat;     ///< For the engines, whose numbers are floats.
  std::string m_sText; ///< Both and their origin, shown by a failing test: "8 roundings of t".
};
inline const CBound g_cBits{0.0, 0.0, "bit for bit"};
inline const CBound g_cEightRoundings{1e-12, 0x1p-21, "1e-12; engines 8 roundings of 1"};
inline const CBound g_cTwoUlps{1e-12, 0x1p-22, "1e-12; engines 2 ulps of 1"};
/// n roundings of a number of this size, in double and in float.
inline CBound Roundings(int n, int size = 1) {
  return {n * size * 0x1p-53, n * size * 0x1p-24,
          std::to_string(n) + " roundings of " + std::to_string(size)};
}

struct CHardCase {
  std::string m_sName;  ///< CamelCase: the name of its tests. GoogleTest ends where one is there twice.
  std::string m_sInput; ///< In words and numbers, for the table. r is a ball's radius, v its velocity.
  std::string m_sRight; ///< The right answer.
  CBound m_cBound;
  std::array<CExpect, g_nColumns> m_stdExpect{Right(), Right(), Right(), Right(), Right()};
  /// The error of one of them, at least 0; infinity where nothing was found that had to be, or the other way
  /// round. Exceptions of the library pass through.
  std::function<double(eColumn)> m_fnError;
  std::string m_sControl; ///< What fails, and how: "quadratic equation in v^2: 0 / 0".
  /// The error of that, in the same unit; NaN counts as infinite.
  std::function<double()> m_fnControl;
  std::string m_sGroup = {}; ///< A heading of the table, from the list of all cases.
};

/// Every engine refuses it.
CExpectations RefusedByAll(const std::string& words);

/// Completes a case whose bound and error are known. @param right  "": that of c
CHardCase Named(CHardCase c, const std::string& name, const std::string& input, const std::string& right,
                const CExpectations& expect, const std::string& control,
                const std::function<double()>& naive);
/// A case of all its parts.
CHardCase Case(const std::string& name, const std::string& input, const std::string& right,
               const CBound& bound, const CExpectations& expect, const std::function<double(eColumn)>& error,
               const std::string& control, const std::function<double()>& naive);

/// How GoogleTest prints one.
inline void PrintTo(const CHardCase& c, std::ostream* pOut) { *pOut << c.m_sName; }

/// All of them, in the order of the table. Each group has a file.
std::vector<CHardCase> AllCases();
std::vector<CHardCase> NoExtentCases();
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

/// A world of that column; not of Reference.
std::unique_ptr<CWorld> MakeWorld(eColumn column, const Vector2& gravity = Vector2::Zero(), float dt = g_fDt);

/// The larger one; g_fNever where either is not a number.
inline double Worst(double a, double b) { return std::isnan(a) || std::isnan(b) ? g_fNever : std::max(a, b); }
/// The worst of f(0) .. f(n - 1).
template <class F>
double WorstOf(int n, const F& f) {
  double worst = 0.0;
  for (int i = 0; i < n; ++i)
    worst = Worst(worst, f(i));
  return worst;
}
/// The worst of f of each value.
template <class T, class F>
double WorstOf(std::initializer_list<T> values, const F& f) {
  return WorstOf(static_cast<int>(values.size()), [&](int i) { return f(values.begin()[i]); });
}
/// Of two points or vectors; g_fNever if either is not finite.
inline double Distance(const Vector2d& a, const Vector2d& b) {
  const double d = (a - b).norm();
  return std::isfinite(d) ? d : g_fNever;
}

/// The text of docs/hard_cases.md: the cases in which an engine deviates, and counts of the others.
std::string MakeTable(const std::vector<CHardCase>& cases);

} // namespace Shapes::HardCases
