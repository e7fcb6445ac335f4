#include "services/navigator/core/navigator.hpp"

#include <algorithm>
#include <cmath>

#include "services/navigator/core/speed_limits.hpp"

namespace tandem::navigator {

Pose2 moved_on(const Pose2& pose, const Twist2& velocity, double age_s) {
  const double turn = velocity.turn_rate_radps * age_s;
  const double way = velocity.forward_mps * age_s;
  return pose * Pose2{way * std::cos(0.5 * turn), way * std::sin(0.5 * turn), turn};
}

bool Execution::differs_from(const Execution& other) const {
  return plan_id != other.plan_id || moving != other.moving || finished != other.finished || blocked != other.blocked ||
         reason != other.reason;
}

Navigator::Navigator(const NavigatorConfig& config, LinkLoss link_loss, Zones zones)
    : config_(config),
      plans_(from_seconds(config.plan_timeout_s)),
      follower_(config),
      avoidance_(config),
      link_loss_(link_loss),
      zones_(std::move(zones)) {}

std::string Navigator::reason_to_stand(const Situation& situation) const {
  using Standing = PlanKeeper::Standing;
  if (!situation.running_session) return "no session is running";
  switch (plans_.standing(situation.now, *situation.running_session)) {
    case Standing::None:
      return "no plan";
    case Standing::Proposed:
      return "waiting for the plan to be accepted";
    case Standing::Unconfirmed:
      return "waiting for the planner to repeat its plan";
    case Standing::Dead:  // nobody can repeat it without a link; one that was not begun is not begun then
      if (situation.link_lost && link_loss_ != LinkLoss::Stop && (retreating_ || plan_id_ == plans_.plan()->id)) break;
      return "the planner no longer repeats its plan";
    case Standing::Expired:
      return "the plan has expired";
    case Standing::OtherSession:
      return "the plan is of another session";
    case Standing::NoPath:
      return "the plan has no path for this robot";
    case Standing::TwoPlanners:
      return "X5: two planners plan for this robot: " + plans_.planner() + " and " + plans_.rival(situation.now) +
             "; end one";
    case Standing::Executable:
      break;
  }
  const auto stale = [&](Time received, double timeout_s) {
    return situation.now - received > from_seconds(timeout_s);
  };
  if (!situation.pose || stale(situation.pose->received, config_.pose_timeout_s)) return "no pose";
  if (situation.pose->quality == PoseQuality::Lost) return "the pose is lost";
  if (!situation.obstacles || stale(situation.obstacles->received, config_.scan_timeout_s)) return "no scan";
  return {};
}

void Navigator::take_up_plan(const Pose2& map_from_base, Time now) {
  const PlanNews& plan = *plans_.plan();
  Path path{plan.points_in_map};
  if (plan.id == plan_id_ && path == follower_.path()) return;
  plan_id_ = plan.id;
  begin(std::move(path), map_from_base, now);
}

void Navigator::begin(Path path, const Pose2& map_from_base, Time now) {
  follower_.begin(std::move(path), map_from_base.position());
  finished_ = false;
  last_motion_ = last_progress_ = {now, map_from_base, 0.0};
}

bool Navigator::retreat(const Situation& situation, const Pose2& map_from_base) {
  if (link_loss_ != LinkLoss::Retreat) return false;
  if (!situation.link_lost) {
    way_back_.take(map_from_base.position());
    if (retreating_) plan_id_.clear();  // its plan is taken up anew from here
    retreating_ = false;
  } else if (!retreating_) {
    retreating_ = true;
    begin(Path{way_back_.points_from(map_from_base.position())}, map_from_base, situation.now);
  }
  return retreating_;
}

Decision Navigator::decide(const Situation& situation) {
  Decision decision;
  if (plans_.plan()) decision.execution.plan_id = plans_.plan()->id;
  const auto stand = [&](std::string reason) {
    decision.execution.reason = std::move(reason);
    last_velocity_ = {};
    wanted_to_move_ = false;
    return decision;
  };

  if (auto reason = reason_to_stand(situation); !reason.empty()) return stand(std::move(reason));

  constexpr double kMaxPrediction = 0.3;  // [s]
  const auto age_s = [&](Time stamp) { return std::clamp(to_seconds(situation.now - stamp), 0.0, kMaxPrediction); };
  const Pose2 map_from_base = moved_on(situation.pose->map_from_base, situation.velocity, age_s(situation.pose->stamp));
  if (!retreat(situation, map_from_base)) take_up_plan(map_from_base, situation.now);

  const Aim aim = follower_.aim(map_from_base, last_velocity_.forward_mps);
  finished_ = finished_ || aim.arrived;
  const double length = follower_.path().length_m();
  decision.execution.progress = finished_ || length <= 0.0 ? 1.0 : aim.way_m / length;
  decision.execution.finished = finished_;
  if (finished_) return stand("finished");

  const Pose2 then_from_now = moved_on({}, situation.velocity, age_s(situation.obstacles->stamp));
  const Pose2 now_from_then = inverse(then_from_now);
  std::vector<Eigen::Vector2d> obstacles_in_base;
  obstacles_in_base.reserve(situation.obstacles->points_in_base.size());
  for (const auto& point : situation.obstacles->points_in_base) obstacles_in_base.push_back(now_from_then * point);
  zones_.add_outlines(map_from_base, obstacles_in_base);

  const Course course = avoidance_.course(aim, follower_.path(), map_from_base, obstacles_in_base);
  decision.velocity = velocity_for(course, aim, situation, map_from_base);
  last_velocity_ = decision.velocity;

  watch_advance(situation, map_from_base, aim);
  const double still_s = to_seconds(situation.now - last_motion_.since);
  const double stuck_s = to_seconds(situation.now - last_progress_.since);
  decision.execution.blocked = still_s >= config_.blocked_after_s || stuck_s >= config_.stuck_after_s;
  if (decision.execution.blocked && aim.remaining_m <= config_.occupied_goal_tolerance_m) {
    finished_ = true;  // something stands at the goal: as close as it gets
    decision.velocity = {};
    decision.execution.finished = true;
    decision.execution.blocked = false;
    decision.execution.progress = 1.0;
    return stand("finished");
  }
  decision.execution.moving = decision.velocity != Twist2{} && still_s < config_.blocked_after_s &&
                              (situation.base.stopped_by.empty() || situation.base.by_obstacle);
  if (decision.execution.blocked) {
    constexpr double kNear = 1.0;  // [m] farther obstacles are not what it stands in front of
    decision.execution.blocked_at_in_map = course.free.way_m < kNear
                                               ? map_from_base * course.free.obstacle_in_base
                                               : follower_.path().point_at(aim.way_m + 0.5 * config_.hull_length_m);
  }
  if (!situation.base.stopped_by.empty() && !situation.base.by_obstacle) {
    decision.execution.reason = "the base is stopped: " + situation.base.stopped_by;
  } else if (decision.execution.blocked) {
    decision.execution.reason = still_s >= config_.blocked_after_s ? "something is in the way" : "it does not get on";
  } else if (!decision.execution.moving) {
    decision.execution.reason = "waiting for the way to become free";
  }
  return decision;
}

Twist2 Navigator::velocity_for(const Course& course, const Aim& aim, const Situation& situation,
                               const Pose2& map_from_base) const {
  constexpr double kLeastTurnRate = 0.12;  // [rad/s] below it skid steering sticks
  constexpr double kTurnGain = 1.5;        // [1/s]
  constexpr double kRolling = 0.05;        // [m/s]
  Twist2 wanted;
  if (course.kind == Course::Kind::TurnInPlace) {
    const double limit =
        course.nearest_m < config_.near_turn_distance_m ? config_.near_turn_rate_radps : config_.max_turn_rate_radps;
    const double rate = std::clamp(kTurnGain * std::abs(aim.bearing_rad), kLeastTurnRate, limit);
    wanted.turn_rate_radps = std::copysign(rate, aim.bearing_rad);
    if (situation.velocity.forward_mps > kRolling) wanted.turn_rate_radps = 0.0;  // stops first
  } else if (course.kind == Course::Kind::Arc) {
    wanted.forward_mps = std::min(
        speed_limit(config_, course, aim, map_from_base, situation.pose->quality, situation.people),
        zones_.speed_limit_mps(map_from_base.position(), 0.5 * std::hypot(config_.hull_length_m, config_.hull_width_m),
                               config_.deceleration_mps2));
    wanted.turn_rate_radps = wanted.forward_mps * course.curvature;
  }
  return limited_acceleration(config_, last_velocity_, wanted, situation.velocity.forward_mps);
}

void Navigator::watch_advance(const Situation& situation, const Pose2& map_from_base, const Aim& aim) {
  constexpr double kMoved = 0.1;   // [m]
  constexpr double kTurned = 0.2;  // [rad]
  constexpr double kGotOn = 0.3;   // [m]
  const bool held = !situation.base.stopped_by.empty() && !situation.base.by_obstacle;
  const Advance here{situation.now, map_from_base, aim.way_m};
  if (!wanted_to_move_ || held) last_motion_ = last_progress_ = here;  // what does not try is not blocked
  wanted_to_move_ = true;

  const Pose2& before = last_motion_.map_from_base;
  if ((map_from_base.position() - before.position()).norm() > kMoved ||
      std::abs(turn_between(before.heading, map_from_base.heading)) > kTurned) {
    last_motion_ = here;
  }
  if (aim.way_m > last_progress_.way_m + kGotOn) last_progress_ = here;
}

}  // namespace tandem::navigator
