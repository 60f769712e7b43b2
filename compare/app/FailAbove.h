// SPDX-License-Identifier: MIT
// --fail-above: a run as a gate, for a script that wants an exit code and no table.
#pragma once

#include "report/Report.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace Shapes::Compare {

/// A metric and what is still allowed.
struct CLimit {
  std::string m_sMetric;
  double m_fMost = 0.0;
};

/// @param text "METRIC=VALUE"
/// @throws std::invalid_argument if there is no such metric (with its near matches), or VALUE is not a finite
/// number of at least 0
CLimit ParseLimit(std::string_view text);

/// A warning about a limit on a rate that so many impacts cannot show (none in n is a rate below 3/n, with
/// 95% confidence); empty if they can.
std::string WarnOfFew(const CLimit& limit, std::size_t contacts);

/// The same after a run, for each scene in which fewer were found than asked for, although as many as asked
/// for would do; and a sentence for each such scene without a limit, too.
std::vector<std::string> WarnOfFewFound(const CRunReport& report, std::span<const CLimit> limits);

/// A sentence for every limit, scene and engine of the run that is above, naming the three and the value;
/// for an engine without a value where another one has one, or that lost every impact;
/// and for a limit whose metric was measured on no scene at all, because none of this is a pass.
std::vector<std::string> FindAbove(const CRunReport& report, std::span<const CLimit> limits);

} // namespace Shapes::Compare
