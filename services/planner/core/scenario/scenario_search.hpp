#pragma once

#include <Eigen/Core>
#include <vector>

namespace tandem {

/// A heap of probability.
struct PriorPeak {
  Eigen::Vector2d centre_in_map;  ///< [m]
  double deviation_m = 1.0;
  double weight = 1.0;
};

/// A part of the map that is more or less likely than the rest.
struct PriorArea {
  std::vector<Eigen::Vector2d> corners_in_map;  ///< [m]
  double weight = 1.0;                          ///< Probability per square metre against 1 outside all areas.
};

/// What is searched for in a scenario, and where it may lie.
struct ScenarioSearch {
  int objects = 1;
  double cell_size_m = 0.5;
  double excluded_radius_m = 0.0;  ///< Nothing lies nearer to the first agent's start.
  std::vector<PriorPeak> peaks;    ///< If there are any, they are all there is; else uniform.
  std::vector<PriorArea> areas;
};

/// How likely an object lies at each point, in all 1, if each point stands for `floor_m2` of floor. Uniform if the
/// scenario's prior is zero everywhere.
[[nodiscard]] std::vector<double> prior_of(const ScenarioSearch& search, const Eigen::Vector2d& first_start_in_map,
                                           const std::vector<Eigen::Vector2d>& points_in_map,
                                           const std::vector<double>& floor_m2);

}  // namespace tandem
