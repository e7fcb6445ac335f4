#pragma once

#include <Eigen/Core>
#include <vector>

#include "bench/planning/instance/floor_plan.hpp"
#include "services/planner/core/search/search_area.hpp"

namespace tandem::bench {

/// A hill of probability.
struct Gaussian {
  Eigen::Vector2d centre_in_map;  ///< [m]
  double sigma_m = 1.0;
  double weight = 1.0;  ///< its share, relative to the others
};

/// Where the object may lie: a mixture of parts, each cut to the searched floor.
struct PriorSpec {
  double uniform_weight = 1.0;
  std::vector<Gaussian> gaussians;
  double excluded_radius_m = 0.0;  ///< Nothing lies so near to the start, and the searchers know it.
};

/// The probability of each cell, in all 1. Nothing lies where `can_be_seen` says false, so that every search can end.
[[nodiscard]] std::vector<double> prior_of(const PriorSpec& spec, const SearchArea& area,
                                           const Eigen::Vector2d& start_in_map, const std::vector<bool>& can_be_seen);

}  // namespace tandem::bench
