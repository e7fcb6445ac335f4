#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Tests and effect sizes of a report. Random numbers come from fixed seeds: equal data, equal report.
namespace tandem::experiment {

/// 0 without values.
[[nodiscard]] double mean_of(std::span<const double> values);
/// Of a sample (divided by n - 1); 0 for fewer than two values.
[[nodiscard]] double deviation_of(std::span<const double> values);
/// 0 without values.
[[nodiscard]] double median_of(std::span<const double> values);

/// A one-way analysis of variance.
struct Anova {
  double f = 0.0;
  int between = 0;           ///< degrees of freedom, groups - 1
  int within = 0;            ///< values - groups
  double p = 1.0;            ///< of the F distribution
  double eta_squared = 0.0;  ///< share of the variance that the groups explain
};
/// Empty groups are left out. With fewer than two groups, or no degree of freedom within, nothing is shown: p is 1.
/// Groups that differ without any variance within have p 0 and an infinite F.
[[nodiscard]] Anova anova(std::span<const std::vector<double>> groups);

/// Whether the mean of `differences` (one per pair) may be 0: the share of all ways of flipping signs that give a mean
/// at least as far from 0. Exact up to 20 pairs; beyond, of 100,000 random ways (and the one that was). 1 without
/// pairs.
[[nodiscard]] double paired_permutation_p(std::span<const double> differences);

/// Whether two groups may have one mean: of 100,000 random divisions (and the one that was), the share whose means are
/// at least as far apart. 1 if a group is empty.
[[nodiscard]] double permutation_p(std::span<const double> a, std::span<const double> b);

/// A difference of means in standard deviations, with its bootstrap interval of 95 % (percentiles of 10,000).
struct EffectSize {
  double g = 0.0;
  double low = 0.0;
  double high = 0.0;
};
/// Hedges' g of b against a (positive: b is greater), pooled deviation, corrected for small samples. 0 for groups of
/// fewer than two values or without any deviation.
[[nodiscard]] EffectSize hedges_g(std::span<const double> a, std::span<const double> b);

/// The p-values made stricter for being many (Holm), in the order given.
[[nodiscard]] std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace tandem::experiment
