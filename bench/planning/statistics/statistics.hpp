#pragma once

#include <span>
#include <vector>

#include "services/common/random.hpp"

namespace tandem::bench {

/// A figure and the interval that holds it with 95 % confidence.
struct Interval {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// exp of the mean of the logarithms; all `values` > 0. 1 if there are none.
[[nodiscard]] double geometric_mean(std::span<const double> values);

/// The `share` quantile, linear between order statistics, of at least one value.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// The geometric mean with its bias-corrected and accelerated bootstrap interval of 95 % (Efron 1987), over `resamples`
/// samples. With less than two values, or all equal, the interval is the value.
[[nodiscard]] Interval bootstrapped_geometric_mean(std::span<const double> values, int resamples, Rng rng);

/// Two-sided p of Wilcoxon's signed-rank test that `differences` are symmetric around 0: exact up to 25 differences
/// without ties, normal with correction for ties and continuity beyond. Zeros are left out; 1 if none is left.
[[nodiscard]] double wilcoxon_signed_rank_p(std::span<const double> differences);

/// A paired comparison: ratios ours / theirs, instance by instance.
struct PairedComparison {
  std::size_t instances = 0;
  Interval ratio;      ///< geometric mean; below 1 we are faster
  double p = 1.0;      ///< Wilcoxon on the logarithms, not yet corrected for several tests
  int wins = 0;        ///< ratio below 0.99
  int ties = 0;        ///< within 1 %
  int losses = 0;      ///< ratio above 1.01
  double worst = 1.0;  ///< greatest ratio
};

[[nodiscard]] PairedComparison compared(std::span<const double> ours, std::span<const double> theirs, Rng rng,
                                        int resamples = 10000);

/// The slope of a straight line through (log x, log y): the exponent with which y grows in x. At least two points.
[[nodiscard]] double growth_exponent(std::span<const double> x, std::span<const double> y);

}  // namespace tandem::bench
