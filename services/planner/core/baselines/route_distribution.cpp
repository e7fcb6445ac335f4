#include "services/planner/core/baselines/route_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem {
namespace {

constexpr double kLeastProbability = 1e-6;

}  // namespace

std::size_t RouteDistribution::drawn(Rng& rng) const {
  double left = rng.uniform();
  for (std::size_t i = 0; i + 1 < probabilities.size(); ++i) {
    left -= probabilities[i];
    if (left < 0.0) return i;
  }
  return probabilities.size() - 1;
}

std::size_t RouteDistribution::likeliest() const {
  return static_cast<std::size_t>(std::ranges::max_element(probabilities) - probabilities.begin());
}

RouteDistribution uniform_distribution(std::vector<std::vector<int>> routes) {
  RouteDistribution distribution;
  distribution.probabilities.assign(routes.size(), 1.0 / static_cast<double>(routes.size()));
  distribution.routes = std::move(routes);
  return distribution;
}

void descend(RouteDistribution& distribution, const std::vector<double>& expected_rewards, double step,
             double temperature) {
  double expected = 0.0;
  double entropy = 0.0;
  for (std::size_t i = 0; i < distribution.routes.size(); ++i) {
    const double q = distribution.probabilities[i];
    expected += q * expected_rewards[i];
    entropy -= q * std::log(q);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < distribution.routes.size(); ++i) {
    double& q = distribution.probabilities[i];
    q -= step * q * ((expected - expected_rewards[i]) / temperature + entropy + std::log(q));
    q = std::max(q, kLeastProbability);
    sum += q;
  }
  for (double& q : distribution.probabilities) q /= sum;
}

}  // namespace tandem
