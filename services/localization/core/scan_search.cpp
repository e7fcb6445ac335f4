#include "services/localization/core/scan_search.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace tandem {

Pose2 best_pose_in_window(const LikelihoodField& field, std::span<const Eigen::Vector2d> endpoints_in_base,
                          const Pose2& centre, const SearchWindow& window) {
  const OccupancyGrid& frame = field.frame();
  const int steps = static_cast<int>(std::ceil(window.half_side_m / window.step_m));
  const int turns = static_cast<int>(std::ceil(window.half_turn_rad / window.step_rad));
  const double step_cells = window.step_m / frame.resolution_m();
  std::vector<Eigen::Vector2d> in_cells(endpoints_in_base.size());

  Pose2 best = centre;
  double best_score = -std::numeric_limits<double>::infinity();
  for (int turn = -turns; turn <= turns; ++turn) {
    const Pose2 turned{centre.x, centre.y, wrap_to_pi(centre.heading + turn * window.step_rad)};
    for (std::size_t i = 0; i < in_cells.size(); ++i) in_cells[i] = frame.in_cells(turned * endpoints_in_base[i]);
    for (int row = -steps; row <= steps; ++row) {
      for (int column = -steps; column <= steps; ++column) {
        // The lattice runs along the grid's axes: shifting a scan is adding to its cells.
        double sum = 0.0;
        for (const Eigen::Vector2d& p : in_cells) {
          sum += static_cast<double>(field.at(p.x() + column * step_cells, p.y() + row * step_cells));
        }
        const double away = (row * row + column * column) / static_cast<double>(steps * steps) +
                            turn * turn / static_cast<double>(turns * turns);
        const double score = sum / static_cast<double>(in_cells.size()) - window.prior_weight * away;
        if (score > best_score) {
          best_score = score;
          const Pose2 map_from_grid_axes{0.0, 0.0, frame.map_from_grid().heading};
          const Eigen::Vector2d shift =
              map_from_grid_axes * Eigen::Vector2d{column * window.step_m, row * window.step_m};
          best = {centre.x + shift.x(), centre.y + shift.y(), turned.heading};
        }
      }
    }
  }
  return best;
}

}  // namespace tandem
