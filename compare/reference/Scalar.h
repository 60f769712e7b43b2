// SPDX-License-Identifier: MIT
// The second scalar of the exact reference: with it the double can be checked by 50 digits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

namespace Shapes::Compare {

/// 50 decimal digits. Without expression templates, so that it can be used wherever a double can.
using CFifty =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

} // namespace Shapes::Compare
