#pragma once

#include <cstdint>
#include <string>

#include "services/common/config.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// config/<place>/robot/laser.toml
struct LaserConfig {
  std::string device = "tcp://127.0.0.1:10940";  ///< "tcp://HOST:PORT" or a serial port, "/dev/ttyACM0".
  std::int64_t first_step = -1;                  ///< Rightmost step to read; -1: the sensor's first.
  std::int64_t last_step = -1;                   ///< Leftmost step to read; -1: the sensor's last.
  std::int64_t cluster = 3;                      ///< So many steps make one beam, their least range.
  std::int64_t skip = 3;                         ///< Turns left out after each scan: 3 of 40 Hz makes 10 Hz.
  bool intensities = false;                      ///< Ask for the strength of the echoes too.
  double range_max_m = 30.0;    ///< Beams beyond count as no return; the sensor's own limit holds as well.
  double scan_timeout_s = 1.0;  ///< Without a good scan for so long, the link is opened anew.
  double mount_x_m = 0.16;      ///< The laser on the base.
  double mount_y_m = 0.0;
  double mount_heading_rad = 0.0;
  double clock_offset_s = 0.0;  ///< Added to every stamp, so that scans and wheels are of one time.

  [[nodiscard]] Pose2 base_from_laser() const { return {mount_x_m, mount_y_m, mount_heading_rad}; }

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("device", device);
    visitor.field("first_step", first_step, Range{-1, 9999});
    visitor.field("last_step", last_step, Range{-1, 9999});
    visitor.field("cluster", cluster, Range{1, 99});
    visitor.field("skip", skip, Range{0, 9});
    visitor.field("intensities", intensities);
    visitor.field("range_max_m", range_max_m, Range{0.5, 200.0});
    visitor.field("scan_timeout_s", scan_timeout_s, Range{0.3, 10.0});
    visitor.field("mount_x_m", mount_x_m, Range{-2.0, 2.0});
    visitor.field("mount_y_m", mount_y_m, Range{-2.0, 2.0});
    visitor.field("mount_heading_rad", mount_heading_rad, Range{-3.15, 3.15});
    visitor.field("clock_offset_s", clock_offset_s, Range{-0.5, 0.5});
  }
};

}  // namespace tandem
