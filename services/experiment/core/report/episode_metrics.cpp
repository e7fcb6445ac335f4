#include "services/experiment/core/report/episode_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "services/experiment/core/report/message_rate.hpp"
#include "services/experiment/core/report/search_progress.hpp"
#include "services/experiment/core/report/statistics.hpp"

namespace tandem::experiment {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.5;  ///< at which ways are looked at: longer than a pose's noise is fast
constexpr double kStanding_mps = 0.05;
constexpr double kStanding_radps = 0.1;
constexpr double kIntimate_m = 0.45;
constexpr double kPersonal_m = 1.2;
constexpr double kSocial_m = 3.6;
constexpr double kTouching_m = 0.4 + 0.25;

/// Where somebody is at the ends of half seconds, between the poses known; none outside them.
std::vector<std::optional<Pose2>> sampled(const std::vector<PoseAt>& poses, double duration_s) {
  std::vector<std::optional<Pose2>> samples;
  for (int i = 0; i * kStep_s <= duration_s; ++i) {
    const double time_s = i * kStep_s;
    const auto next = std::ranges::lower_bound(poses, time_s, {}, &PoseAt::time_s);
    if (next == poses.end() || (next == poses.begin() && next->time_s > time_s)) {
      samples.emplace_back();
    } else if (next == poses.begin() || next->time_s == time_s) {
      samples.emplace_back(next->map_from_agent);
    } else {
      const PoseAt& before = *(next - 1);
      const double share = (time_s - before.time_s) / (next->time_s - before.time_s);
      samples.emplace_back(interpolate(before.map_from_agent, next->map_from_agent, share));
    }
  }
  return samples;
}

struct Moves {
  Motion motion;
  std::vector<std::optional<bool>> active;  ///< per half second; none: not known
};

Moves moves_of(const std::vector<std::optional<Pose2>>& samples) {
  Moves moves;
  double known_s = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (!samples[i - 1] || !samples[i]) {
      moves.active.emplace_back();
      continue;
    }
    const double moved_m = (samples[i]->position() - samples[i - 1]->position()).norm();
    const double turned_rad = std::abs(turn_between(samples[i - 1]->heading, samples[i]->heading));
    const bool is_active = moved_m >= kStanding_mps * kStep_s || turned_rad >= kStanding_radps * kStep_s;
    moves.active.emplace_back(is_active);
    moves.motion.distance_m += moved_m;
    moves.motion.turning_rad += turned_rad;
    moves.motion.max_mps = std::max(moves.motion.max_mps, moved_m / kStep_s);
    moves.motion.idle_s += is_active ? 0.0 : kStep_s;
    known_s += kStep_s;
  }
  if (known_s > 0.0) moves.motion.mean_mps = moves.motion.distance_m / known_s;
  return moves;
}

double share_of(const std::vector<std::optional<bool>>& active, bool wanted) {
  double known = 0.0;
  double is_so = 0.0;
  for (const auto& one : active) {
    if (!one) continue;
    ++known;
    if (*one == wanted) ++is_so;
  }
  return known > 0.0 ? is_so / known : 0.0;
}

/// When two discs touch that go on as they do; none if never.
std::optional<double> time_to_collision_s(const Vector2d& away, const Vector2d& away_per_s) {
  const double gap = away.squaredNorm() - kTouching_m * kTouching_m;
  if (gap <= 0.0) return 0.0;
  const double a = away_per_s.squaredNorm();
  const double b = away.dot(away_per_s);
  const double root = b * b - a * gap;
  if (b >= 0.0 || root < 0.0) return std::nullopt;
  return (-b - std::sqrt(root)) / a;
}

/// Takes in where people are while the robot is somewhere.
class DistanceTally {
 public:
  void add(const Vector2d& away) {
    const double distance_m = away.norm();
    distances_.nearest_m = distances_.known_s > 0.0 ? std::min(distances_.nearest_m, distance_m) : distance_m;
    distances_.known_s += kStep_s;
    distances_.mean_m += kStep_s * distance_m;
    double* zone = distance_m < kIntimate_m   ? &distances_.intimate
                   : distance_m < kPersonal_m ? &distances_.personal
                   : distance_m < kSocial_m   ? &distances_.social
                                              : nullptr;
    if (zone != nullptr) *zone += kStep_s;
  }
  void add_approach(const Vector2d& away, const Vector2d& away_per_s) {
    if (const auto time_s = time_to_collision_s(away, away_per_s)) {
      auto& least = distances_.min_time_to_collision_s;
      least = least ? std::min(*least, *time_s) : *time_s;
    }
  }

