#include "bench/planning/instance/layouts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

constexpr double kLowWallHeight_m = 1.8;

/// A straight wall along an axis from `from` over `length_m`, with a door of `door_m` that begins `door_at_m` along it.
struct Wall {
  Vector2d from;
  bool along_x = true;
  double length_m = 0.0;
  double door_at_m = 0.0;
  double door_m = 0.0;
  double thickness_m = 0.2;
  double height_m = std::numeric_limits<double>::infinity();
};

void add_piece(FloorPlan& plan, const Wall& wall, double begin_m, double end_m) {
  if (end_m - begin_m < 0.5 * plan.resolution_m) return;
  const Vector2d along = wall.along_x ? Vector2d{1.0, 0.0} : Vector2d{0.0, 1.0};
  const Vector2d across{along.y(), along.x()};
  const Vector2d half = 0.5 * wall.thickness_m * across;
  plan.boxes.push_back({wall.from + begin_m * along - half, wall.from + end_m * along + half, wall.height_m});
}

void add_wall(FloorPlan& plan, const Wall& wall) {
  if (wall.door_m <= 0.0) return add_piece(plan, wall, 0.0, wall.length_m);
  add_piece(plan, wall, 0.0, wall.door_at_m);
  add_piece(plan, wall, wall.door_at_m + wall.door_m, wall.length_m);
}

/// On a grid of 0.1 m, so that walls are drawn where they are.
double tenths(double length_m) {
  return 0.1 * std::round(10.0 * length_m);
}

/// A door somewhere in a wall, half a metre from its ends.
double door_place(Rng& rng, double length_m, double door_m) {
  return tenths(0.5 + std::max(0.0, length_m - door_m - 1.0) * rng.uniform());
}

/// Rooms side by side along x from `low`, divided by walls, each with a door in the wall at its top or bottom.
void add_row_of_rooms(FloorPlan& plan, Rng& rng, const Vector2d& low, double length_m, double depth_m, bool door_at_top,
                      double thickness_m, bool low_walls) {
  double x_m = 0.0;
  while (length_m - x_m > 1.0) {
    double room_m = tenths(rng.uniform(5.0, 11.0));
    if (length_m - x_m - room_m < 5.0) room_m = length_m - x_m;
    const double door_m = 1.4;
    const Vector2d door_wall = low + Vector2d{x_m, door_at_top ? depth_m : 0.0};
    add_wall(plan, {door_wall, true, room_m, door_place(rng, room_m, door_m), door_m, thickness_m});
    x_m += room_m;
    if (length_m - x_m > 1.0) {
      const bool is_low = low_walls && rng.uniform() < 0.5;
      add_wall(plan, {low + Vector2d{x_m, 0.0}, false, depth_m, 0.0, 0.0, thickness_m,
                      is_low ? kLowWallHeight_m : std::numeric_limits<double>::infinity()});
    }
  }
}

}  // namespace

FloorPlan walls_and_columns(Rng& rng, bool low_walls) {
  constexpr double kSpacing_m = 5.0;
  FloorPlan plan{30.0, 25.0, 0.1, {}};
  bool next_is_low = low_walls;
  for (int column = 1; column < 6; ++column) {
    for (int row = 1; row < 5; ++row) {
      const Vector2d knot{kSpacing_m * column, kSpacing_m * row};
      const double kind = rng.uniform();
      if (kind < 0.45) {
        const double half_m = rng.uniform() < 0.3 ? 0.4 : 0.3;
        plan.boxes.push_back({knot - Vector2d::Constant(half_m), knot + Vector2d::Constant(half_m)});
      } else if (kind < 0.9) {
        Wall wall{knot, rng.uniform() < 0.5, tenths(rng.uniform(3.0, kSpacing_m)), 0.0, 0.0, 0.2};
        if (next_is_low) wall.height_m = kLowWallHeight_m;
        if (low_walls) next_is_low = !next_is_low;
        add_wall(plan, wall);
      }
    }
  }
  return plan;
}

FloorPlan small_rooms(Rng& rng) {
  FloorPlan plan{8.0, 8.0, 0.1, {}};
  const double x_m = tenths(rng.uniform(3.0, 5.0));
  const double door_m = 1.2;
  add_wall(plan, {{x_m, 0.0}, false, 8.0, door_place(rng, 8.0, door_m), door_m, 0.2});
  for (const bool left : {true, false}) {
    if (rng.uniform() < 0.25) continue;
    const double begin_m = left ? 0.0 : x_m;
    const double length_m = left ? x_m : 8.0 - x_m;
    const double y_m = tenths(rng.uniform(2.5, 5.5));
    add_wall(plan, {{begin_m, y_m}, true, length_m, door_place(rng, length_m, door_m), door_m, 0.2});
  }
  return plan;
}

