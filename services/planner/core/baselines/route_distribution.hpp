#pragma once

#include <cstddef>
#include <vector>

#include "services/common/random.hpp"

namespace tandem {

/// A robot's intention in Dec-MCTS: some of its routes and how likely it takes each.
struct RouteDistribution {
  std::vector<std::vector<int>> routes;  ///< At least one.
  std::vector<double> probabilities;     ///< They add up to 1.

  [[nodiscard]] std::size_t drawn(Rng& rng) const;
  [[nodiscard]] std::size_t likeliest() const;
};

/// All routes equally likely.
[[nodiscard]] RouteDistribution uniform_distribution(std::vector<std::vector<int>> routes);

/// One step of the variational gradient (Best et al., IJRR 2019; probability collectives of Wolpert):
/// q(x) <- q(x) - step * q(x) * ((E[f] - E[f | x]) / temperature + H(q) + ln q(x)), then normalised.
/// `expected_rewards` are E[f | x] of each route. At a low temperature what pays takes all, at a high one all are
/// alike.
void descend(RouteDistribution& distribution, const std::vector<double>& expected_rewards, double step,
             double temperature);

}  // namespace tandem
