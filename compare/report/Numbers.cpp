// SPDX-License-Identifier: MIT
#include "Numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {
namespace {

// The least percentage that is shown.
constexpr double g_fLeastPercent = 0.0001;

// The least degrees that are shown: a ball is a millimetre aside after 57 metres.
constexpr double g_fLeastDegrees = 0.001;

// Decimals with which a percentage shows two digits that matter; one from 1 on, four below 0.01.
int Decimals(double x) {
  if (!(x > 0.0)) return 1;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(x))), 1, 4);
}

// "2e-5": one digit, and no zero in the exponent.
std::string PowerText(double x) {
  std::string text = fmt::format("{:.0e}", x);
  if (const std::size_t zero = text.find("-0"); zero != text.npos) text.erase(zero + 1, 1);
  return text;
}

double Percent(std::size_t hits, std::size_t n) {
  return 100.0 * static_cast<double>(hits) / static_cast<double>(n);
}

} // namespace

std::string SizeText(double x) {
  if (x == 0.0) return "0";
  if (x < g_fRounding) return "<1e-7";
  if (x < 0.0005) return PowerText(x);
  if (x < 9.9995) return fmt::format("{:.3f}", x);
  return x < 1e6 ? fmt::format("{:.1f}", x) : fmt::format("{:.0e}", x);
}

std::string CountText(std::size_t n) {
  const std::string digits = std::to_string(n);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string RateText(std::size_t hits, std::size_t n) {
  if (n == 0) return "-";
  if (hits == 0) return fmt::format("<{}%", TwoDigits(std::min(100.0, 300.0 / static_cast<double>(n))));
  if (hits == n) return "100%";
  const double percent = Percent(hits, n);
  if (percent < g_fLeastPercent) return fmt::format("<{}%", g_fLeastPercent);
  return fmt::format("{:.{}f}%", percent, Decimals(percent));
}

std::string RateTextWithError(std::size_t hits, std::size_t n) {
  if (n == 0 || hits == 0 || Percent(hits, n) < g_fLeastPercent) return RateText(hits, n);
  const CInterval i = Wilson(hits, n);
  return fmt::format("{} +-{:.{}f}", RateText(hits, n), 50.0 * (i.m_fHigh - i.m_fLow),
                     Decimals(Percent(hits, n)));
}

std::string TimeText(double ns) {
  return ns < 99999.5   ? fmt::format("{:.0f}", ns)
         : ns < 9999500 ? fmt::format("{:.0f}k", ns / 1000)
                        : fmt::format("{:.0e}", ns);
}

std::string TwoDigits(double x) {
  if (!(x > 0.0)) return "0";
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(x)));
  if (decimals <= 0) return fmt::format("{:.0f}", x);
  std::string text = fmt::format("{:.{}f}", x, std::min(decimals, 9));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string DegreesText(double radians) {
  const double degrees = radians / g_fDegree;
  if (degrees < g_fLeastDegrees) return fmt::format("{} degrees", g_fLeastDegrees);
  return degrees < 9.95 ? TwoDigits(degrees) + " degrees" : fmt::format("{:.0f} degrees", degrees);
}

std::string LossText(std::size_t lost, std::size_t n) {
  if (n == 0) return "-";
  if (lost == 0) return "none of " + CountText(n);
  if (4 * lost > n) return fmt::format("{:.0f}%", Percent(lost, n));
  const double one = static_cast<double>(n) / static_cast<double>(lost);
  if (one < 9.95) return "1 in " + TwoDigits(one);
  const double digits = std::pow(10.0, std::max(0.0, std::floor(std::log10(one)) - 1.0));
  return "1 in " + CountText(static_cast<std::size_t>(std::lround(std::round(one / digits) * digits)));
}

std::string FasterText(double ratio) {
  if (std::abs(ratio - 1.0) < 0.05) return "as fast";
  return fmt::format("{:.{}f} times as fast", ratio, ratio < 1.0 ? 2 : ratio < 9.95 ? 1 : 0);
}

bool Overlap(const CInterval& a, const CInterval& b) {
  return a.m_fLow <= b.m_fHigh && b.m_fLow <= a.m_fHigh;
}

} // namespace Shapes::Compare
