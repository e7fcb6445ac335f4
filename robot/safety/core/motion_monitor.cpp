#include "robot/safety/core/motion_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::safety {
namespace {

constexpr double kJump_m = 0.5;
constexpr double kOverspeedFactor = 1.5;
constexpr double kOverspeedFor_s = 0.2;
constexpr double kDeadFor_s = 0.9;  ///< and a report and a cycle make a second
constexpr double kCertainlyTold_mps = 0.1;
constexpr double kCertainlyTold_radps = 0.2;
constexpr double kStill_m = 0.02;
constexpr double kStill_rad = 0.04;

}  // namespace

Causes MotionMonitor::step(const BaseInput& base, const Motion& commanded, Time now) {
  Causes causes;
  causes.set(index_of(Cause::BaseLost), was_connected_ && !base.connected);
  causes.set(index_of(Cause::BaseNotThere), !was_connected_ && !base.connected);
  was_connected_ = was_connected_ || base.connected;
  if (base.connected) {
    causes.set(index_of(Cause::EmergencyStop), base.estop_pressed);
    causes.set(index_of(Cause::Bumper), base.front_bumpers != 0 || base.rear_bumpers != 0);
    causes.set(index_of(Cause::Stall), base.left_stalled || base.right_stalled);
    follow_pose(base, causes);
    const double too_fast_mps = kOverspeedFactor * config_.max_speed_mps;
    const bool too_fast = !(std::abs(base.measured.forward_mps) <= too_fast_mps);
    if (!too_fast) too_fast_since_.reset();
    if (too_fast && !too_fast_since_) too_fast_since_ = now;
    causes.set(index_of(Cause::Overspeed), too_fast && to_seconds(now - *too_fast_since_) > kOverspeedFor_s);
    causes.set(index_of(Cause::EncoderDead), wheels_stand_still_when_told_to_turn(base, commanded, now));
    follow_battery(base, now);
  }
  causes.set(index_of(Cause::LowBattery), battery_v_ && *battery_v_ < config_.battery_stop_v);
  last_step_ = now;
  return causes;
}

bool MotionMonitor::wheels_stand_still_when_told_to_turn(const BaseInput& base, const Motion& commanded, Time now) {
  // By the counted way: a controller that repeats its last report would go on telling a speed.
  const bool told = base.motors_enabled && (std::abs(commanded.forward_mps) >= kCertainlyTold_mps ||
                                            std::abs(commanded.turn_rate_radps) >= kCertainlyTold_radps);
  const Pose2 step = inverse(dead_at_) * base.odom_from_base;
  const bool moved = !(std::hypot(step.x, step.y) <= kStill_m && std::abs(step.heading) <= kStill_rad);
  if (!told || (dead_since_ && moved)) {
    dead_since_.reset();
    return false;
  }
  if (!dead_since_) {
    dead_since_ = now;
    dead_at_ = base.odom_from_base;
  }
  return to_seconds(now - *dead_since_) > kDeadFor_s;
}

void MotionMonitor::follow_pose(const BaseInput& base, Causes& causes) {
  const bool finite = std::isfinite(base.odom_from_base.x) && std::isfinite(base.odom_from_base.y) &&
                      std::isfinite(base.odom_from_base.heading);
  causes.set(index_of(Cause::OdometryJump), base.odometry_jumped || !finite);
  if (!finite) return;
  if (last_pose_ && last_epoch_ == base.odometry_epoch) {
    const Pose2 step = inverse(*last_pose_) * base.odom_from_base;
    if (std::hypot(step.x, step.y) > kJump_m) causes.set(index_of(Cause::OdometryJump));
    reversed_m_ = std::clamp(reversed_m_ - step.x, 0.0, 1.0);
  }
  last_pose_ = base.odom_from_base;
  last_epoch_ = base.odometry_epoch;
}

void MotionMonitor::follow_battery(const BaseInput& base, Time now) {
  if (!(base.battery_v > 0.0)) return;
  const double share = std::clamp(to_seconds(now - last_step_) / config_.battery_filter_s, 0.0, 1.0);
  battery_v_ = battery_v_ ? *battery_v_ + share * (base.battery_v - *battery_v_) : base.battery_v;
}

}  // namespace tandem::safety
