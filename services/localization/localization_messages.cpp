#include "services/localization/localization_messages.hpp"

#include <cmath>

namespace tandem {
namespace {

Pose2 to_pose(const msg::Pose& pose) {
  return {pose.x(), pose.y(), wrap_to_pi(pose.heading())};
}

msg::Pose to_message(const Pose2& pose) {
  msg::Pose message;
  message.x(pose.x);
  message.y(pose.y);
  message.heading(pose.heading);
  return message;
}

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

msg::LocalizationStatus to_message(LocalizationStatus status) {
  switch (status) {
    case LocalizationStatus::Ok:
      return msg::LOCALIZATION_OK;
    case LocalizationStatus::Uncertain:
      return msg::LOCALIZATION_UNCERTAIN;
    case LocalizationStatus::Lost:
      break;
  }
  return msg::LOCALIZATION_LOST;
}

}  // namespace

std::optional<OdometrySample> from_message(const msg::Odometry& message) {
  const msg::Velocity2& v = message.velocity();
  const OdometrySample sample{.time = from_stamp_ns(message.stamp_ns()),
                              .odom_from_base = to_pose(message.odom_from_base()),
                              .velocity = {v.forward_mps(), v.left_mps(), v.turn_rate_radps()},
                              .epoch = static_cast<int>(message.epoch())};
  const bool finite = is_finite(sample.odom_from_base) && std::isfinite(v.forward_mps()) &&
                      std::isfinite(v.left_mps()) && std::isfinite(v.turn_rate_radps());
  if (!finite) return std::nullopt;
  return sample;
}

std::optional<LaserScan> from_message(const msg::LaserScan& message) {
  const LaserScan scan{.time = from_stamp_ns(message.stamp_ns()),
                       .base_from_laser = to_pose(message.base_from_laser()),
                       .angle_min_rad = message.angle_min_rad(),
                       .angle_increment_rad = message.angle_increment_rad(),
                       .beam_interval_s = message.beam_interval_s(),
                       .range_min_m = message.range_min_m(),
                       .range_max_m = message.range_max_m(),
                       .ranges_m = message.ranges_m()};
  const bool finite = is_finite(scan.base_from_laser) && std::isfinite(scan.angle_min_rad) &&
                      std::isfinite(scan.angle_increment_rad) && std::isfinite(scan.beam_interval_s);
  if (!finite) return std::nullopt;
  return scan;
}

std::optional<PoseHint> from_message(const msg::PoseHint& message) {
  const PoseHint hint{.time = from_stamp_ns(message.stamp_ns()),
                      .map_from_base = to_pose(message.map_from_base()),
                      .heading_known = message.heading_known(),
                      .standard_deviation_m = message.standard_deviation_m()};
  if (!is_finite(hint.map_from_base) || !(hint.standard_deviation_m >= 0.0 && hint.standard_deviation_m <= 100.0)) {
    return std::nullopt;
  }
  return hint;
}

msg::RobotPose to_message(const LocalizationResult& result, const std::string& robot) {
  msg::RobotPose message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(result.time));
  message.odometry_epoch(static_cast<std::uint32_t>(result.odometry_epoch));
  message.map_from_base(to_message(result.map_from_base));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      message.covariance()[static_cast<std::size_t>(3 * row + column)] = result.covariance(row, column);
    }
  }
  message.agreement(result.agreement);
  message.status(to_message(result.status));
  for (const PoseHypothesis& hypothesis : result.hypotheses) {
    msg::PoseHypothesis one;
    one.map_from_base(to_message(hypothesis.map_from_base));
    one.weight(hypothesis.weight);
    message.hypotheses().push_back(one);
  }
  return message;
}

msg::RobotPose no_pose(Time time, const std::string& robot) {
  LocalizationResult nothing;
  nothing.time = time;
  return to_message(nothing, robot);
}

}  // namespace tandem
