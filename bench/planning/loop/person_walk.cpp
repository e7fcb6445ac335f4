#include "bench/planning/loop/person_walk.hpp"

#include <algorithm>

namespace tandem::bench {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.25;
constexpr double kGoalReached_m = 0.5;

}  // namespace

PersonWalk::PersonWalk(const PlanningInstance& instance, const OccupancyGrid& ground, std::size_t searcher,
                       std::uint64_t seed)
    : world_(std::make_unique<experiment::PersonWorld>(ground, instance.searchers[searcher], instance.area)),
      human_(experiment::make_human(instance.human, *world_, instance.searchers[searcher].speed_mps)),
      rng_(seed),
      pose_(instance.starts[searcher]) {}

void PersonWalk::show_plan(const TimedPath& path) {
  simulator::PhonePlan plan{"plan " + std::to_string(++plans_), {}};
  for (const TimedPoint& point : path.points) plan.own_path_in_map.push_back(point.point_in_map);
  plan_ = std::move(plan);
}

void PersonWalk::step(double now_s, TimedPath& walked) {
  simulator::PhoneUserInput input;
  input.now = from_stamp_ns(0) + from_seconds(now_s_);
  input.dt_s = kStep_s;
  input.map_from_person = pose_;
  input.walking = !route_.empty();
  input.connected = true;
  input.plan = plan_;
  const auto decision = human_.mind->step(input, rng_);
  for (const auto& message : decision.messages) {
    if (message.press == simulator::PhonePress::MyGoal) goal_ = message.point_in_map;
    pressed_ =
        pressed_ || message.press == simulator::PhonePress::MyGoal || message.press == simulator::PhonePress::Replan;
  }
  if (decision.new_route_in_map) route_ = *decision.new_route_in_map;
  Vector2d place = pose_.position();
  for (double left_m = human_.speed_mps * kStep_s; left_m > 1e-9 && !route_.empty();) {
    const Vector2d away = route_.front() - place;
    if (away.norm() > 1e-9) pose_.heading = heading_towards(place, route_.front());
    if (away.norm() > left_m) {
      place += left_m * away.normalized();
      break;
    }
    left_m -= away.norm();
    place = route_.front();
    route_.erase(route_.begin());
  }
  pose_ = {place.x(), place.y(), pose_.heading};
  now_s_ += kStep_s;
  walked.points.push_back({now_s + kStep_s, place});
  if (goal_ && (*goal_ - place).norm() <= kGoalReached_m) goal_.reset();
}

TimedPath PersonWalk::walk(double stretch_s, double least_s) {
  TimedPath walked{{{0.0, pose_.position()}}};
  pressed_ = false;
  const int steps = std::max(1, static_cast<int>(stretch_s / kStep_s + 0.5));
  for (int i = 0; i < steps && !(pressed_ && i * kStep_s >= least_s); ++i) step(i * kStep_s, walked);
  return walked;
}

TimedPath PersonWalk::under_way(double duration_s) const {
  TimedPath path{{{0.0, pose_.position()}}};
  for (const Vector2d& corner : route_) {
    const TimedPoint& last = path.points.back();
    const double time_s = last.time_s + (corner - last.point_in_map).norm() / human_.speed_mps;
    if (time_s > last.time_s) path.points.push_back({time_s, corner});
  }
  TimedPath begun;
  for (const TimedPoint& point : path.points) {
    if (point.time_s < duration_s) begun.points.push_back(point);
  }
  begun.points.push_back({duration_s, pose_at(path, duration_s).position()});
  return begun;
}

}  // namespace tandem::bench