FloorPlan office_floor(Rng& rng, bool low_walls) {
  FloorPlan plan{125.0, 80.0, 0.2, {}};
  constexpr double kCorridor_m = 2.4;
  constexpr double kThickness_m = 0.4;
  const int corridors = 4;
  const double period_m = plan.height_m / corridors;
  const double depth_m = 0.5 * (period_m - kCorridor_m);
  // A corridor across joins the others.
  const double across_at_m = tenths(rng.uniform(30.0, 90.0));
  for (int i = 0; i < corridors; ++i) {
    const double y_m = period_m * i;
    for (const auto& [begin_m, end_m] :
         {std::pair{0.0, across_at_m}, std::pair{across_at_m + kCorridor_m, plan.width_m}}) {
      add_row_of_rooms(plan, rng, {begin_m, y_m}, end_m - begin_m, depth_m, true, kThickness_m, low_walls);
      add_row_of_rooms(plan, rng, {begin_m, y_m + depth_m + kCorridor_m}, end_m - begin_m, depth_m, false, kThickness_m,
                       low_walls);
    }
    for (const double x_m : {across_at_m, across_at_m + kCorridor_m}) {
      add_wall(plan, {{x_m, y_m}, false, period_m, depth_m, kCorridor_m, kThickness_m});
    }
  }
  for (int i = 1; i < corridors; ++i) {
    // Back to back rooms: one wall between, open where the corridor crosses.
    add_wall(plan, {{0.0, period_m * i}, true, plan.width_m, across_at_m, kCorridor_m, kThickness_m});
  }
  return plan;
}

FloorPlan plaza(Rng& rng) {
  FloorPlan plan{125.0, 80.0, 0.2, {}};
  for (int column = 1; column < 12; ++column) {
    for (int row = 1; row < 8; ++row) {
      if (rng.uniform() < 0.35) continue;
      const Vector2d knot{10.4 * column + rng.uniform(-2.0, 2.0), 10.0 * row + rng.uniform(-2.0, 2.0)};
      const bool kiosk = rng.uniform() < 0.4;
      const Vector2d half = kiosk ? Vector2d{rng.uniform(1.0, 3.0), rng.uniform(1.0, 3.0)} : Vector2d{0.4, 0.4};
      plan.boxes.push_back({knot - half, knot + half});
    }
  }
  return plan;
}

FloorPlan campus(Rng& rng) {
  FloorPlan plan{400.0, 250.0, 0.2, {}};
  constexpr double kThickness_m = 0.4;
  for (int column = 0; column < 5; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (rng.uniform() < 0.2) continue;  // a lawn
      const double length_m = tenths(rng.uniform(30.0, 60.0));
      const double depth_m = tenths(rng.uniform(20.0, 42.0));
      const Vector2d low{80.0 * column + tenths(rng.uniform(6.0, 74.0 - length_m)),
                         62.5 * row + tenths(rng.uniform(6.0, 56.0 - depth_m))};
      const double room_m = 0.5 * (depth_m - 3.0);
      // Two rows of rooms and a corridor between them that is open at both ends.
      add_row_of_rooms(plan, rng, low, length_m, room_m, true, kThickness_m, false);
      add_row_of_rooms(plan, rng, low + Vector2d{0.0, depth_m - room_m}, length_m, room_m, false, kThickness_m, false);
      for (const double y_m : {0.0, depth_m}) {
        add_wall(plan, {low + Vector2d{0.0, y_m}, true, length_m, 0.0, 0.0, kThickness_m});
      }
      for (const double x_m : {0.0, length_m}) {
        add_wall(plan, {low + Vector2d{x_m, 0.0}, false, depth_m, room_m, 3.0, kThickness_m});
      }
    }
  }
  return plan;
}

FloorPlan brl_square() {
  FloorPlan plan{42.0, 20.5, 0.1, {}};
  for (int column = 0; column < 8; ++column) {
    for (int row = 0; row < 2; ++row) {
      const Vector2d centre{3.5 + 5.0 * column, 3.0 + 5.0 * row};
      plan.boxes.push_back({centre - Vector2d::Constant(0.25), centre + Vector2d::Constant(0.25)});
    }
  }
  for (int column = 0; column < 3; ++column) {
    const Vector2d centre{8.5 + 10.0 * column, 13.0};
    plan.boxes.push_back({centre - Vector2d::Constant(0.2), centre + Vector2d::Constant(0.2)});
  }
  add_wall(plan, {{11.0, 0.0}, false, 4.5, 0.0, 0.0, 0.3});
  add_wall(plan, {{26.0, 0.0}, false, 5.5, 0.0, 0.0, 0.3});
  add_wall(plan, {{31.0, 10.5}, true, 5.5, 0.0, 0.0, 0.3});
  add_wall(plan, {{22.0, 17.0}, false, 3.5, 0.0, 0.0, 0.3});
  for (const auto& [low, high] :
       {std::pair{Vector2d{13.0, 14.5}, Vector2d{17.0, 17.0}}, std::pair{Vector2d{20.0, 5.0}, Vector2d{22.5, 8.5}},
        std::pair{Vector2d{35.5, 0.0}, Vector2d{38.0, 1.6}}, std::pair{Vector2d{0.0, 17.0}, Vector2d{2.0, 20.5}},
        std::pair{Vector2d{30.0, 16.0}, Vector2d{42.0, 20.5}}}) {
    plan.boxes.push_back({low, high});
  }
  return plan;
}

}  // namespace tandem::bench
