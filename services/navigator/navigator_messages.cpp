#include "services/navigator/navigator_messages.hpp"

#include <cmath>

#include "services/navigator/stop_words.hpp"

namespace tandem::navigator {
namespace {

PlanState plan_state(msg::PlanState state) {
  switch (state) {
    case msg::PLAN_PROPOSED:
      return PlanState::Proposed;
    case msg::PLAN_ACCEPTED:
      return PlanState::Accepted;
    case msg::PLAN_REJECTED:
      return PlanState::Rejected;
    case msg::PLAN_SUPERSEDED:
      return PlanState::Superseded;
  }
  return PlanState::Rejected;  // a value that is none of the contract's: when in doubt, do not move
}

PoseQuality pose_quality(msg::LocalizationStatus status) {
  switch (status) {
    case msg::LOCALIZATION_OK:
      return PoseQuality::Good;
    case msg::LOCALIZATION_UNCERTAIN:
      return PoseQuality::Uncertain;
    case msg::LOCALIZATION_LOST:
      return PoseQuality::Lost;
  }
  return PoseQuality::Lost;
}

Pose2 pose2(const msg::Pose& pose) {
  return {pose.x(), pose.y(), pose.heading()};
}

bool is_finite(const Pose2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading);
}

}  // namespace

PlanNews plan_news(const msg::TeamPlan& plan, const std::string& robot) {
  PlanNews news{.id = plan.id(),
                .session = plan.session(),
                .planner = plan.planner(),
                .sequence_number = plan.sequence_number(),
                .state = plan_state(plan.state()),
                .valid_until = from_stamp_ns(plan.valid_until_ns()),
                .points_in_map = {}};
  for (const auto& path : plan.paths()) {
    if (path.agent() != robot) continue;
    for (const auto& point : path.points()) {
      if (!std::isfinite(point.x_m()) || !std::isfinite(point.y_m())) {
        news.points_in_map.clear();  // half a path is none
        return news;
      }
      news.points_in_map.emplace_back(point.x_m(), point.y_m());
    }
  }
  return news;
}

LocatedPose located_pose(const msg::RobotPose& pose) {
  LocatedPose located;
  located.map_from_base = pose2(pose.map_from_base());
  located.quality = pose_quality(pose.status());
  located.stamp = from_stamp_ns(pose.stamp_ns());
  if (!is_finite(located.map_from_base)) {
    located.map_from_base = {};
    located.quality = PoseQuality::Lost;
  }
  return located;
}

ScanHits scan_hits(const msg::LaserScan& scan) {
  const Pose2 base_from_laser = pose2(scan.base_from_laser());
  ScanHits hits;
  hits.stamp = from_stamp_ns(scan.stamp_ns());
  hits.points_in_base.reserve(scan.ranges_m().size());
  for (std::size_t i = 0; i < scan.ranges_m().size(); ++i) {
    const double range = scan.ranges_m()[i];
    if (!(range >= scan.range_min_m() && range < scan.range_max_m())) continue;  // NaN fails both
    const double bearing = scan.angle_min_rad() + static_cast<double>(i) * scan.angle_increment_rad();
    hits.points_in_base.push_back(base_from_laser *
                                  Eigen::Vector2d{range * std::cos(bearing), range * std::sin(bearing)});
  }
  return hits;
}

Twist2 twist(const msg::Velocity2& velocity) {
  return {velocity.forward_mps(), velocity.left_mps(), velocity.turn_rate_radps()};
}

std::vector<WalkingPerson> walking_people(const msg::TrackedPeople& people) {
  std::vector<WalkingPerson> walking;
  for (const auto& person : people.people()) {
    walking.push_back({{person.position_in_map().x(), person.position_in_map().y()},
                       {person.velocity_in_map_mps().x(), person.velocity_in_map_mps().y()}});
  }
  return walking;
}

BaseReport base_report(const msg::BaseStatus& status) {
  BaseReport report;
  if (!status.stop_reasons().empty()) {
    const msg::StopReason first = status.stop_reasons().front();
    report = {words_of(first), first == msg::STOP_OBSTACLE};
  } else if (status.latched()) {
    report = {"waiting to be resumed", false};
  } else if (status.resume_in_s() > 0.0) {
    report = {"about to move", false};
  }
  return report;
}

std::optional<std::string> running_session(const msg::SessionState& session) {
  if (session.phase() != msg::SESSION_RUNNING) return std::nullopt;
  return session.code();
}

msg::VelocityCommand velocity_command(const Twist2& velocity, const std::string& robot, Time now,
                                      std::uint64_t sequence_number) {
  msg::VelocityCommand command;
  command.robot(robot);
  command.stamp_ns(to_stamp_ns(now));
  command.sequence_number(sequence_number);
  command.commander("navigator");
  command.forward_mps(velocity.forward_mps);
  command.turn_rate_radps(velocity.turn_rate_radps);
  return command;
}

msg::PlanExecution plan_execution(const Execution& execution, const std::string& robot, Time now) {
  msg::PlanExecution message;
  message.robot(robot);
  message.plan_id(execution.plan_id);
  message.stamp_ns(to_stamp_ns(now));
  message.progress(execution.progress);
  message.moving(execution.moving);
  message.finished(execution.finished);
  message.blocked(execution.blocked);
  message.blocked_at_in_map().x(execution.blocked_at_in_map.x());
  message.blocked_at_in_map().y(execution.blocked_at_in_map.y());
  message.reason(execution.reason);
  return message;
}

}  // namespace tandem::navigator
