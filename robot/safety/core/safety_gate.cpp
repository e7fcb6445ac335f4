#include "robot/safety/core/safety_gate.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tandem::safety {
namespace {

constexpr double kUsualScanAge_s = 0.1;  ///< is part of the reaction time
constexpr double kTouching_m = 0.05;
constexpr double kLongestCycle_s = 0.2;  ///< after a longer pause the robot starts from standing

/// `wanted` as far as `step` above `last` allows; towards zero at once, through zero never.
double raised(double wanted, double last, double step) {
  if (wanted == 0.0 || wanted * last < 0.0) return 0.0;
  return std::copysign(std::min(std::abs(wanted), std::abs(last) + step), wanted);
}

}  // namespace

SafetyGate::SafetyGate(const GateConfig& config, std::vector<HardZone> zones)
    : config_(config),
      hull_{config.hull_length_m / 2.0, config.hull_width_m / 2.0},
      zones_(std::move(zones)),
      commands_(config_),
      scans_(config_),
      motion_(config_),
      link_(config_),
      stops_(config_) {}

Causes SafetyGate::causes_of(const GateInput& input, Time now) {
  Causes causes = requested_ | commands_.causes(now) | scans_.causes(now) | motion_.step(input.base, last_, now);
  requested_.reset();
  const auto& people = input.people;
  const bool people_known = people.age_s && *people.age_s <= config_.people_timeout_s;
  causes.set(index_of(Cause::PersonClose),
             people_known && speed_near_person(nearest_person_m(hull_, people), config_.max_speed_mps) == 0.0);
  if ((config_.require_pose || !zones_.empty()) && !is_operated()) {
    causes.set(index_of(Cause::StalePose), !has_pose(input.pose));
    causes.set(index_of(Cause::LostPose), has_pose(input.pose) && input.pose.lost);
    causes.set(index_of(Cause::OtherMap), !zones_.empty() && input.other_map);
  }
  causes.set(index_of(Cause::TwoBases), input.other_base);
  causes |= link_.step(input.link, input.base.odom_from_base, now);
  return causes;
}

bool SafetyGate::has_pose(const PoseInput& pose) const {
  return pose.age_s && *pose.age_s <= config_.pose_timeout_s;
}

Motion SafetyGate::without_reverse(Motion wanted) const {
  if (wanted.forward_mps >= 0.0) return wanted;
  const bool allowed = is_operated() && motion_.reversed_m() < config_.max_reverse_distance_m;
  wanted.forward_mps = allowed ? std::max(wanted.forward_mps, -config_.max_reverse_speed_mps) : 0.0;
  return wanted;
}

Motion SafetyGate::away_from_contact(Motion wanted, const BaseInput& base) const {
  if (stops_.excused().none()) return wanted;
  const double most = config_.max_reverse_speed_mps;
  return {std::clamp(wanted.forward_mps, base.rear_bumpers != 0 ? 0.0 : -most, base.front_bumpers != 0 ? 0.0 : most),
          0.0};
}

Motion SafetyGate::ramped(const Motion& wanted, double limit_mps, bool motors_enabled, Time now) const {
  const double elapsed_s = to_seconds(now - last_time_);
  const bool continuous = motors_enabled && elapsed_s >= 0.0 && elapsed_s <= kLongestCycle_s;
  const Motion last = continuous ? last_ : Motion{};
  const double step_s = std::clamp(elapsed_s, 0.0, kLongestCycle_s);

  Motion motion = wanted;
  const double capped = std::clamp(wanted.forward_mps, -limit_mps, limit_mps);
  motion.forward_mps = raised(capped, last.forward_mps, config_.acceleration_mps2 * step_s);
  // A slower robot keeps the shape of its arc.
  if (wanted.forward_mps != 0.0) motion.turn_rate_radps *= motion.forward_mps / wanted.forward_mps;
  motion.turn_rate_radps =
      std::clamp(motion.turn_rate_radps, -config_.max_turn_rate_radps, config_.max_turn_rate_radps);
  motion.turn_rate_radps =
      raised(motion.turn_rate_radps, last.turn_rate_radps, config_.turn_acceleration_radps2 * step_s);
  return motion;
}

PathLimit SafetyGate::limited_by_way(const GateInput& input, const Motion& candidate, Time now, Causes& causes) const {
  const double told = input.base.deceleration_mps2;
  const double deceleration = told > 0.0 ? std::min(config_.deceleration_mps2, told) : config_.deceleration_mps2 / 2.0;
  const double late_s = std::max(0.0, scans_.age_s(now) - kUsualScanAge_s);
  // What a bumper touches lies at the hull: an operator who backs out of it is not stopped by that.
  const Hull hull = stops_.excused().none() ? hull_ : hull_.grown(-kTouching_m);
  PathLimit limit = limited_by_surroundings(config_, hull, deceleration, late_s, candidate, scans_.points_in_base());
  causes.set(index_of(Cause::ObstacleAhead), limit.limited_to_zero);
  // An operator may drive without a pose, and then nobody knows where the zones are.
  if (zones_.empty() || !has_pose(input.pose) || input.pose.lost || input.other_map) return limit;
  const Pose2 map_from_base = trail_.moved_on(input.pose.map_from_base, input.pose.stamp);
  limit = limited_by_zones(config_, hull_, deceleration, limit.motion, zones_, map_from_base, is_operated());
  causes.set(index_of(Cause::KeepOutAhead), limit.limited_to_zero);
  return limit;
}

GateDecision SafetyGate::step(const GateInput& input, Time now) {
  GateDecision decision;
  trail_.take(input.base.odom_from_base, input.base.odometry_epoch, now);
  Causes causes = causes_of(input, now);
  stops_.step(causes, now, is_operated() ? Causes{}.set(index_of(Cause::Bumper)) : Causes{});
  decision.wanted = commands_.wanted(now);
  decision.speed_limit_mps = stops_.may_move(now) ? speed_limit_mps(config_, hull_, input.people, input.base) : 0.0;
  if (link_.is_on_last_leg()) decision.speed_limit_mps = std::min(decision.speed_limit_mps, config_.last_leg_speed_mps);

  if (stops_.may_move(now)) {
    const Motion candidate = ramped(away_from_contact(without_reverse(decision.wanted), input.base),
                                    decision.speed_limit_mps, input.base.motors_enabled, now);
    decision.motion = limited_by_way(input, candidate, now, causes).motion;
  }
  static const Causes kLimits = causes_with(Resume::AtOnce);
  decision.causes = stops_.open_causes() | (causes & kLimits);
  decision.latched = stops_.is_latched();
  decision.resume_in_s = stops_.resume_in_s(now);
  decision.battery_warning = motion_.battery_v() && *motion_.battery_v() < config_.battery_warning_v;
  decision.battery_return = motion_.battery_v() && *motion_.battery_v() < config_.battery_return_v;
  last_ = decision.motion;
  last_time_ = now;
  return decision;
}

}  // namespace tandem::safety
