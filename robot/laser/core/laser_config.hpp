#pragma once

#include <cstdint>
#include <string>

#include "services/common/config.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// config/<place>/robot/laser.toml
struct LaserConfig {
  std::string device = "tcp://127.0.0.1:10940";  ///< "tcp://HOST:PORT" or a serial port, "/dev/ttyACM0".
  std::string protocol = "scip";         ///< What the sensor speaks: "scip" (Hokuyo), "lms2xx" or "cola" (SICK).
  std::int64_t baud_rate = 0;            ///< The rate a serial line is set to; 0: as it is, with an LMS 2xx 38400.
  std::int64_t first_step = -1;          ///< Rightmost step to read; -1: the sensor's first.
  std::int64_t last_step = -1;           ///< Leftmost step to read; -1: the sensor's last.
  std::int64_t cluster = 3;              ///< So many steps make one beam, their least range.
  std::int64_t skip = 3;                 ///< Turns left out after each scan: 3 of 40 Hz makes 10 Hz.
  bool intensities = false;              ///< Ask for the strength of the echoes too.
  std::int64_t field_of_view_deg = 180;  ///< LMS 2xx: 180 or 100.
  double resolution_deg = 0.5;           ///< LMS 2xx: 1, 0.5, or with 100 degrees 0.25.
  std::string range_format = "keep";     ///< LMS 2xx: "8m", "32m", "80m"; a change is written to its flash.
  double range_max_m = 30.0;             ///< Beams beyond count as no return; the sensor's own limit holds as well.
  double scan_timeout_s = 1.0;           ///< Without a good scan for so long, the link is opened anew.
  double veil_angle_rad = 0.0;           ///< Points between two, nearly along their beam, are taken away; 0: none.
  double dirt_range_m = 0.0;  ///< A narrow spot as near as this that stays is dirt on the window; 0: none is.
  double mount_x_m = 0.16;    ///< The laser on the base.
  double mount_y_m = 0.0;
  double mount_heading_rad = 0.0;
  double clock_offset_s = 0.0;  ///< Added to every stamp, so that scans and wheels are of one time.

  [[nodiscard]] Pose2 base_from_laser() const { return {mount_x_m, mount_y_m, mount_heading_rad}; }

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("device", device);
    visitor.field("protocol", protocol, {"scip", "lms2xx", "cola"});
    visitor.field("baud_rate", baud_rate, Range{0, 1'000'000});
    visitor.field("first_step", first_step, Range{-1, 9999});
    visitor.field("last_step", last_step, Range{-1, 9999});
    visitor.field("cluster", cluster, Range{1, 99});
    visitor.field("skip", skip, Range{0, 9});
    visitor.field("intensities", intensities);
    visitor.field("field_of_view_deg", field_of_view_deg, Range{100, 180});
    visitor.field("resolution_deg", resolution_deg, Range{0.25, 1.0});
    visitor.field("range_format", range_format, {"keep", "8m", "32m", "80m"});
    visitor.field("range_max_m", range_max_m, Range{0.5, 200.0});
    visitor.field("scan_timeout_s", scan_timeout_s, Range{0.3, 10.0});
    visitor.field("veil_angle_rad", veil_angle_rad, Range{0.0, 0.5});
    visitor.field("dirt_range_m", dirt_range_m, Range{0.0, 0.15});
    visitor.field("mount_x_m", mount_x_m, Range{-2.0, 2.0});
    visitor.field("mount_y_m", mount_y_m, Range{-2.0, 2.0});
    visitor.field("mount_heading_rad", mount_heading_rad, Range{-3.15, 3.15});
    visitor.field("clock_offset_s", clock_offset_s, Range{-0.5, 0.5});
  }
};

}  // namespace tandem
