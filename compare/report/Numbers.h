// SPDX-License-Identifier: MIT
// Numbers as people read them, for the table and the verdicts.
#pragma once

#include "../metrics/Statistics.h"

#include <cstddef>
#include <string>

namespace Shapes::Compare {

/// A length in radii, an angle, any size from 0 up: three decimals, "<.001" below what they show, one decimal
/// from 10 on.
std::string SizeText(double x);

/// 20000 as "20,000".
std::string CountText(std::size_t n);

/// A rate in percent, two digits that matter: "20.3%", "0.12%"; none seen in n as "<0.015%", which is 3 in n
/// and holds with 95% confidence; "-" without trials.
std::string RateText(std::size_t hits, std::size_t n);

/// The same with half the width of its interval: "20.3% +-0.3".
std::string RateTextWithError(std::size_t hits, std::size_t n);

/// 12.3456 as "12", 0.123 as "0.12": two digits that matter, never an exponent from 1e-4 to 1e15.
std::string TwoDigits(double x);

bool Overlap(const CInterval& a, const CInterval& b);

} // namespace Shapes::Compare
