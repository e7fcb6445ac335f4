#pragma once

#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "services/common/pose2.hpp"

namespace tandem::pioneer {

/// How one model of robot counts and how large it is.
struct RobotParameters {
  std::string_view subclass;        ///< as the SYNC2 reply names it
  double metres_per_count = 0.001;  ///< odometry (DistConvFactor)
  double metres_per_range = 0.001;  ///< sonar (RangeConvFactor)
  double half_track_per_m = 3.4;    ///< (right - left) / 2 [m/s] times this is the turn rate [rad/s] (DiffConvFactor)
  double radius_m = 0.5;
  double length_m = 0.626;
  double width_m = 0.505;
  double max_speed_mps = 1.2;
  double max_turn_rate_radps = 5.2;
  int sonars = 16;
  double laser_x_m = 0.0;  ///< 0, 0 where none is mounted
  double laser_y_m = 0.0;
  double radians_per_count = 2.0 * std::numbers::pi / 4096.0;
  double mps_per_count = 0.001;    ///< wheel velocities (VelConvFactor)
  int wheel_speed_step_mmps = 20;  ///< unit of VEL2
  bool skid_steer = false;         ///< four driven wheels: its heading depends on the floor
};

/// Every model we know.
[[nodiscard]] std::span<const RobotParameters> all_robot_parameters();

/// Where the sonars sit on the base, numbered clockwise from the front left; empty where nobody told us.
[[nodiscard]] std::span<const Pose2> sonar_poses(const RobotParameters& parameters);

/// The parameters of `subclass` in any case; null for a robot nobody told us of.
[[nodiscard]] const RobotParameters* robot_parameters(std::string_view subclass);

}  // namespace tandem::pioneer
