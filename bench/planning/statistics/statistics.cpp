#include "bench/planning/statistics/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace tandem::bench {
namespace {

double normal_distribution(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// The inverse of normal_distribution by bisection: exact enough, and without a table of coefficients.
double normal_quantile(double share) {
  double low = -10.0;
  double high = 10.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_distribution(middle) < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Efron's acceleration from the jackknife of the mean.
double acceleration(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  const double mean = mean_of(values);
  double cubes = 0.0;
  double squares = 0.0;
  for (const double value : values) {
    // The mean without this value differs from the mean of those means by (value - mean) / (n - 1).
    const double difference = (value - mean) / (n - 1.0);
    cubes += difference * difference * difference;
    squares += difference * difference;
  }
  return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

/// P(signed rank sum <= `sum`) for `n` differences without ties: counts the subsets of ranks 1..n.
double exact_rank_sum_distribution(int n, double sum) {
  const int greatest = n * (n + 1) / 2;
  std::vector<double> subsets(static_cast<std::size_t>(greatest) + 1, 0.0);
  subsets[0] = 1.0;
  for (int rank = 1; rank <= n; ++rank) {
    for (int s = greatest; s >= rank; --s)
      subsets[static_cast<std::size_t>(s)] += subsets[static_cast<std::size_t>(s - rank)];
  }
  double below = 0.0;
  for (int s = 0; s <= static_cast<int>(std::floor(sum + 1e-9)); ++s) below += subsets[static_cast<std::size_t>(s)];
  return below / std::exp2(n);
}

}  // namespace

double geometric_mean(std::span<const double> values) {
  if (values.empty()) return 1.0;
  double sum = 0.0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

double quantile(std::vector<double> values, double share) {
  assert(!values.empty());
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

Interval bootstrapped_geometric_mean(std::span<const double> values, int resamples, Rng rng) {
  const double value = geometric_mean(values);
  if (values.size() < 2) return {value, value, value};
  std::vector<double> logs;
  for (const double v : values) logs.push_back(std::log(v));
  const double mean = mean_of(logs);
  std::vector<double> means;
  means.reserve(static_cast<std::size_t>(resamples));
  for (int i = 0; i < resamples; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < logs.size(); ++k) sum += logs[rng.index(logs.size())];
    means.push_back(sum / static_cast<double>(logs.size()));
  }
  std::ranges::sort(means);
  if (means.back() - means.front() < 1e-15) return {value, value, value};
  const auto below = static_cast<double>(std::ranges::lower_bound(means, mean) - means.begin());
  const double share = std::clamp(below / resamples, 1.0 / resamples, 1.0 - 1.0 / resamples);
  const double bias = normal_quantile(share);
  const double a = acceleration(logs);
  const auto bound = [&](double level) {
    const double z = bias + normal_quantile(level);
    return std::exp(quantile(means, normal_distribution(bias + z / (1.0 - a * z))));
  };
  return {value, bound(0.025), bound(0.975)};
}

double wilcoxon_signed_rank_p(std::span<const double> differences) {
  std::vector<double> kept;
  for (const double difference : differences) {
    if (difference != 0.0) kept.push_back(difference);
  }
  const auto n = static_cast<double>(kept.size());
  if (kept.empty()) return 1.0;
  std::ranges::sort(kept, {}, [](double d) { return std::abs(d); });
  double negative_ranks = 0.0;
  double tie_correction = 0.0;
  for (std::size_t i = 0; i < kept.size();) {
    std::size_t end = i;
    while (end < kept.size() && std::abs(kept[end]) == std::abs(kept[i])) ++end;
    const auto tied = static_cast<double>(end - i);
    const double rank = 0.5 * static_cast<double>(i + 1 + end);
    for (; i < end; ++i) negative_ranks += kept[i] < 0.0 ? rank : 0.0;
    tie_correction += tied * tied * tied - tied;
  }
  const double smaller = std::min(negative_ranks, n * (n + 1.0) / 2.0 - negative_ranks);
  if (tie_correction == 0.0 && kept.size() <= 25) {
    return std::min(1.0, 2.0 * exact_rank_sum_distribution(static_cast<int>(kept.size()), smaller));
  }
  const double variance = n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - tie_correction / 48.0;
  if (variance <= 0.0) return 1.0;
  const double z = (smaller + 0.5 - n * (n + 1.0) / 4.0) / std::sqrt(variance);
  return std::min(1.0, 2.0 * normal_distribution(z));
}

PairedComparison compared(std::span<const double> ours, std::span<const double> theirs, Rng rng, int resamples) {
  assert(ours.size() == theirs.size());
  PairedComparison comparison;
  comparison.instances = ours.size();
  if (ours.empty()) return comparison;
  std::vector<double> ratios;
  std::vector<double> logs;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double ratio = ours[i] / theirs[i];
    ratios.push_back(ratio);
    logs.push_back(std::log(ratio));
    comparison.wins += ratio < 0.99 ? 1 : 0;
    comparison.losses += ratio > 1.01 ? 1 : 0;
  }
  comparison.ties = static_cast<int>(ours.size()) - comparison.wins - comparison.losses;
  comparison.ratio = bootstrapped_geometric_mean(ratios, resamples, rng);
  comparison.p = wilcoxon_signed_rank_p(logs);
  comparison.worst = *std::ranges::max_element(ratios);
  return comparison;
}

double growth_exponent(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size() && x.size() >= 2);
  std::vector<double> log_x;
  std::vector<double> log_y;
  for (std::size_t i = 0; i < x.size(); ++i) {
    log_x.push_back(std::log(x[i]));
    log_y.push_back(std::log(y[i]));
  }
  const double mean_x = mean_of(log_x);
  const double mean_y = mean_of(log_y);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    products += (log_x[i] - mean_x) * (log_y[i] - mean_y);
    squares += (log_x[i] - mean_x) * (log_x[i] - mean_x);
  }
  return products / squares;
}

}  // namespace tandem::bench
