#include "bench/planning/instance/prior.hpp"

#include <cassert>
#include <cmath>
#include <numeric>

namespace tandem::bench {
namespace {

/// Adds `part`, scaled to the sum `weight`; nothing if it is empty.
void add_part(std::vector<double>& prior, const std::vector<double>& part, double weight) {
  const double sum = std::accumulate(part.begin(), part.end(), 0.0);
  if (sum <= 0.0) return;
  for (std::size_t i = 0; i < prior.size(); ++i) prior[i] += weight * part[i] / sum;
}

}  // namespace

std::vector<double> prior_of(const PriorSpec& spec, const SearchArea& area, const Eigen::Vector2d& start_in_map,
                             const std::vector<bool>& can_be_seen) {
  const auto size = static_cast<std::size_t>(area.size());
  assert(can_be_seen.size() == size);
  std::vector<double> floor(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    const int cell = static_cast<int>(i);
    const bool excluded = (area.point(cell) - start_in_map).norm() < spec.excluded_radius_m;
    if (can_be_seen[i] && !excluded) floor[i] = area.floor_m2(cell);
  }
  std::vector<double> prior(size, 0.0);
  add_part(prior, floor, spec.uniform_weight);
  for (const Gaussian& hill : spec.gaussians) {
    std::vector<double> part(size);
    for (std::size_t i = 0; i < size; ++i) {
      const double distance = (area.point(static_cast<int>(i)) - hill.centre_in_map).norm() / hill.sigma_m;
      part[i] = floor[i] * std::exp(-0.5 * distance * distance);
    }
    add_part(prior, part, hill.weight);
  }
  std::vector<double> normalised(size, 0.0);
  add_part(normalised, prior, 1.0);
  return normalised;
}

}  // namespace tandem::bench
