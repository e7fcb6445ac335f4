#include "services/localization/core/likelihood_field.hpp"

#include <cmath>

namespace tandem {

LikelihoodField::LikelihoodField(const OccupancyGrid& grid, const DistanceField& distances, const BeamModel& model)
    : width_(grid.width()),
      height_(grid.height()),
      frame_(0, 0, grid.resolution_m(), grid.map_from_grid()),
      outside_(static_cast<float>(std::log(model.random_share))) {
  const double factor = -0.5 / (model.hit_deviation_m * model.hit_deviation_m);
  values_.reserve(grid.cells().size());
  float last_distance = -1.0F;  // neighbours are often equally far: a field that is cut off, above all
  for (int row = 0; row < height_; ++row) {
    for (int column = 0; column < width_; ++column) {
      const float cell_distance = distances.at({column, row});
      if (cell_distance == last_distance) {
        values_.push_back(values_.back());
        continue;
      }
      last_distance = cell_distance;
      const double distance = cell_distance;
      values_.push_back(static_cast<float>(
          std::log((1.0 - model.random_share) * std::exp(factor * distance * distance) + model.random_share)));
    }
  }
}

double LikelihoodField::mean_log_likelihood(const Pose2& map_from_base,
                                            std::span<const Eigen::Vector2d> endpoints_in_base) const {
  if (endpoints_in_base.empty()) return 0.0;
  const Eigen::Vector2d base = frame_.in_cells(map_from_base.position());
  const double heading = map_from_base.heading - frame_.map_from_grid().heading;
  const double c = std::cos(heading) / frame_.resolution_m();
  const double s = std::sin(heading) / frame_.resolution_m();
  double sum = 0.0;
  for (const Eigen::Vector2d& p : endpoints_in_base) {
    sum += static_cast<double>(at(base.x() + c * p.x() - s * p.y(), base.y() + s * p.x() + c * p.y()));
  }
  return sum / static_cast<double>(endpoints_in_base.size());
}

}  // namespace tandem
