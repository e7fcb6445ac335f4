#include "services/tracking/tracking_messages.hpp"

#include <cmath>

namespace tandem::tracking {
namespace {

Pose2 pose2(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}

msg::Pose pose(const Pose2& value) {
  msg::Pose message;
  message.x(value.x);
  message.y(value.y);
  message.heading(value.heading);
  return message;
}

msg::Point2 point(const Eigen::Vector2d& value) {
  msg::Point2 message;
  message.x(value.x());
  message.y(value.y());
  return message;
}

msg::PoseSource pose_source(Source source) {
  switch (source) {
    case Source::Laser:
      return msg::SOURCE_LASER;
    case Source::Message:
      return msg::SOURCE_MESSAGE;
    case Source::Predicted:
      return msg::SOURCE_PREDICTED;
  }
  return msg::SOURCE_PREDICTED;
}

}  // namespace

LaserScan laser_scan(const msg::LaserScan& scan) {
  return {.stamp = from_stamp_ns(scan.stamp_ns()),
          .angle_min_rad = scan.angle_min_rad(),
          .angle_increment_rad = scan.angle_increment_rad(),
          .beam_interval_s = scan.beam_interval_s(),
          .range_min_m = scan.range_min_m(),
          .range_max_m = scan.range_max_m(),
          .ranges_m = scan.ranges_m(),
          .base_from_laser = pose2(scan.base_from_laser())};
}

std::optional<OccupancyGrid> occupancy_grid(const msg::OccupancyGrid& map) {
  const auto cells = static_cast<std::size_t>(map.width()) * map.height();
  if (cells == 0 || map.cells().size() != cells || !(map.resolution_m() > 0.0)) return std::nullopt;
  OccupancyGrid grid{static_cast<int>(map.width()), static_cast<int>(map.height()), map.resolution_m(),
                     pose2(map.map_from_grid())};
  for (std::size_t i = 0; i < cells; ++i) {
    switch (map.cells()[i]) {
      case 0:
        grid.cells()[i] = CellState::Free;
        break;
      case 100:
        grid.cells()[i] = CellState::Occupied;
        break;
      default:
        grid.cells()[i] = CellState::Unknown;
        break;
    }
  }
  return grid;
}

std::optional<Pose2> usable_pose(const msg::RobotPose& message) {
  const Pose2 value = pose2(message.map_from_base());
  if (message.status() == msg::LOCALIZATION_LOST) return std::nullopt;
  if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.heading)) return std::nullopt;
  return value;
}

PoseMessage pose_message(const msg::HumanMessage& message) {
  PoseMessage result{.stamp = from_stamp_ns(message.stamp_ns()),
                     .point_in_map = {message.point_in_map().x(), message.point_in_map().y()},
                     .heading = std::nullopt};
  if (message.heading_known() && std::isfinite(message.heading())) result.heading = message.heading();
  return result;
}

std::vector<Eigen::Vector2d> accepted_path(const msg::TeamPlan& plan, const std::string& agent) {
  std::vector<Eigen::Vector2d> points;
  if (plan.state() != msg::PLAN_ACCEPTED) return points;
  for (const auto& path : plan.paths()) {
    if (path.agent() != agent) continue;
    for (const auto& one : path.points()) {
      if (std::isfinite(one.x_m()) && std::isfinite(one.y_m())) points.emplace_back(one.x_m(), one.y_m());
    }
  }
  return points;
}

msg::TrackedPeople tracked_people(const std::vector<Track>& tracks, const std::string& robot, Time stamp,
                                  const Pose2& map_from_base) {
  msg::TrackedPeople message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(stamp));
  message.map_from_base(pose(map_from_base));
  for (const Track& track : tracks) {
    if (!track.person) continue;
    msg::TrackedPerson person;
    person.track_id(track.id);
    person.position_in_map(point(track.motion.position()));
    person.velocity_in_map_mps(point(track.motion.velocity()));
    person.standard_deviation_m(track.motion.standard_deviation_m());
    message.people().push_back(person);
  }
  return message;
}

msg::TeammateState teammate_state(const TeammateEstimate& estimate, const std::string& agent,
                                  const std::string& robot) {
  msg::TeammateState message;
  message.agent(agent);
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(estimate.stamp));
  message.map_from_agent(pose(estimate.map_from_agent));
  const double variance = estimate.standard_deviation_m * estimate.standard_deviation_m;
  message.covariance() = {variance, 0.0,      0.0,
                          0.0,      variance, 0.0,
                          0.0,      0.0,      estimate.heading_deviation_rad * estimate.heading_deviation_rad};
  message.velocity().forward_mps(estimate.velocity_in_map_mps.x());
  message.velocity().left_mps(estimate.velocity_in_map_mps.y());
  message.source(pose_source(estimate.source));
  message.state(estimate.lost ? msg::TRACK_LOST : msg::TRACK_TRACKED);
  message.age_s(estimate.age_s);
  return message;
}

}  // namespace tandem::tracking
