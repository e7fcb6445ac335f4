#include "services/planner/core/search/observability.hpp"

#include <cmath>

#include "services/mapping/core/ray_casting.hpp"

namespace tandem {
namespace {

constexpr double kStandpointReach_m = 0.75;  ///< an agent this far off the area still looks from its border

int nearest_floor(const SearchArea& area, int column, int row) {
  if (const int own = area.cell_of(column, row); own >= 0) return own;
  const Eigen::Vector2d middle =
      area.origin_in_map() + area.cell_size_m() * (Eigen::Vector2d(column, row) + Eigen::Vector2d::Constant(0.5));
  const int reach = static_cast<int>(std::ceil(kStandpointReach_m / area.cell_size_m()));
  int nearest = -1;
  double nearest_m = kStandpointReach_m;
  for (int y = row - reach; y <= row + reach; ++y) {
    for (int x = column - reach; x <= column + reach; ++x) {
      const int cell = area.cell_of(x, y);
      if (cell < 0 || (area.point(cell) - middle).norm() >= nearest_m) continue;
      nearest = cell;
      nearest_m = (area.point(cell) - middle).norm();
    }
  }
  return nearest;
}

}  // namespace

Observability::Observability(const OccupancyGrid& map, const SearchArea& area, double range_m)
    : map_(map), area_(area), range_m_(range_m), in_sight_(static_cast<std::size_t>(area.size())) {
  for (int row = 0; row < area.height(); ++row) {
    for (int column = 0; column < area.width(); ++column) standpoints_.push_back(nearest_floor(area, column, row));
  }
}

int Observability::standpoint(int column, int row) const {
  if (column < 0 || row < 0 || column >= area_.width() || row >= area_.height()) return -1;
  return standpoints_[static_cast<std::size_t>(row) * static_cast<std::size_t>(area_.width()) +
                      static_cast<std::size_t>(column)];
}

const View& Observability::in_sight_of(int standpoint) {
  View& view = in_sight_[static_cast<std::size_t>(standpoint)];
  if (!view.empty()) return view;
  for (const int cell : area_.cells_around(standpoint, range_m_)) {
    const bool near = (area_.point(cell) - area_.point(standpoint)).norm() <= range_m_;
    if (cell == standpoint || (near && line_of_sight(map_, area_.point(standpoint), area_.point(cell)))) {
      view.push_back(cell);
    }
  }
  return view;
}

View Observability::seen_from(const Searcher& searcher, const Pose2& pose) {
  View seen;
  const auto standpoint = area_.nearest_cell(pose.position(), kStandpointReach_m);
  if (!standpoint) return seen;
  const double half_field_rad = 0.5 * searcher.field_of_view_rad;
  for (const int cell : in_sight_of(*standpoint)) {
    const Eigen::Vector2d away = area_.point(cell) - pose.position();
    const double distance_m = away.norm();
    if (distance_m < searcher.view_min_m || distance_m > searcher.view_max_m) continue;
    const double bearing_rad = turn_between(pose.heading, std::atan2(away.y(), away.x()));
    if (distance_m > 0.0 && std::abs(bearing_rad) > half_field_rad + 1e-9) continue;
    seen.push_back(cell);
  }
  return seen;
}

}  // namespace tandem
