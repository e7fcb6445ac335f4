#include "services/planner/core/scenario/drawn_room.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {
namespace {

using Eigen::Vector2d;

constexpr double kBorder_m = 0.2;  ///< thickness of the walls around the room
constexpr double kSlack_m = 1e-9;

double distance_to_piece(const Vector2d& point, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double length2 = way.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - from).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (from + share * way - point).norm();
}

bool is_in(const RoomWall& wall, const Vector2d& point) {
  for (std::size_t i = 1; i < wall.points_in_map.size(); ++i) {
    if (distance_to_piece(point, wall.points_in_map[i - 1], wall.points_in_map[i]) <=
        0.5 * wall.thickness_m + kSlack_m) {
      return true;
    }
  }
  return false;
}

bool is_in(const RoomBox& box, const Vector2d& point) {
  return (point.array() >= box.min_in_map.array() - kSlack_m).all() &&
         (point.array() <= box.max_in_map.array() + kSlack_m).all();
}

bool is_occupied(const DrawnRoom& room, double altitude_m, const Vector2d& point) {
  if (point.x() < 0.0 || point.y() < 0.0 || point.x() > room.width_m || point.y() > room.height_m) return true;
  const auto blocks = [&](const auto& obstacle) { return obstacle.height_m >= altitude_m && is_in(obstacle, point); };
  return std::ranges::any_of(room.walls, blocks) || std::ranges::any_of(room.boxes, blocks);
}

}  // namespace

OccupancyGrid draw_layer(const DrawnRoom& room, double altitude_m) {
  const int border = std::max(1, static_cast<int>(std::lround(kBorder_m / room.resolution_m)));
  const double origin_m = -border * room.resolution_m;
  OccupancyGrid map{static_cast<int>(std::lround(room.width_m / room.resolution_m)) + 2 * border,
                    static_cast<int>(std::lround(room.height_m / room.resolution_m)) + 2 * border, room.resolution_m,
                    Pose2{origin_m, origin_m, 0.0}};
  for (int row = 0; row < map.height(); ++row) {
    for (int column = 0; column < map.width(); ++column) {
      const bool occupied = is_occupied(room, altitude_m, map.centre_in_map({column, row}));
      map.set({column, row}, occupied ? CellState::Occupied : CellState::Free);
    }
  }
  return map;
}

}  // namespace tandem