  [[nodiscard]] Distances result() const {
    Distances result = distances_;
    if (!(result.known_s > 0.0)) return result;
    for (double* sum : {&result.mean_m, &result.intimate, &result.personal, &result.social}) *sum /= result.known_s;
    return result;
  }

 private:
  Distances distances_;
};

Distances to_teammate(const std::vector<std::optional<Pose2>>& robot, const std::vector<std::optional<Pose2>>& human) {
  DistanceTally tally;
  bool was_known = false;
  Vector2d before = Vector2d::Zero();
  for (std::size_t i = 0; i < std::min(robot.size(), human.size()); ++i) {
    const bool is_known = robot[i] && human[i];
    if (is_known) {
      const Vector2d away = human[i]->position() - robot[i]->position();
      tally.add(away);
      if (was_known) tally.add_approach(away, (away - before) / kStep_s);
      before = away;
    }
    was_known = is_known;
  }
  return tally.result();
}

/// The nearest of them counts. Who is who from one sighting to the next is not known: no time to collision.
Distances to_passers_by(const std::vector<std::optional<Pose2>>& robot, const std::vector<PassersByAt>& sightings) {
  DistanceTally tally;
  for (std::size_t i = 0; i < robot.size(); ++i) {
    const double time_s = static_cast<double>(i) * kStep_s;
    const auto next = std::ranges::upper_bound(sightings, time_s, {}, &PassersByAt::time_s);
    if (!robot[i] || next == sightings.begin() || time_s - (next - 1)->time_s > kStep_s) continue;
    const auto& points = (next - 1)->points_in_map;
    if (points.empty()) continue;
    const auto nearest = std::ranges::min_element(
        points, {}, [&](const Vector2d& point) { return (point - robot[i]->position()).squaredNorm(); });
    tally.add(*nearest - robot[i]->position());
  }
  return tally.result();
}

void count_base(const EpisodeLog& episode, EpisodeMetrics& metrics) {
  double highest_mps = 0.0;
  for (const BaseAt& base : episode.base) highest_mps = std::max(highest_mps, base.speed_limit_mps);
  std::string before;
  double known_s = 0.0;
  double slowed_s = 0.0;
  int stops = 0;
  for (std::size_t i = 0; i < episode.base.size(); ++i) {
    const BaseAt& base = episode.base[i];
    const double until_s = i + 1 < episode.base.size() ? episode.base[i + 1].time_s : episode.duration_s;
    const double lasted_s = std::min(until_s, episode.duration_s) - std::max(0.0, base.time_s);
    const std::string reason = base.stop_reasons.empty() ? "" : base.stop_reasons.front();
    if (lasted_s > 0.0) {
      if (!reason.empty() && before.empty()) {
        ++metrics.stops[reason];
        ++stops;
      }
      if (!reason.empty()) metrics.stopped_s[reason] += lasted_s;
      if (base.speed_limit_mps < highest_mps) slowed_s += lasted_s;
      known_s += lasted_s;
    }
    before = reason;
  }
  if (!(known_s > 0.0)) return;
  metrics.stop_count = stops;
  metrics.slowed = slowed_s / known_s;
}

void count_plans(const EpisodeLog& episode, EpisodeMetrics& metrics) {
  std::set<std::string> known;
  std::vector<double> made_s;
  for (const PlanAt& plan : episode.plans) {
    if (plan.state == PlanAt::State::Rejected) ++metrics.rejected;
    if (!known.insert(plan.id).second) continue;
    made_s.push_back(plan.time_s);
    if (!metrics.first_expected_s) {
      metrics.first_expected_s = plan.expected_time_s;
      if (plan.lower_bound_s > 0.0) metrics.first_lower_bound_s = plan.lower_bound_s;
    }
  }
  metrics.plans = static_cast<int>(made_s.size());
  for (const PressAt& press : episode.presses) {
    if (press.kind != "replan") continue;
    const auto next = std::ranges::upper_bound(made_s, press.time_s);
    if (next != made_s.end()) metrics.answer_s.push_back(*next - press.time_s);
  }
  for (const double time_s : made_s) {
    std::optional<double> said_s;
    for (const PressAt& press : episode.presses) {
      if (press.kind == "my_pose" && press.time_s <= time_s) said_s = press.time_s;
    }
    if (said_s) metrics.pose_age_at_plan_s.push_back(time_s - *said_s);
  }
}

