// SPDX-License-Identifier: MIT
// Properties that hold for every input, looked for by RapidCheck. It makes a counterexample as simple as it
// can and prints it with the seed that found it. Always the same inputs, unless the environment variable
// RC_PARAMS says otherwise: RC_PARAMS="max_success=1000000" tries a million from a new seed,
// RC_PARAMS="seed=7" those of that seed.
#pragma once

#include "../Testing.h"

#include <rapidcheck.h>

#include <cstdlib>

namespace Shapes::Properties {

inline rc::detail::TestParams Params(int runs) {
  if (std::getenv("RC_PARAMS") != nullptr) return rc::detail::configuration().testParams;
  rc::detail::TestParams params;
  params.seed = 20;
  params.maxSuccess = runs;
  return params;
}

/// Tells nobody: what a control finds is no failure of the run.
class CSilent : public rc::detail::TestListener {
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

template <class TProperty>
rc::detail::TestResult Try(TProperty&& property, const rc::detail::TestParams& params) {
  CSilent silent;
  return rc::detail::checkTestable(std::forward<TProperty>(property), rc::detail::TestMetadata{}, params,
                                   silent);
}

/// That nothing breaks it in so many inputs.
template <class TProperty>
void ExpectHolds(TProperty&& property, int runs = 5000) {
  const rc::detail::TestParams params = Params(runs);
  const rc::detail::TestResult result = Try(std::forward<TProperty>(property), params);
  if (result.template is<rc::detail::SuccessResult>()) return;
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  ADD_FAILURE() << text.str() << "\nRC_PARAMS=\"seed=" << params.seed << " max_success=" << params.maxSuccess
                << "\"";
}

/// The control: that the same inputs find what breaks it.
template <class TProperty>
void ExpectBroken(TProperty&& property, int runs = 5000) {
  rc::detail::TestParams params = Params(runs);
  params.disableShrinking = true;
  EXPECT_TRUE(Try(std::forward<TProperty>(property), params).template is<rc::detail::FailureResult>());
}

/// Both: it holds with `good` in its place, and the same inputs break it with `bad`.
template <class T, class TProperty>
void ExpectHolds(T good, T bad, int runs, TProperty property) {
  ExpectHolds([&] { property(good); }, runs);
  ExpectBroken([&] { property(bad); });
}

} // namespace Shapes::Properties
