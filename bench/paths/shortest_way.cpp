#include "bench/paths/shortest_way.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "services/mapping/core/distance_field.hpp"
#include "services/mapping/core/ray_casting.hpp"

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

constexpr double kHair_m = 1e-4;
constexpr double kSlack_m = 0.02;  ///< of clearance, which our own ways may use up between the cells of a map

}  // namespace

OccupancyGrid room_for(const OccupancyGrid& map, double radius_m) {
  const DistanceField clearance(map, 2.0 * radius_m, Obstacles::OccupiedOrUnknown);
  OccupancyGrid room = map;
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const CellIndex cell{column, row};
      const bool is_free = map.is_free(cell) && clearance.at(cell) >= radius_m - kSlack_m;
      room.set(cell, is_free ? CellState::Free : CellState::Occupied);
    }
  }
  return room;
}

std::vector<Vector2d> outer_corners(const OccupancyGrid& room) {
  std::vector<Vector2d> corners;
  const double half_m = 0.5 * room.resolution_m();
  for (int row = 0; row + 1 < room.height(); ++row) {
    for (int column = 0; column + 1 < room.width(); ++column) {
      // Where four cells meet and one of them is occupied.
      std::optional<CellIndex> occupied;
      int count = 0;
      for (const CellIndex cell : {CellIndex{column, row}, CellIndex{column + 1, row}, CellIndex{column, row + 1},
                                   CellIndex{column + 1, row + 1}}) {
        if (!room.is_occupied(cell)) continue;
        occupied = cell;
        ++count;
      }
      if (count != 1) continue;
      const Vector2d inside = room.centre_in_map(*occupied);
      const Vector2d opposite = room.centre_in_map({2 * column + 1 - occupied->column, 2 * row + 1 - occupied->row});
      corners.push_back(inside + (0.5 + 0.5 * kHair_m / half_m) * (opposite - inside));
    }
  }
  return corners;
}

std::optional<std::vector<Vector2d>> shortest_way(const OccupancyGrid& room, const Vector2d& start_in_map,
                                                  const Vector2d& goal_in_map) {
  std::vector<Vector2d> points = outer_corners(room);
  points.push_back(goal_in_map);
  points.push_back(start_in_map);
  const std::size_t goal = points.size() - 2;
  const std::size_t start = points.size() - 1;
  std::vector<double> cost_m(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> previous(points.size(), start);
  std::vector<bool> done(points.size(), false);
  using Open = std::pair<double, std::size_t>;  // at least so long a way leads over this point
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  cost_m[start] = 0.0;
  open.emplace((goal_in_map - start_in_map).norm(), start);
  while (!open.empty()) {
    const std::size_t here = open.top().second;
    open.pop();
    if (done[here]) continue;
    done[here] = true;
    if (here == goal) {
      std::vector<Vector2d> way{goal_in_map};
      for (std::size_t at = goal; at != start; at = previous[at]) way.push_back(points[previous[at]]);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (std::size_t other = 0; other < points.size(); ++other) {
      const double there_m = cost_m[here] + (points[other] - points[here]).norm();
      if (there_m >= cost_m[other] || !line_of_sight(room, points[here], points[other])) continue;
      cost_m[other] = there_m;
      previous[other] = here;
      open.emplace(there_m + (goal_in_map - points[other]).norm(), other);
    }
  }
  return std::nullopt;
}

double length_m(const std::vector<Vector2d>& way) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) sum_m += (way[i] - way[i - 1]).norm();
  return sum_m;
}

}  // namespace tandem::bench
