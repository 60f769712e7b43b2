// SPDX-License-Identifier: MIT
#include "Statistics.h"

#include <algorithm>
#include <cmath>

namespace Shapes::Compare {
namespace {

// The smallest value that at least the share q of the sorted sample does not exceed.
double NearestRank(const std::vector<double>& sorted, double q) {
  const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

} // namespace

CSummary Summarise(std::vector<double> values) {
  std::erase_if(values, [](double x) { return !std::isfinite(x); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.size(), NearestRank(values, 0.5), NearestRank(values, 0.95), values.back()};
}

CSummary SummariseSigned(std::vector<double> values) {
  const CSummary withSigns = Summarise(values);
  for (double& x : values)
    x = std::abs(x);
  CSummary s = Summarise(std::move(values));
  s.m_fMedian = withSigns.m_fMedian + 0.0; // no negative zero
  return s;
}

CInterval Wilson(std::size_t hits, std::size_t trials, double z) {
  if (trials == 0) return {};
  const double n = static_cast<double>(trials), p = static_cast<double>(hits) / n, z2 = z * z;
  const double centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = z / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  // Where nothing, or everything, was hit, an end is exact: it must not come out as a rounding.
  return {hits == 0 ? 0.0 : std::max(0.0, centre - half),
          hits == trials ? 1.0 : std::min(1.0, centre + half)};
}

CMedian MedianWithInterval(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  // The median lies below the k-th smallest value if fewer than k of n coins show heads. Both tails together
  // stay below 5%.
  double tail = std::pow(0.5, static_cast<double>(n)), term = tail;
  std::size_t k = 0;
  while (2.0 * tail <= 0.05 && k + 1 <= n / 2) {
    ++k;
    term *= static_cast<double>(n - k + 1) / static_cast<double>(k);
    tail += term;
  }
  const std::size_t low = k == 0 ? 0 : k - 1;
  return {NearestRank(values, 0.5), {values[low], values[n - 1 - low]}};
}

CQuantile QuantileWithInterval(std::vector<double> values, double q) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const double n = static_cast<double>(values.size()), half = 1.959964 * std::sqrt(n * q * (1.0 - q));
  const auto at = [&](double rank) { return values[static_cast<std::size_t>(std::clamp(rank, 1.0, n)) - 1]; };
  return {NearestRank(values, q), {at(std::floor(n * q - half)), at(std::ceil(n * q + half) + 1.0)}};
}

double GeometricMean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double x : values)
    sum += std::log(x);
  return std::exp(sum / static_cast<double>(values.size()));
}

bool CanBeToldApart(std::size_t a, std::size_t b) {
  const double both = static_cast<double>(a) + static_cast<double>(b);
  const double apart = std::abs(static_cast<double>(a) - static_cast<double>(b));
  return apart - 1.0 > 1.959964 * std::sqrt(both);
}

} // namespace Shapes::Compare
