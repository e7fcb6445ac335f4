#include "services/tracking/core/teammate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "services/tracking/core/walk.hpp"

namespace tandem::tracking {
namespace {

constexpr double kWalks = 0.3;  ///< [m/s] from here on a direction of walking is a heading

/// Where the track was at `time`, a little before or after it was last updated.
Eigen::Vector2d position_at(const Track& track, Time time) {
  return track.motion.position() + track.motion.velocity() * to_seconds(time - track.last_seen);
}

}  // namespace

void Teammate::hear(const PoseMessage& message, const PeopleTracker& people) {
  if (message.heading) heading_ = message.heading;
  const auto distance = [&](const Track& track) {
    return (position_at(track, message.stamp) - message.point_in_map).norm();
  };
  const Track* nearest = nullptr;
  for (const Track& track : people.tracks()) {
    if (!track.confirmed || distance(track) > config_.message_gate_m) continue;
    if (nearest == nullptr || distance(track) < distance(*nearest)) nearest = &track;
  }
  if (track_id_) {
    const Track* own = people.find(*track_id_);
    // How much likelier the finger is at the nearest than at the one they were, as a power of e.
    const auto square = [](double value) { return value * value; };
    const bool better = nearest != nullptr && own != nullptr && nearest->person &&
                        square(distance(*own)) - square(distance(*nearest)) >
                            2.0 * square(config_.message_deviation_m) * config_.renaming_evidence;
    if (own != nullptr && distance(*own) <= config_.keep_gate_m && !better) return take(*own);
  }
  track_id_.reset();
  if (nearest != nullptr) return take(*nearest);
  if (evidence_ && evidence_->stamp > message.stamp) return;  // seen since the person pressed
  evidence_ = Evidence{.stamp = message.stamp,
                       .position_in_map = message.point_in_map,
                       .velocity_in_map_mps = {0.0, 0.0},
                       .standard_deviation_m = config_.message_deviation_m,
                       .by_laser = false};
}

void Teammate::see(Time time, const PeopleTracker& people) {
  if (!evidence_) return;
  if (track_id_) {
    if (const Track* own = people.find(*track_id_)) return take(*own);
    track_id_.reset();
  }
  look_for_track(time, people);
}

void Teammate::take(const Track& track) {
  track_id_ = track.id;
  if (evidence_ && evidence_->by_laser && track.last_seen <= evidence_->stamp) return;  // nothing new
  evidence_ = Evidence{.stamp = track.last_seen,
                       .position_in_map = track.motion.position(),
                       .velocity_in_map_mps = track.motion.velocity(),
                       .standard_deviation_m = track.motion.standard_deviation_m(),
                       .by_laser = true};
  const Eigen::Vector2d velocity = track.motion.velocity();
  if (velocity.norm() > kWalks) heading_ = std::atan2(velocity.y(), velocity.x());
}

void Teammate::look_for_track(Time time, const PeopleTracker& people) {
  const auto expected = estimate(time);
  if (!expected || expected->lost) return;  // whoever comes now may be anybody: *My pose* will tell
  const double reach = std::min(config_.reach_limit_m, 0.5 + 2.0 * expected->standard_deviation_m);
  const double spread = 2.0 * expected->standard_deviation_m * expected->standard_deviation_m;
  // Somebody stands where they have just said: what the laser has there is them, whatever it looks like.
  const bool just_said = !evidence_->by_laser && expected->age_s <= config_.message_s;
  const Track* candidate = nullptr;
  double best = 0.0;
  double all = 0.0;
  for (const Track& track : people.tracks()) {
    const double distance = (track.motion.position() - expected->map_from_agent.position()).norm();
    if (!(just_said ? track.confirmed : track.person) || distance > reach) continue;
    // Whoever was followed already while the teammate was seen or heard of is somebody else.
    if (evidence_->by_laser && track.first_seen < evidence_->stamp) continue;
    const double likelihood = std::exp(-distance * distance / spread);
    all += likelihood;
    if (likelihood <= best) continue;
    best = likelihood;
    candidate = &track;
  }
  // Of two that could be the one neither is taken, unless it is much the likelier.
  if (candidate != nullptr && best >= config_.certainty * all) take(*candidate);
}

std::optional<TeammateEstimate> Teammate::estimate(Time now) const {
  if (!evidence_) return std::nullopt;
  const double age_s = std::max(0.0, to_seconds(now - evidence_->stamp));
  TeammateEstimate estimate;
  estimate.stamp = now;
  estimate.age_s = age_s;
  estimate.lost = age_s > config_.lost_after_s;
  const double growth = config_.uncertainty_growth_mps * age_s;
  estimate.standard_deviation_m = std::hypot(evidence_->standard_deviation_m, growth);

  Eigen::Vector2d position = evidence_->position_in_map;
  Eigen::Vector2d direction{0.0, 0.0};
  const bool sighted = evidence_->by_laser && age_s <= config_.sighted_s;
  const bool on_plan = config_.follow_plan && !path_in_map_.empty() &&
                       distance_from_path(path_in_map_, position) <= config_.plan_distance_m;
  if (sighted) {
    estimate.source = Source::Laser;
    position += evidence_->velocity_in_map_mps * age_s;
    estimate.velocity_in_map_mps = evidence_->velocity_in_map_mps;
  } else {
    const bool just_said = !evidence_->by_laser && age_s <= config_.message_s;
    estimate.source = just_said ? Source::Message : Source::Predicted;
    if (on_plan) {
      const Walk walk = walk_along(path_in_map_, position, config_.walking_speed_mps * age_s);
      position = walk.position_in_map;
      direction = walk.direction;
      estimate.velocity_in_map_mps = config_.walking_speed_mps * walk.direction;
    } else {
      position += evidence_->velocity_in_map_mps * std::min(age_s, config_.coast_s);
      if (age_s < config_.coast_s) estimate.velocity_in_map_mps = evidence_->velocity_in_map_mps;
    }
  }

  const bool walks = direction.norm() > 0.5;
  const double heading = walks ? std::atan2(direction.y(), direction.x()) : heading_.value_or(0.0);
  estimate.map_from_agent = {position.x(), position.y(), wrap_to_pi(heading)};
  estimate.heading_deviation_rad =
      !walks && !heading_ ? std::numbers::pi : std::min(std::numbers::pi, 0.5 + 0.1 * age_s);
  return estimate;
}

}  // namespace tandem::tracking
