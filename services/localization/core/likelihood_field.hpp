#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// How likely a beam ends where it did: Thrun, Burgard, Fox, Probabilistic Robotics, 6.4.
struct BeamModel {
  double hit_deviation_m = 0.12;  ///< spread of returns around a wall
  double random_share = 0.15;     ///< in (0, 1): share of returns from things that are not on the map
};

/// log((1 - r) exp(-d^2 / 2 s^2) + r) of each cell of a map, looked up where beams end; the value is in [log r, 0].
class LikelihoodField {
 public:
  LikelihoodField(const OccupancyGrid& grid, const DistanceField& distances, const BeamModel& model);

  /// Mean log likelihood of beams that end at `endpoints_in_base` [m] with the base at `map_from_base`; 0 for none.
  [[nodiscard]] double mean_log_likelihood(const Pose2& map_from_base,
                                           std::span<const Eigen::Vector2d> endpoints_in_base) const;

  /// Of a beam that ends at `point_in_cells` (see OccupancyGrid::in_cells).
  [[nodiscard]] float at(double column, double row) const {
    if (!(column >= 0.0 && row >= 0.0 && column < width_ && row < height_)) return outside_;
    return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  }
  [[nodiscard]] const OccupancyGrid& frame() const { return frame_; }

 private:
  int width_;
  int height_;
  OccupancyGrid frame_;  ///< without cells: where the field lies
  float outside_;
  std::vector<float> values_;
};

}  // namespace tandem
