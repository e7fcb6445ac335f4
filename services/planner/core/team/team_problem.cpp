#include "services/planner/core/team/team_problem.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr double kTabooPenalty_s = 1e4;

/// The path of a member up to its goal, or to its last place.
TimedPath path_of(const TeamMember& member, const std::vector<int>& places) {
  ActionSet& actions = *member.actions;
  TimedPath path{{{0.0, actions.place(member.start)}}};
  double start_s = 0.0;
  double heading_rad = member.heading_rad;
  int from = member.start;
  for (const int place : places) {
    const Leg& leg = actions.leg(from, place);
    if (!leg.possible()) {  // it is there already
      if (place == member.goal) break;
      continue;
    }
    start_s += actions.turning_steps(heading_rad, leg.initial_heading_rad) * actions.step_s();
    if (start_s > path.duration_s()) path.points.push_back({start_s, leg.way.front()});
    for (const auto& point : timed_path(leg.way, actions.searcher(), leg.initial_heading_rad).points) {
      if (point.time_s > 0.0) path.points.push_back({start_s + point.time_s, point.point_in_map});
    }
    start_s += leg.steps() * actions.step_s();
    heading_rad = leg.final_heading_rad;
    from = place;
    if (place == member.goal) break;
  }
  return path;
}

AgentViews views_of(const TeamMember& member, const std::vector<int>& places, int horizon_steps) {
  ActionSet& actions = *member.actions;
  AgentViews views;
  views.detection_rate_per_s = actions.searcher().detection_rate_per_s;
  double heading_rad = member.heading_rad;
  int from = member.start;
  for (const int place : places) {
    const Leg& leg = actions.leg(from, place);
    if (!leg.possible()) continue;
    const int turning = actions.turning_steps(heading_rad, leg.initial_heading_rad);
    views.steps.insert(views.steps.end(), static_cast<std::size_t>(turning), nullptr);
    for (const int view : leg.views) views.steps.push_back(&actions.view(view));
    heading_rad = leg.final_heading_rad;
    from = place;
    if (static_cast<int>(views.steps.size()) >= horizon_steps) break;
  }
  return views;
}

}  // namespace

bool is_like(const std::vector<TimedPath>& paths, const std::vector<TimedPath>& rejected, double window_s,
             double near_m) {
  for (std::size_t m = 0; m < std::min(paths.size(), rejected.size()); ++m) {
    double sum_m = 0.0;
    int samples = 0;
    for (double time_s = 0.0; time_s <= window_s; time_s += 1.0, ++samples) {
      sum_m += (pose_at(paths[m], time_s).position() - pose_at(rejected[m], time_s).position()).norm();
    }
    if (sum_m > near_m * samples) return false;
  }
  return true;
}

JointPlan evaluated(const TeamProblem& problem, const std::vector<std::vector<int>>& places,
                    SearchForecaster& forecaster) {
  JointPlan plan;
  std::vector<AgentViews> views;
  for (std::size_t m = 0; m < problem.members.size(); ++m) {
    plan.members.push_back({places[m], {}});
    views.push_back(views_of(problem.members[m], places[m], problem.horizon_steps));
  }
  plan.forecast = forecaster.forecast(problem.mass, views, problem.horizon_steps);
  plan.value_s = plan.forecast.expected_time_s;
  if (problem.taboo.empty()) return plan;
  std::vector<TimedPath> paths;
  for (std::size_t m = 0; m < problem.members.size(); ++m) paths.push_back(path_of(problem.members[m], places[m]));
  if (std::ranges::any_of(problem.taboo, [&](const auto& rejected) { return is_like(paths, rejected); })) {
    plan.value_s += kTabooPenalty_s;
  }
  return plan;
}

void add_paths(const TeamProblem& problem, SearchForecaster& forecaster, JointPlan& plan) {
  std::vector<AgentViews> views;
  for (std::size_t m = 0; m < problem.members.size(); ++m) {
    plan.members[m].path = path_of(problem.members[m], plan.members[m].places);
    views.push_back(views_of(problem.members[m], plan.members[m].places, problem.horizon_steps));
  }
  plan.forecast = forecaster.forecast(problem.mass, views, problem.horizon_steps);
  plan.survival = forecaster.survival();
}

}  // namespace tandem
