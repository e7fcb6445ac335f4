#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/pioneer/core/odometry.hpp"
#include "robot/safety/core/gate_config.hpp"
#include "services/common/config.hpp"

namespace tandem {

/// config/<place>/robot/base.toml: the device, the robot's own measures, and the safety gate.
struct BaseConfig {
  std::string device = "tcp://127.0.0.1:8101";                        ///< "tcp://HOST:PORT" or "/dev/..."
  std::vector<double> baud_rates{9600, 38400, 19200, 115200, 57600};  ///< tried in turn on a serial port
  bool sonar = true;
  double metres_per_count = 0.0;  ///< 0: as the model's published parameters say.
  double half_track_per_m = 0.0;  ///< 0: likewise.
  WheelCorrection wheels;         ///< From calibration: left_wheel_scale, right_wheel_scale, track_scale.
  std::string map;                ///< Whose areas.json has the hard zones, absolute or relative to this file; "": none.
  /// Mask of digital inputs that count as the emergency stop while they are high: a button wired to the I/O port.
  std::int64_t stop_inputs = 0;
  std::string marker_file;  ///< Exists while the motors may be on: tells a start after a crash. Empty: none.
  pioneer::OdometryNoise odometry;
  safety::GateConfig gate;

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("device", device);
    visitor.field("baud_rates", baud_rates, Range{300, 1'000'000});
    visitor.field("sonar", sonar);
    visitor.field("metres_per_count", metres_per_count, Range{0.0, 0.01});
    visitor.field("half_track_per_m", half_track_per_m, Range{0.0, 20.0});
    wheels.visit_fields(visitor);
    visitor.field("map", map);
    visitor.field("stop_inputs", stop_inputs, Range{0, 255});
    visitor.field("marker_file", marker_file);
    odometry.visit_fields(visitor);
    gate.visit_fields(visitor);
  }
};

}  // namespace tandem
