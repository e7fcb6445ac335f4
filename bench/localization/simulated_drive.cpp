#include "bench/localization/simulated_drive.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "services/common/random.hpp"

namespace tandem::bench {
namespace {

constexpr double kSpeedMps = 0.4;
constexpr double kRangeMaxM = 20.0;
constexpr double kClearanceM = 0.6;

struct Wall {
  Eigen::Vector2d from;
  Eigen::Vector2d to;
};
using Walls = std::vector<Wall>;

void add_box(Walls& walls, const Pose2& map_from_box, double length_m, double width_m) {
  const Eigen::Vector2d half{length_m / 2.0, width_m / 2.0};
  const std::array<Eigen::Vector2d, 4> corners{map_from_box * Eigen::Vector2d{-half.x(), -half.y()},
                                               map_from_box * Eigen::Vector2d{half.x(), -half.y()}, map_from_box * half,
                                               map_from_box * Eigen::Vector2d{-half.x(), half.y()}};
  for (std::size_t i = 0; i < corners.size(); ++i) walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
}

/// How far a ray gets before it meets a wall [m].
double range_m(const Walls& walls, const Eigen::Vector2d& origin, double heading) {
  const Eigen::Vector2d direction{std::cos(heading), std::sin(heading)};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    Eigen::Matrix2d axes;
    axes << direction, wall.from - wall.to;
    if (std::abs(axes.determinant()) < 1e-12) continue;
    const Eigen::Vector2d solution = axes.inverse() * (wall.from - origin);
    if (solution.x() > 0.0 && solution.y() >= 0.0 && solution.y() <= 1.0) nearest = std::min(nearest, solution.x());
  }
  return nearest;
}

double clearance_m(const Walls& walls, const Eigen::Vector2d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Wall& wall : walls) {
    const Eigen::Vector2d along = wall.to - wall.from;
    const double share = std::clamp((point - wall.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (wall.from + share * along - point).norm());
  }
  return nearest;
}

/// Every cell that a wall runs through is occupied, the others are free.
OccupancyGrid drawn(const Walls& walls, double half_side_m, double resolution_m) {
  const int cells = static_cast<int>(std::ceil(2.0 * half_side_m / resolution_m));
  OccupancyGrid grid{cells, cells, resolution_m, {-half_side_m, -half_side_m, 0.0}, CellState::Free};
  for (const Wall& wall : walls) {
    const double length_m = (wall.to - wall.from).norm();
    const int steps = static_cast<int>(std::ceil(length_m / (0.1 * resolution_m)));
    for (int i = 0; i <= steps; ++i) {
      const CellIndex cell = grid.cell_at(wall.from + (wall.to - wall.from) * i / steps);
      if (grid.contains(cell)) grid.set(cell, CellState::Occupied);
    }
  }
  return grid;
}

Walls hall(Rng& rng) {
  Walls walls;
  const double turn = rng.uniform(-std::numbers::pi, std::numbers::pi);
  add_box(walls, {0.0, 0.0, turn}, rng.uniform(9.0, 14.0), rng.uniform(7.0, 10.0));
  for (int i = 0; i < 6; ++i) {
    const Pose2 place{rng.uniform(-4.0, 4.0), rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
    add_box(walls, place, rng.uniform(0.3, 1.5), rng.uniform(0.3, 1.0));
  }
  return walls;
}

Walls corridor(Rng& rng) {
  Walls walls;
  add_box(walls, {0.0, 0.0, rng.uniform(-std::numbers::pi, std::numbers::pi)}, 80.0, 2.4);
  return walls;
}

Pose2 start_in(const Walls& walls, bool is_corridor, Rng& rng) {
  if (is_corridor) {
    const Eigen::Vector2d along = walls.front().to - walls.front().from;
    return {0.0, 0.0, std::atan2(along.y(), along.x())};
  }
  while (true) {
    const Pose2 pose{rng.uniform(-3.5, 3.5), rng.uniform(-2.5, 2.5), rng.uniform(-3.0, 3.0)};
    const bool in_a_box = [&] {  // an odd number of walls on one side: inside the hall, and in no box
      int crossed = 0;
      for (const Wall& wall : walls) crossed += range_m({wall}, pose.position(), 0.1) < 1e9 ? 1 : 0;
      return crossed % 2 == 0;
    }();
    if (!in_a_box && clearance_m(walls, pose.position()) > kClearanceM) return pose;
  }
}

LaserScan scan_of(const Walls& walls, const Pose2& map_from_base, Time time, const DriveOptions& options, Rng& rng) {
  LaserScan scan;
  scan.time = time;
  scan.angle_min_rad = -std::numbers::pi / 2.0;
  scan.angle_increment_rad = std::numbers::pi / 180.0;
  scan.range_min_m = 0.05;
  scan.range_max_m = kRangeMaxM;
  for (int i = 0; i <= 180; ++i) {
    const double angle = map_from_base.heading + scan.angle_min_rad + i * scan.angle_increment_rad;
    double range = range_m(walls, map_from_base.position(), angle) + rng.normal(0.0, options.range_deviation_m);
    if (rng.uniform() < options.random_share) range *= rng.uniform(0.2, 0.9);
    scan.ranges_m.push_back(range < kRangeMaxM ? static_cast<float>(range) : std::numeric_limits<float>::quiet_NaN());
  }
  return scan;
}

}  // namespace

RecordedLog simulated_drive(std::uint64_t seed, const DriveOptions& options) {
  Rng rng{seed};
  const Walls walls = options.corridor ? corridor(rng) : hall(rng);
  RecordedLog log;
  log.name = options.corridor ? "corridor" : "hall";
  log.map = drawn(walls, options.corridor ? 41.0 : 9.0, options.resolution_m);
  Pose2 map_from_base = start_in(walls, options.corridor, rng);
  Pose2 odom_from_base;
  Time time{from_seconds(1.0)};
  double turn_rate_radps = 0.0;
  for (double way_m = 0.0; way_m < options.way_m;) {
    log.truth.push_back({time, map_from_base});
    log.events.emplace_back(OdometrySample{time, odom_from_base, {}, 0});
    log.events.emplace_back(scan_of(walls, map_from_base, time, options, rng));

    const double ahead_m = range_m(walls, map_from_base.position(), map_from_base.heading);
    double speed_mps = kSpeedMps;
    if (options.corridor) {
      turn_rate_radps = 0.0;
    } else if (ahead_m < 1.2) {
      speed_mps = 0.0;
      turn_rate_radps = 0.8;
    } else {
      turn_rate_radps = std::clamp(turn_rate_radps + rng.normal(0.0, 0.15), -0.5, 0.5);
    }
    Pose2 motion{speed_mps * options.step_s, 0.0, turn_rate_radps * options.step_s};
    if (clearance_m(walls, (map_from_base * motion).position()) < 0.3) motion = {0.0, 0.0, 0.8 * options.step_s};
    map_from_base = map_from_base * motion;
    odom_from_base = odom_from_base * sampled_motion(motion, deviation_of(motion, options.wheels), rng);
    time += from_seconds(options.step_s);
    way_m += motion.position().norm() + 0.1 * std::abs(motion.heading);
  }
  return log;
}

}  // namespace tandem::bench
