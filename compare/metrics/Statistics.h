// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace Shapes::Compare {

/// Radians.
inline constexpr double g_fDegree = std::numbers::pi / 180.0;

/// Median, 95th percentile and maximum of a sample: no mean, because errors have long tails.
struct CSummary {
  std::size_t m_nCount = 0;
  double m_fMedian = 0.0;
  double m_fP95 = 0.0;
  double m_fMax = 0.0;

  /// None of an empty sample.
  std::optional<double> GetP95() const { return m_nCount == 0 ? std::nullopt : std::optional(m_fP95); }
};

/// Summary of the finite values of a sample by nearest rank; all 0 if there are none.
CSummary Summarise(std::vector<double> values);

/// Of a figure that has a sign: the median with its sign (a bias shows in it), 95th percentile and maximum of
/// the absolute values.
CSummary SummariseSigned(std::vector<double> values);

struct CInterval {
  double m_fLow = 0.0;
  double m_fHigh = 1.0;
};

/// Wilson score interval of a rate of `hits` in `trials` at z standard errors (E. B. Wilson, Probable
/// Inference, the Law of Succession, and Statistical Inference, JASA 22, 1927); [0, 1] without trials. With
/// no hits its upper end is about z^2 / trials.
CInterval Wilson(std::size_t hits, std::size_t trials, double z = 1.959964);

/// A quantile of a sample with the interval between order statistics that holds the true one with 95% (normal
/// approximation of the binomial); the quantile by nearest rank. All 0 for an empty sample.
struct CQuantile {
  double m_fValue = 0.0;
  CInterval m_cInterval{0.0, 0.0};
};
CQuantile QuantileWithInterval(std::vector<double> values, double q);

/// Of values above 0.
double GeometricMean(const std::vector<double>& values);

/// Whether two counts of losses at the same impacts differ by more than chance: of two engines that are asked
/// at the same impacts what counts are those that only one of them lost (Q. McNemar, Psychometrika 12, 1947,
/// with correction for continuity, 95%). That none was lost by both is taken, which is on the safe side.
bool CanBeToldApart(std::size_t a, std::size_t b);

/// Median of a sample with the interval between order statistics that holds the true median with at least 95%
/// (binomial); the whole range for fewer than 6 values.
struct CMedian {
  double m_fMedian = 0.0;
  CInterval m_cInterval{0.0, 0.0};
};
CMedian MedianWithInterval(std::vector<double> values);

} // namespace Shapes::Compare
