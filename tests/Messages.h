// SPDX-License-Identifier: MIT
// Texts of errors and reports.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace Shapes {

/// Whether a text has this part. A test that fails prints both.
inline testing::AssertionResult Says(std::string_view text, std::string_view part) {
  const bool says = text.find(part) != text.npos;
  return (says ? testing::AssertionSuccess() : testing::AssertionFailure()) << part << "\nin\n" << text;
}

/// The message of the error that f throws; empty if it throws none.
template <class TError, class F>
std::string MessageOf(const F& f) {
  try {
    f();
  } catch (const TError& error) {
    return error.what();
  }
  return {};
}

} // namespace Shapes
