#include "services/experiment/core/report/statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "services/common/random.hpp"

namespace tandem::experiment {
namespace {

constexpr std::size_t kExactPairs = 20;
constexpr int kPermutations = 100'000;
constexpr int kResamples = 10'000;
constexpr std::uint64_t kSeed = 1;
/// Sums of the same numbers in another order differ by rounding; they are the same all the same.
constexpr double kRounding = 1e-9;

double sum_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double squares_around(std::span<const double> values, double middle) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [middle](double sum, double value) { return sum + (value - middle) * (value - middle); });
}

double exact_p(std::span<const double> differences, double limit) {
  const std::size_t ways = std::size_t{1} << differences.size();
  std::size_t extreme = 0;
  for (std::size_t signs = 0; signs < ways; ++signs) {
    double sum = 0.0;
    for (std::size_t i = 0; i < differences.size(); ++i)
      sum += (signs >> i & 1U) != 0 ? -differences[i] : differences[i];
    if (std::abs(sum) >= limit) ++extreme;
  }
  return static_cast<double>(extreme) / static_cast<double>(ways);
}

double sampled_p(int extreme) {
  return (1.0 + extreme) / (1.0 + kPermutations);
}

double point_g(std::span<const double> a, std::span<const double> b) {
  if (a.size() < 2 || b.size() < 2) return 0.0;
  const double freedom = static_cast<double>(a.size() + b.size()) - 2.0;
  const double pooled = std::sqrt((squares_around(a, mean_of(a)) + squares_around(b, mean_of(b))) / freedom);
  if (!(pooled > 0.0)) return 0.0;
  return (mean_of(b) - mean_of(a)) / pooled * (1.0 - 3.0 / (4.0 * freedom - 1.0));
}

std::vector<double> resampled(std::span<const double> values, Rng& rng) {
  std::vector<double> drawn(values.size());
  for (double& value : drawn) value = values[rng.index(values.size())];
  return drawn;
}

}  // namespace

double mean_of(std::span<const double> values) {
  return values.empty() ? 0.0 : sum_of(values) / static_cast<double>(values.size());
}

double deviation_of(std::span<const double> values) {
  if (values.size() < 2) return 0.0;
  return std::sqrt(squares_around(values, mean_of(values)) / static_cast<double>(values.size() - 1));
}

double median_of(std::span<const double> values) {
  if (values.empty()) return 0.0;
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

Anova anova(std::span<const std::vector<double>> groups) {
  std::vector<double> all;
  int count = 0;
  for (const auto& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
    count += group.empty() ? 0 : 1;
  }
  Anova result{.between = std::max(0, count - 1), .within = static_cast<int>(all.size()) - count};
  if (count < 2 || result.within < 1) return result;
  const double grand = mean_of(all);
  double within = 0.0;
  double between = 0.0;
  for (const auto& group : groups) {
    const double middle = mean_of(group);
    within += squares_around(group, middle);
    between += static_cast<double>(group.size()) * (middle - grand) * (middle - grand);
  }
  if (!(between > 0.0)) return result;
  result.eta_squared = between / (between + within);
  if (!(within > 0.0)) {
    result.f = std::numeric_limits<double>::infinity();
    result.p = 0.0;
    return result;
  }
  result.f = (between / result.between) / (within / result.within);
  const boost::math::fisher_f distribution(result.between, result.within);
  result.p = boost::math::cdf(boost::math::complement(distribution, result.f));
  return result;
}

double paired_permutation_p(std::span<const double> differences) {
  if (differences.empty()) return 1.0;
  const double limit = std::abs(sum_of(differences)) - kRounding;
  if (differences.size() <= kExactPairs) return exact_p(differences, limit);
  Rng rng{kSeed};
  int extreme = 0;
  for (int i = 0; i < kPermutations; ++i) {
    double sum = 0.0;
    for (const double difference : differences) sum += rng.bits() >> 63 != 0 ? -difference : difference;
    if (std::abs(sum) >= limit) ++extreme;
  }
  return sampled_p(extreme);
}

double permutation_p(std::span<const double> a, std::span<const double> b) {
  if (a.empty() || b.empty()) return 1.0;
  std::vector<double> all(a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  const double whole = sum_of(all);
  const auto apart = [&](double sum_of_a) {
    return std::abs(sum_of_a / static_cast<double>(a.size()) - (whole - sum_of_a) / static_cast<double>(b.size()));
  };
  const double limit = apart(sum_of(a)) - kRounding;
  Rng rng{kSeed};
  int extreme = 0;
  for (int i = 0; i < kPermutations; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      std::swap(all[k], all[k + rng.index(all.size() - k)]);
      sum += all[k];
    }
    if (apart(sum) >= limit) ++extreme;
  }
  return sampled_p(extreme);
}

EffectSize hedges_g(std::span<const double> a, std::span<const double> b) {
  EffectSize effect{.g = point_g(a, b)};
  if (effect.g == 0.0) return effect;
  Rng rng{kSeed};
  std::vector<double> drawn;
  drawn.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i) {
    const auto some_a = resampled(a, rng);
    drawn.push_back(point_g(some_a, resampled(b, rng)));
  }
  std::ranges::sort(drawn);
  effect.low = drawn[kResamples / 40];
  effect.high = drawn[kResamples - 1 - kResamples / 40];
  return effect;
}

std::vector<double> holm_adjusted(std::span<const double> p_values) {
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, static_cast<double>(order.size() - rank) * p_values[order[rank]]);
    adjusted[order[rank]] = std::min(1.0, largest);
  }
  return adjusted;
}

}  // namespace tandem::experiment
