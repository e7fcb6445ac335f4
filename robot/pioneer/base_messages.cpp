#include "robot/pioneer/base_messages.hpp"

#include <algorithm>

namespace tandem {
namespace {

// The gate's reasons are those of the contract, in the same order.
static_assert(static_cast<int>(safety::StopReason::None) == msg::STOP_NONE);
static_assert(static_cast<int>(safety::StopReason::Obstacle) == msg::STOP_OBSTACLE);
static_assert(static_cast<int>(safety::StopReason::LinkLost) == msg::STOP_LINK_LOST);
static_assert(static_cast<int>(safety::StopReason::TwoCommanders) == msg::STOP_TWO_COMMANDERS);

msg::Pose to_message(const Pose2& pose) {
  msg::Pose message;
  message.x(pose.x);
  message.y(pose.y);
  message.heading(pose.heading);
  return message;
}

std::vector<msg::StopReason> reasons_of(const safety::Causes& causes) {
  std::vector<msg::StopReason> reasons;
  for (const auto& rule : safety::kStopRules) {
    if (!causes.test(index_of(rule.cause))) continue;
    const auto reason = static_cast<msg::StopReason>(rule.reason);
    if (std::find(reasons.begin(), reasons.end(), reason) == reasons.end()) reasons.push_back(reason);
  }
  return reasons;
}

}  // namespace

Pose2 from_message(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}

msg::Odometry to_message(const pioneer::OdometryState& state, const std::string& robot, Time stamp) {
  msg::Odometry message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(stamp));
  message.epoch(state.epoch);
  message.odom_from_base(to_message(state.odom_from_base));
  message.velocity().forward_mps(state.velocity.forward_mps);
  message.velocity().left_mps(state.velocity.left_mps);
  message.velocity().turn_rate_radps(state.velocity.turn_rate_radps);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      message.covariance()[static_cast<std::size_t>(3 * row + column)] = state.covariance(row, column);
    }
  }
  return message;
}

msg::SonarRanges sonar_message(const pioneer::Sip& sip, const pioneer::RobotParameters& parameters,
                               const std::string& robot, Time stamp) {
  msg::SonarRanges message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(stamp));
  for (const auto& echo : sip.sonar) {
    msg::SonarReading reading;
    reading.index(echo.number);
    reading.range_m(echo.range * parameters.metres_per_range);
    message.readings().push_back(reading);
  }
  return message;
}

msg::BaseStatus to_message(const BaseStatusParts& parts, const std::string& robot, Time stamp) {
  const auto& [base, decision, model] = parts;
  msg::BaseStatus message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(stamp));
  message.connected(base.connected);
  message.motors_enabled(base.motors_enabled);
  message.estop_pressed(base.estop_pressed);
  message.left_stalled(base.left_stalled);
  message.right_stalled(base.right_stalled);
  message.front_bumpers(base.front_bumpers);
  message.rear_bumpers(base.rear_bumpers);
  message.battery_v(base.battery_v);
  message.speed_limit_mps(decision.speed_limit_mps);
  message.stop_reasons(reasons_of(decision.causes));
  message.latched(decision.latched);
  message.resume_in_s(decision.resume_in_s);
  message.model(model);
  message.watchdog_ms(static_cast<std::uint32_t>(base.watchdog_s * 1000.0 + 0.5));
  return message;
}

safety::CommandSample from_message(const msg::VelocityCommand& message, const safety::CommanderId& commander) {
  return {.commander = commander,
          .kind = message.commander() == "teleop" ? safety::CommanderKind::Operator : safety::CommanderKind::Program,
          .sequence_number = message.sequence_number(),
          .motion = {message.forward_mps(), message.turn_rate_radps()}};
}

safety::ScanView view_of(const msg::LaserScan& message) {
  return {.sequence_number = message.sequence_number(),
          .stamp = from_stamp_ns(message.stamp_ns()),
          .base_from_laser = from_message(message.base_from_laser()),
          .angle_min_rad = message.angle_min_rad(),
          .angle_increment_rad = message.angle_increment_rad(),
          .range_min_m = message.range_min_m(),
          .range_max_m = message.range_max_m(),
          .ranges_m = message.ranges_m()};
}

}  // namespace tandem
