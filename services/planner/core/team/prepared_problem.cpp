#include "services/planner/core/team/prepared_problem.hpp"

#include <algorithm>
#include <utility>

namespace tandem {
namespace {

constexpr double kStartReach_m = 3.0;
constexpr double kGoalSearch_m = 3.0;

/// How an agent looks at the end of its path.
double final_heading_rad(const TimedPath& path, double initial_rad) {
  for (std::size_t i = path.points.size(); i-- > 1;) {
    const auto& from = path.points[i - 1].point_in_map;
    const auto& to = path.points[i].point_in_map;
    if ((to - from).norm() > 1e-9) return heading_towards(from, to);
  }
  return initial_rad;
}

}  // namespace

PreparedProblem::PreparedProblem(const SearchProblem& problem) : problem_(problem) {
  SearchWorld& world = *problem.world;
  world.forget_added_places();
  const auto add_fixed = [&](int searcher, const TimedPath& path, double heading_rad) {
    if (path.points.size() < 2) return;
    fixed_seen_.push_back(sightings_along(path, heading_rad, world.views(searcher)));
    fixed_looks_.push_back({&fixed_seen_.back(), 0.0, world.searcher(searcher).detection_rate_per_s});
  };
  for (const OthersPath& other : problem.others) add_fixed(other.searcher, other.path, other.initial_heading_rad);
  for (const SearchMember& who : problem.members) {
    add_fixed(who.searcher, path_until(who.committed, who.battery_s), who.pose.heading);
    Member member;
    member.actions = &world.actions(who.searcher);
    member.start_s = who.committed.duration_s();
    member.heading_rad = final_heading_rad(who.committed, who.pose.heading);
    member.end_s = std::min(problem.horizon_s, who.battery_s);
    const Eigen::Vector2d start =
        who.committed.points.empty() ? who.pose.position() : who.committed.points.back().point_in_map;
    const auto place = member.actions->add_place(start, kStartReach_m);
    member.start = place.value_or(-1);
    if (!place) member.end_s = member.start_s;
    fixed_seen_.push_back(sightings_of_stay({start.x(), start.y(), member.heading_rad}, world.views(who.searcher)));
    member.stay = &fixed_seen_.back();
    if (place && who.goal) {
      const auto goal = member.actions->add_place(*who.goal, kGoalSearch_m);
      if (goal && member.actions->is_connected(*place, *goal)) member.goal = goal;
    }
    members_.push_back(member);
  }
}

void PreparedProblem::add_looks(std::size_t member, const std::vector<int>& places, std::vector<Look>& looks) const {
  const Member& who = members_[member];
  const Searcher& searcher = who.actions->searcher();
  double time_s = who.start_s;
  double heading_rad = who.heading_rad;
  int from = who.start;
  const Sightings* stay = who.stay;
  for (const int place : places) {
    if (time_s >= who.end_s) break;
    const Leg& leg = who.actions->leg(from, place);
    if (!leg.possible()) continue;
    const double turn_s = turning_time_s(searcher, heading_rad, leg.initial_heading_rad);
    const double turned_s = std::min(time_s + turn_s, who.end_s);
    if (turn_s > 0.0) looks.push_back({stay, time_s, searcher.detection_rate_per_s, turned_s});
    time_s += turn_s;
    looks.push_back({&leg.seen, time_s, searcher.detection_rate_per_s, who.end_s});
    time_s += leg.duration_s;
    heading_rad = leg.final_heading_rad;
    from = place;
    stay = &leg.stay;
  }
}

TimedPath PreparedProblem::path(std::size_t member, const std::vector<int>& places, double until_s) const {
  const Member& who = members_[member];
  TimedPath path = problem_.members[member].committed;
  if (who.start < 0) {
    if (path.points.empty()) path.points.push_back({0.0, problem_.members[member].pose.position()});
    return path;
  }
  if (path.points.empty()) path.points.push_back({0.0, who.actions->place(who.start)});
  double time_s = who.start_s;
  double heading_rad = who.heading_rad;
  int from = who.start;
  for (const int place : places) {
    if (time_s > until_s) break;
    const Leg& leg = who.actions->leg(from, place);
    if (!leg.possible()) continue;
    time_s += turning_time_s(who.actions->searcher(), heading_rad, leg.initial_heading_rad);
    if (time_s > path.duration_s()) path.points.push_back({time_s, leg.way.front()});
    for (const auto& point : timed_path(leg.way, who.actions->searcher(), leg.initial_heading_rad).points) {
      if (point.time_s > 0.0) path.points.push_back({time_s + point.time_s, point.point_in_map});
    }
    time_s += leg.duration_s;
    heading_rad = leg.final_heading_rad;
    from = place;
  }
  return path_until(path, problem_.members[member].battery_s);
}

JointPlan PreparedProblem::plan(const Routes& routes) const {
  std::vector<TimedPath> paths;
  for (std::size_t m = 0; m < members_.size(); ++m) paths.push_back(path(m, routes[m]));
  return evaluated(problem_, std::move(paths));
}

}  // namespace tandem
