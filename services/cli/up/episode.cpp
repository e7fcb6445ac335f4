#include "services/cli/up/episode.hpp"

#include <algorithm>

#include "services/cli/team_words.hpp"

namespace tandem::cli {
namespace {

/// Appends `point` if it is a step away from the last, and returns the length of that step [m].
double extend(std::vector<Eigen::Vector2d>& track, const Eigen::Vector2d& point) {
  constexpr double kStep_m = 0.1;
  if (track.empty()) {
    track.push_back(point);
    return 0.0;
  }
  const double step_m = (point - track.back()).norm();
  if (step_m < kStep_m) return 0.0;
  track.push_back(point);
  return step_m;
}

}  // namespace

Episode::Episode(bus::Bus& laptop, const SiteConfig& site, EpisodePlan plan, const OccupancyGrid& map)
    : bus_(laptop),
      site_(site),
      plan_(std::move(plan)),
      began_(laptop.clock().now()),
      sessions_(laptop.writer(topic::kSession)),
      told_sessions_(laptop.latest(topic::kSession)),
      hints_(laptop, topic::kPoseHint),
      health_(laptop.latest(topic::kServiceHealth)),
      robot_pose_(laptop.latest(topic::kRobotPose)),
      teammates_(laptop.latest(topic::kTeammates)),
      team_plan_(laptop.latest(topic::kTeamPlan)),
      belief_(laptop.latest(topic::kBelief)),
      base_status_(laptop.latest(topic::kBaseStatus)),
      execution_(laptop.latest(topic::kPlanExecution)),
      link_(laptop.latest(topic::kLinkStatus)),
      detections_(laptop.in_order(topic::kDetection)),
      human_messages_(laptop.in_order(topic::kHumanMessage)) {
  view_.map = map;
  view_.limit_s = plan_.limit_s;
  session_.robot(site.robot);
  session_.agent(site.agent);
  session_.code(plan_.session_code);
  session_.condition(plan_.condition);
  session_.reminder(plan_.reminder);
  session_.mode(plan_.mode);
  session_.phase(msg::SESSION_PREPARING);
  publish_session();
}

void Episode::step() {
  observe();
  hints_.step();
  const Time now = bus_.clock().now();
  switch (phase_) {
    case Phase::Starting:
      await_services(now);
      break;
    case Phase::Placing:
      await_pose(now);
      break;
    case Phase::Running:
      go_on(now);
      break;
    default:
      break;
  }
}

void Episode::await_services(Time now) {
  const auto missing = missing_services();
  if (missing.empty()) {
    place_robot();
  } else if (now - began_ > plan_.ready_within) {
    reason_ = "not ready in time:";
    for (const auto& name : missing) reason_ += " " + name;
    end_session(Phase::Failed, "aborted");
  } else {
    view_.phase = "waiting for " + missing.front();
  }
}

void Episode::await_pose(Time now) {
  const auto pose = robot_pose_.newest();
  const auto outcome = hints_.outcome(hint_id_);
  const bool is_told = !plan_.robot_start || outcome.state == bus::EventOutcome::State::Applied;
  if (plan_.without_robot || (is_told && pose && pose->message.status() == msg::LOCALIZATION_OK)) {
    start_session();
  } else if (plan_.robot_start && outcome.state == bus::EventOutcome::State::Refused) {
    place_robot();  // it was not ready for it
  } else if (now - began_ > plan_.ready_within) {
    reason_ = "the robot does not find itself on the map" + (outcome.reason.empty() ? "" : ": " + outcome.reason) +
              (plan_.robot_start ? "" : ": press Robot pose on the phone");
    end_session(Phase::Failed, "aborted");
  }
}

void Episode::go_on(Time now) {
  view_.time_s = to_seconds(now - session_began_);
  if (view_.found_at) {
    end_session(Phase::Found, "found");
  } else if (view_.time_s >= plan_.limit_s) {
    reason_ = "nothing found within the limit";
    end_session(Phase::TimeUp, "time_limit");
  } else if (const auto outcome = outcome_by_another()) {
    reason_ = "ended by another: " + *outcome;
    end_session(Phase::Ended, *outcome);
  }
}

std::optional<std::string> Episode::outcome_by_another() const {
  for (const auto& received : told_sessions_.each()) {
    const auto& told = received.message;
    const bool is_ours = told.robot() == session_.robot() && told.code() == session_.code();
    if (is_ours && told.phase() == msg::SESSION_ENDED && told.started_ns() == session_.started_ns()) {
      return told.outcome();
    }
  }
  return std::nullopt;
}

void Episode::abort(const std::string& reason) {
  if (is_over()) return;
  reason_ = reason;
  end_session(Phase::Failed, "aborted");
}

std::vector<std::string> Episode::missing_services() const {
  std::vector<std::string> missing = plan_.needed;
  for (const auto& received : health_.each()) {
    const auto& health = received.message;
    if (!received.writer_alive) continue;  // its last word, of a process that died
    // The localization is ready when it waits to be placed.
    const bool waits_for_us = health.service() == "localization" && health.state() == msg::HEALTH_STARTING;
    if (health.state() != msg::HEALTH_OK && health.state() != msg::HEALTH_DEGRADED && !waits_for_us) continue;
    std::erase(missing, health.host() + "/" + health.service());
    std::erase(missing, health.service());
  }
  return missing;
}

void Episode::place_robot() {
  view_.phase = "placing the robot";
  phase_ = Phase::Placing;
  if (!plan_.robot_start) return;
  msg::PoseHint hint;
  hint.robot(site_.robot);
  hint.id(hint_id_ = bus::new_event_id("operator", bus_.clock()));
  hint.stamp_ns(to_stamp_ns(bus_.clock().now()));
  hint.who("operator");
  hint.map_from_base().x(plan_.robot_start->x);
  hint.map_from_base().y(plan_.robot_start->y);
  hint.map_from_base().heading(plan_.robot_start->heading);
  hint.heading_known(true);
  hint.standard_deviation_m(0.3);
  hints_.send(hint);
}

void Episode::start_session() {
  session_began_ = bus_.clock().now();
  session_.phase(msg::SESSION_RUNNING);
  session_.started_ns(to_stamp_ns(session_began_));
  publish_session();
  view_.phase = "searching";
  view_.robot_track.clear();
  phase_ = Phase::Running;
}

void Episode::end_session(Phase phase, const std::string& outcome) {
  session_.phase(msg::SESSION_ENDED);
  session_.ended_ns(to_stamp_ns(bus_.clock().now()));
  session_.outcome(outcome);
  publish_session();
  view_.phase = phase == Phase::Found    ? "found by " + view_.found_by
                : phase == Phase::TimeUp ? "time is up"
                : phase == Phase::Ended  ? "ended"
                                         : "failed";
  phase_ = phase;
}

void Episode::publish_session() {
  session_.stamp_ns(to_stamp_ns(bus_.clock().now()));
  sessions_.write(session_);
}

void Episode::observe() {
  observe_places();
  observe_plan();
  observe_robot();
  for (const auto& received : human_messages_.take()) message_ids_.insert(received.message.id());
  view_.messages = static_cast<int>(message_ids_.size());
  for (const auto& received : detections_.take()) {
    const auto& detection = received.message;
    if (phase_ != Phase::Running || detection.robot() != site_.robot || view_.found_at) continue;
    view_.found_at = Eigen::Vector2d{detection.point_in_map().x(), detection.point_in_map().y()};
    view_.found_by = detection.detected_by();
  }
  if (const auto link = link_.newest()) {
    view_.link_up = link->message.up();
    view_.round_trip_ms = 1e3 * link->message.round_trip_s();
  }
}

void Episode::observe_places() {
  if (const auto pose = robot_pose_.take_new(); pose && phase_ == Phase::Running) {
    view_.robot_distance_m +=
        extend(view_.robot_track, {pose->message.map_from_base().x(), pose->message.map_from_base().y()});
  }
  for (const auto& received : teammates_.each()) {
    if (received.message.agent() != site_.agent || phase_ != Phase::Running) continue;
    const auto& pose = received.message.map_from_agent();
    view_.human_distance_m += extend(view_.human_track, {pose.x(), pose.y()});
  }
  if (!view_.robot_track.empty() && !view_.human_track.empty()) {
    view_.apart_m = (view_.robot_track.back() - view_.human_track.back()).norm();
  }
}

void Episode::observe_plan() {
  if (const auto plan = team_plan_.newest()) {
    view_.role = words_of(plan->message.role());
    view_.plan = words_of(plan->message.state());
    view_.robot_plan.clear();
    view_.human_plan.clear();
    for (const auto& path : plan->message.paths()) {
      auto& points = path.agent() == site_.robot ? view_.robot_plan : view_.human_plan;
      for (const auto& point : path.points()) points.emplace_back(point.x_m(), point.y_m());
    }
  }
  const auto newest = belief_.take_new();
  if (!newest) return;
  const auto& belief = newest->message;
  if (belief.cells().size() != static_cast<std::size_t>(belief.width()) * belief.height()) return;
  view_.belief = BeliefView{belief.resolution_m(), static_cast<int>(belief.width()), static_cast<int>(belief.height()),
                            Eigen::Vector2d{belief.origin_in_map().x(), belief.origin_in_map().y()}, belief.cells()};
  view_.explored = belief.explored();
  for (const auto& share : belief.explored_by()) {
    if (share.agent() == site_.robot) view_.explored_robot = share.share();
    if (share.agent() == site_.agent) view_.explored_human = share.share();
  }
}

void Episode::observe_robot() {
  const auto execution = execution_.newest();
  if (execution) {
    view_.robot_state = execution->message.moving()    ? "moving"
                        : execution->message.blocked() ? "blocked"
                                                       : execution->message.reason();
  }
  const auto status = base_status_.newest();
  if (!status) return;
  // A stop is something that holds the robot back while it wants to move; waiting for a plan is none.
  const auto& reasons = status->message.stop_reasons();
  const bool stopped = std::any_of(reasons.begin(), reasons.end(), [](msg::StopReason reason) {
    return reason != msg::STOP_NONE && reason != msg::STOP_NOT_ENABLED;
  });
  if (stopped && !was_stopped_ && phase_ == Phase::Running) ++view_.stops;
  was_stopped_ = stopped;
}

}  // namespace tandem::cli