void count_messages(const EpisodeLog& episode, EpisodeMetrics& metrics) {
  for (const PressAt& press : episode.presses) {
    if (press.time_s > 0.0 && press.time_s <= episode.duration_s) ++metrics.messages[press.kind];
  }
  const auto times = times_between_messages(episode, "my_pose", episode.duration_s);
  if (episode.duration_s > 0.0) {
    metrics.my_pose_per_min = 60.0 * static_cast<double>(times.size()) / episode.duration_s;
  }
  double last_s = 0.0;
  for (const PressAt& press : episode.presses) {
    if (press.kind == "my_pose" && press.time_s <= episode.duration_s) last_s = press.time_s;
  }
  metrics.longest_silence_s = episode.duration_s - last_s;
  for (const double time_s : times) metrics.longest_silence_s = std::max(metrics.longest_silence_s, time_s);

  const auto fired = std::ranges::count(episode.reminders, false, &ReminderAt::obeyed);
  const auto obeyed = std::ranges::count(episode.reminders, true, &ReminderAt::obeyed);
  if (fired > 0) metrics.reminder_effect = static_cast<double>(obeyed) / static_cast<double>(fired);
}

void count_link(const EpisodeLog& episode, EpisodeMetrics& metrics) {
  double known_s = 0.0;
  double up_s = 0.0;
  std::vector<double> round_trips_s;
  for (std::size_t i = 0; i < episode.link.size(); ++i) {
    const LinkAt& link = episode.link[i];
    const double until_s = i + 1 < episode.link.size() ? episode.link[i + 1].time_s : episode.duration_s;
    const double lasted_s = std::min(until_s, episode.duration_s) - std::max(0.0, link.time_s);
    if (!(lasted_s > 0.0)) continue;
    known_s += lasted_s;
    if (!link.up) continue;
    up_s += lasted_s;
    if (link.round_trip_s > 0.0) round_trips_s.push_back(link.round_trip_s);
  }
  if (known_s > 0.0) metrics.link_up = up_s / known_s;
  if (!round_trips_s.empty()) metrics.round_trip_s = median_of(round_trips_s);
}

}  // namespace

EpisodeMetrics metrics_of(const EpisodeLog& episode) {
  EpisodeMetrics metrics;
  metrics.found = episode.found();
  metrics.time_s = episode.duration_s;
  metrics.collisions = episode.collisions;
  if (const BeliefAt* last = belief_at(episode, episode.duration_s)) {
    metrics.explored = last->explored;
    metrics.explored_robot = last->explored_robot;
    metrics.explored_human = last->explored_human;
  }
  const auto robot = sampled(episode.robot_poses, episode.duration_s);
  const auto human = sampled(episode.human_poses, episode.duration_s);
  const Moves of_robot = moves_of(robot);
  const Moves of_human = moves_of(human);
  metrics.robot = of_robot.motion;
  metrics.human = of_human.motion;
  metrics.robot_idle = share_of(of_robot.active, false);
  metrics.human_idle = share_of(of_human.active, false);
  std::vector<std::optional<bool>> both(of_robot.active.size());
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (of_robot.active[i] && of_human.active[i]) both[i] = *of_robot.active[i] && *of_human.active[i];
  }
  metrics.both_active = share_of(both, true);
  metrics.teammate = to_teammate(robot, human);
  metrics.passers_by = to_passers_by(robot, episode.passers_by);
  count_base(episode, metrics);
  count_plans(episode, metrics);
  count_messages(episode, metrics);
  count_link(episode, metrics);
  return metrics;
}

}  // namespace tandem::experiment
