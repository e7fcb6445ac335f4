#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "services/common/random.hpp"
#include "services/map_builder/core/drive_log.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem::test {

/// A ring of corridors around a block, 16 m x 12 m in cells of 0.1 m, with niches and pillars that tell places apart.
[[nodiscard]] inline OccupancyGrid ring_of_corridors() {
  std::vector<std::string> rows;
  for (int y = 119; y >= 0; --y) {
    std::string row;
    for (int x = 0; x < 160; ++x) {
      const bool border = x < 2 || y < 2 || x >= 158 || y >= 118;
      const bool block = x >= 32 && x < 128 && y >= 32 && y < 88;
      const bool niche = (x >= 50 && x < 62 && y >= 32 && y < 40) || (x >= 96 && x < 104 && y >= 80 && y < 88) ||
                         (x >= 120 && x < 128 && y >= 50 && y < 58);
      const bool pillar = (x >= 2 && x < 6 && y >= 60 && y < 66) || (x >= 70 && x < 76 && y >= 113 && y < 118) ||
                          (x >= 153 && x < 158 && y >= 30 && y < 36) || (x >= 100 && x < 106 && y >= 2 && y < 7);
      row += border || (block && !niche) || pillar ? '#' : '.';
    }
    rows.push_back(row);
  }
  return ascii_map(rows, 0.1);
}

/// A drive with what the robot measured, and where it was at each scan.
struct RingDrive {
  std::vector<OdometrySample> odometry;
  std::vector<LaserScan> scans;
  std::vector<Pose2> truth;  ///< in the map's frame
};

/// `way_m` counter-clockwise around the ring, a scan every 0.25 m; the wheels say `turn_bias_radpm` too much, and start
/// at `odom_from_start`.
[[nodiscard]] inline RingDrive drive_around(double way_m, double turn_bias_radpm, const Pose2& odom_from_start = {}) {
  const OccupancyGrid map = ring_of_corridors();
  constexpr double kStepM = 0.25;
  const std::vector<Eigen::Vector2d> corners{{1.8, 1.8}, {14.2, 1.8}, {14.2, 10.2}, {1.8, 10.2}};
  RingDrive drive;
  Pose2 pose{corners[0].x() + 2.0, corners[0].y(), 0.0};
  Pose2 odom = odom_from_start;
  std::size_t next = 1;
  for (double way = 0.0; way <= way_m; way += kStepM) {
    const Time time{from_seconds(10.0 + way / 0.5)};
    drive.odometry.push_back({time, odom, {}, 0});
    drive.scans.push_back(scan_from(map, pose, time));
    drive.truth.push_back(pose);
    const Eigen::Vector2d to = corners[next] - pose.position();
    if (to.norm() < 0.6) next = (next + 1) % corners.size();
    const double wanted = std::atan2(to.y(), to.x());
    const double turn = std::clamp(turn_between(pose.heading, wanted), -0.3, 0.3);
    pose = pose * Pose2{kStepM, 0.0, turn};
    odom = odom * Pose2{kStepM, 0.0, turn + turn_bias_radpm * kStepM};
  }
  return drive;
}

/// What the map builder is given of it.
[[nodiscard]] inline Drive recorded(const RingDrive& ring, const MapBuilderConfig& config) {
  DriveLog log{config};
  for (std::size_t i = 0; i < ring.scans.size(); ++i) {
    log.add_odometry(ring.odometry[i]);
    log.add_scan(ring.scans[i]);
  }
  return log.take();
}

}  // namespace tandem::test
