#pragma once

#include <cstdint>
#include <optional>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "robot/safety/core/swept_path.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// What the base says of itself.
struct BaseInput {
  bool connected = false;       ///< it answers now
  bool motors_enabled = false;  ///< in fact
  bool estop_pressed = false;
  bool left_stalled = false;
  bool right_stalled = false;
  std::uint32_t front_bumpers = 0;
  std::uint32_t rear_bumpers = 0;
  double battery_v = 0.0;  ///< 0 unknown
  Pose2 odom_from_base;
  std::uint32_t odometry_epoch = 0;
  bool odometry_jumped = false;    ///< the driver rejected an impossible step since the last cycle
  Motion measured;                 ///< by the wheels
  double watchdog_s = 0.0;         ///< of the firmware; 0 unknown
  double deceleration_mps2 = 0.0;  ///< read back; 0 unknown
};

/// Judges the base: does it answer, is it blocked, does it move as it was told?
class MotionMonitor {
 public:
  explicit MotionMonitor(const GateConfig& config) : config_(config) {}

  /// Takes the state of the base at `now`; `commanded` is what the gate let through in the last cycle.
  Causes step(const BaseInput& base, const Motion& commanded, Time now);
  /// Smoothed voltage; none while it is unknown.
  [[nodiscard]] std::optional<double> battery_v() const { return battery_v_; }
  /// How far the robot has gone backwards and not forwards again [m].
  [[nodiscard]] double reversed_m() const { return reversed_m_; }

 private:
  [[nodiscard]] bool wheels_stand_still_when_told_to_turn(const BaseInput& base, const Motion& commanded, Time now);
  void follow_pose(const BaseInput& base, Causes& causes);
  void follow_battery(const BaseInput& base, Time now);

  const GateConfig& config_;
  bool was_connected_ = false;
  std::optional<Pose2> last_pose_;
  std::uint32_t last_epoch_ = 0;
  std::optional<Time> dead_since_;
  Pose2 dead_at_;
  std::optional<Time> too_fast_since_;
  std::optional<double> battery_v_;
  Time last_step_{};
  double reversed_m_ = 0.0;
};

}  // namespace tandem::safety
