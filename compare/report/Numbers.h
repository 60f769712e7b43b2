// SPDX-License-Identifier: MIT
// Numbers as people read them, for the table and the verdicts.
#pragma once

#include "metrics/Statistics.h"

#include <cstddef>
#include <string>

namespace Shapes::Compare {

/// Rounding of floats of about 1: errors of directions below it are noise.
inline constexpr double g_fRounding = 1e-7;

/// A length in radii, an angle, any size from 0 up: three decimals, one from 10 on, "2e-5" below what they
/// show, "<1e-7" below g_fRounding.
std::string SizeText(double x);

/// 20000 as "20,000".
std::string CountText(std::size_t n);

/// A rate in percent, two digits that matter: "20.3%", "0.12%"; none seen in n as "<0.015%", which is 3 in n
/// and holds with 95% confidence; "-" without trials.
std::string RateText(std::size_t hits, std::size_t n);

/// The same with half the width of its interval: "20.3% +-0.3".
std::string RateTextWithError(std::size_t hits, std::size_t n);

/// A time of any size in five characters: "12345", "123k", "1e+07".
std::string TimeText(double ns);

/// 12.3456 as "12", 0.123 as "0.12": two digits that matter, never an exponent from 1e-4 to 1e15.
std::string TwoDigits(double x);

/// An angle, given in radians, in degrees: "0.6 degrees", never below "0.001 degrees", because
/// it stands after "within".
std::string DegreesText(double radians);

/// So many of so many, as people say it: "none of 2,000", "1 in 40", "45%" above a quarter.
std::string LossText(std::size_t lost, std::size_t n);

/// A ratio of speeds: "11 times as fast", "0.77 times as fast", "as fast" within a twentieth.
std::string FasterText(double ratio);

bool Overlap(const CInterval& a, const CInterval& b);

} // namespace Shapes::Compare
