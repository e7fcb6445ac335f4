#include "gateway/server/gateway_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "services/common/angle.hpp"

namespace tandem::gateway {
namespace {

constexpr double kWeakLoss = 0.2;
constexpr double kWeakRoundTripS = 0.25;

/// `value` if it is a number a phone can use, else `otherwise`.
double finite(double value, double otherwise = 0.0) {
  return std::isfinite(value) ? value : otherwise;
}

double share(double value) {
  return std::clamp(finite(value), 0.0, 1.0);
}

std::string short_text(const std::string& text) {
  return text.substr(0, 300);
}

template <std::size_t kCount>
std::string word(const std::array<const char*, kCount>& words, std::uint32_t index) {
  return words[std::min<std::size_t>(index, kCount - 1)];
}

constexpr std::array<const char*, 18> kStopReasons{
    "none",      "not_enabled", "requested", "estop",         "bumper",      "stall",
    "obstacle",  "stale_scan",  "bad_scan",  "stale_command", "bad_command", "stale_pose",
    "lost_pose", "link_lost",   "base_lost", "odometry_jump", "low_battery", "two_commanders"};

msg::HumanMessageKind human_kind(protocol::CommandKind kind) {
  switch (kind) {
    case protocol::CommandKind::MyPose:
      return msg::HUMAN_MY_POSE;
    case protocol::CommandKind::MyGoal:
      return msg::HUMAN_MY_GOAL;
    case protocol::CommandKind::RobotGoal:
      return msg::HUMAN_ROBOT_GOAL;
    case protocol::CommandKind::ClearMyGoal:
      return msg::HUMAN_CLEAR_MY_GOAL;
    case protocol::CommandKind::ClearRobotGoal:
      return msg::HUMAN_CLEAR_ROBOT_GOAL;
    default:
      return msg::HUMAN_REPLAN;
  }
}

msg::Point2 to_point(const protocol::Command& command) {
  msg::Point2 point;
  const protocol::Point at = command.point_in_map.value_or(protocol::Point{});
  point.x(at.x);
  point.y(at.y);
  return point;
}

}  // namespace

protocol::RobotState to_phone(const msg::RobotPose& pose, Duration age) {
  return {.position = {finite(pose.map_from_base().x()), finite(pose.map_from_base().y())},
          .heading = wrap_to_pi(finite(pose.map_from_base().heading())),
          .status = word(std::array{"ok", "uncertain", "lost"}, pose.status()),
          .age_s = std::max(0.0, to_seconds(age))};
}

protocol::PersonState to_phone(const msg::TeammateState& person, Duration age) {
  return {.position = {finite(person.map_from_agent().x()), finite(person.map_from_agent().y())},
          .heading = wrap_to_pi(finite(person.map_from_agent().heading())),
          .source = word(std::array{"laser", "message", "predicted"}, person.source()),
          .tracked = person.state() == msg::TRACK_TRACKED,
          .age_s = std::max(0.0, finite(person.age_s()) + to_seconds(age))};
}

protocol::PlannerState to_phone(const msg::PlannerStatus& status) {
  return {.activity = word(std::array{"idle", "computing", "failed", "finished"}, status.activity()),
          .computing_s = std::max(0.0, finite(status.computing_s())),
          .progress = share(status.progress()),
          .reason = short_text(status.reason())};
}

protocol::LinkState to_phone(const msg::LinkStatus& status) {
  const bool weak = finite(status.loss()) > kWeakLoss || finite(status.round_trip_s()) > kWeakRoundTripS;
  return {.quality = !status.up()       ? "lost"
                     : status.one_way() ? "one_way"
                     : weak             ? "weak"
                                        : "good",
          .round_trip_ms = std::max(0.0, 1000.0 * finite(status.round_trip_s()))};
}

protocol::Plan to_phone(const msg::TeamPlan& plan) {
  protocol::Plan out{
      .id = plan.id().substr(0, 128),
      .state = word(std::array{"proposed", "accepted", "rejected", "superseded"}, plan.state()),
      .role = word(std::array{"leader_follower", "peer_peer", "master_slave", "leader_leader"}, plan.role()),
      .reason = short_text(plan.reason()),
      .probability_found = share(plan.probability_found()),
      .paths = {}};
  for (const auto& path : plan.paths()) {
    protocol::Path one{.agent = path.agent(),
                       .points = {},
                       .goal = {finite(path.goal_in_map().x()), finite(path.goal_in_map().y())},
                       .goal_fixed = path.goal_fixed()};
    for (const auto& at : path.points()) {
      const double time_s = static_cast<double>(at.stamp_ns() - plan.stamp_ns()) * 1e-9;
      one.points.push_back({std::round(time_s * 100.0) / 100.0, {finite(at.x_m()), finite(at.y_m())}});
    }
    out.paths.push_back(std::move(one));
  }
  return out;
}

protocol::Map to_phone(const msg::OccupancyGrid& grid) {
  protocol::Map map{.id = grid.map_id().substr(0, 128),
                    .resolution_m = grid.resolution_m(),
                    .width = grid.width(),
                    .height = grid.height(),
                    .origin = {finite(grid.map_from_grid().x()), finite(grid.map_from_grid().y())},
                    .heading = wrap_to_pi(finite(grid.map_from_grid().heading())),
                    .runs = {}};
  for (const std::uint8_t cell : grid.cells()) {
    if (map.runs.empty() || map.runs.back().value != cell) map.runs.push_back({0, cell});
    ++map.runs.back().count;
  }
  return map;
}

protocol::BeliefGrid to_phone(const msg::SearchBelief& belief, std::uint32_t revision) {
  return {.width = static_cast<std::uint16_t>(std::min<std::uint32_t>(belief.width(), 65535)),
          .height = static_cast<std::uint16_t>(std::min<std::uint32_t>(belief.height(), 65535)),
          .resolution_m = static_cast<float>(belief.resolution_m()),
          .x0_m = static_cast<float>(belief.origin_in_map().x()),
          .y0_m = static_cast<float>(belief.origin_in_map().y()),
          .revision = revision,
          .cells = {belief.cells().begin(), belief.cells().end()}};
}

protocol::BaseState to_phone(const msg::BaseStatus* base, const msg::PlanExecution* execution) {
  protocol::BaseState state;
  if (base != nullptr) {
    state.connected = base->connected();
    state.latched = base->latched();
    for (const auto reason : base->stop_reasons()) state.stop_reasons.push_back(word(kStopReasons, reason));
    state.resume_in_s = std::max(0.0, finite(base->resume_in_s()));
    state.battery_v = std::clamp(finite(base->battery_v()), 0.0, 1000.0);
  }
  if (execution != nullptr) {
    state.moving = execution->moving();
    state.blocked = execution->blocked();
    state.waits_for = short_text(execution->reason());
  }
  return state;
}

protocol::Session to_phone(const msg::SessionState* session) {
  protocol::Session shown;
  if (session == nullptr) return shown;
  shown.phase = word(std::array{"preparing", "running", "ended"}, session->phase());
  if (session->mode() == "human_human") shown.mode = session->mode();
  for (const char* kind : {"toast", "popup", "multimodal", "counters"}) {
    if (session->reminder() == kind) shown.reminder.kind = kind;
  }
  return shown;
}

msg::HumanMessage to_human_message(const protocol::Command& command, const Sender& sender,
                                   std::uint64_t sequence_number) {
  msg::HumanMessage message;
  message.agent(sender.agent);
  message.robot(sender.robot);
  message.id(sender.id);
  message.sequence_number(sequence_number);
  message.stamp_ns(to_stamp_ns(sender.pressed));
  message.kind(human_kind(command.kind));
  message.point_in_map(to_point(command));
  message.heading_known(command.heading.has_value());
  message.heading(wrap_to_pi(command.heading.value_or(0.0)));
  return message;
}

msg::PoseHint to_pose_hint(const protocol::Command& command, const Sender& sender) {
  msg::PoseHint hint;
  hint.robot(sender.robot);
  hint.id(sender.id);
  hint.stamp_ns(to_stamp_ns(sender.pressed));
  hint.who("phone:" + sender.agent);
  msg::Pose pose;
  pose.x(to_point(command).x());
  pose.y(to_point(command).y());
  pose.heading(wrap_to_pi(command.heading.value_or(0.0)));
  hint.map_from_base(pose);
  hint.heading_known(command.heading.has_value());
  hint.standard_deviation_m(0.5);  // a finger on a small map
  return hint;
}

msg::ObjectDetection to_detection(const protocol::Command& command, const Sender& sender) {
  msg::ObjectDetection detection;
  detection.robot(sender.robot);
  detection.id(sender.id);
  detection.stamp_ns(to_stamp_ns(sender.pressed));
  detection.detected_by(sender.agent);
  detection.point_in_map(to_point(command));
  detection.covariance_m2({0.25, 0.0, 0.0, 0.25});  // half a metre: a finger on a small map
  detection.confidence(1.0);
  return detection;
}

msg::StopRequest to_stop_request(const Sender& sender) {
  msg::StopRequest request;
  request.robot(sender.robot);
  request.id(sender.id);
  request.stamp_ns(to_stamp_ns(sender.pressed));
  request.who("phone:" + sender.agent);
  request.latched(true);
  return request;
}

msg::ResumeRequest to_resume_request(const protocol::Command& command, const Sender& sender) {
  msg::ResumeRequest request;
  request.robot(sender.robot);
  request.id(sender.id);
  request.stamp_ns(to_stamp_ns(sender.pressed));
  request.who("phone:" + sender.agent);
  request.held_ms(static_cast<std::uint32_t>(command.held_ms));
  return request;
}

}  // namespace tandem::gateway
