#include "services/planner/core/team/search_problem.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

namespace tandem {
namespace {

/// What is seen on whole paths; keeps the sightings that its looks point at.
class LooksOfPaths {
 public:
  explicit LooksOfPaths(SearchWorld& world) : world_(world) {}

  Look look(int searcher, const TimedPath& path, double initial_heading_rad) {
    seen_.push_back(sightings_along(path, initial_heading_rad, world_.views(searcher)));
    return {&seen_.back(), 0.0, world_.searcher(searcher).detection_rate_per_s};
  }

 private:
  SearchWorld& world_;
  std::deque<Sightings> seen_;  // stay where they are
};

/// When `path` first has a corner or stop within kGoalReach_m of `goal`; infinite if it never does.
double time_at_s(const TimedPath& path, const Eigen::Vector2d& goal) {
  for (const TimedPoint& point : path.points) {
    if ((point.point_in_map - goal).norm() <= kGoalReach_m) return point.time_s;
  }
  return std::numeric_limits<double>::infinity();
}

struct PlanLooks {
  explicit PlanLooks(const SearchProblem& problem, const std::vector<TimedPath>& paths) : of(*problem.world) {
    for (const OthersPath& other : problem.others) {
      looks.push_back(of.look(other.searcher, other.path, other.initial_heading_rad));
    }
    first_member = looks.size();
    for (std::size_t m = 0; m < problem.members.size(); ++m) {
      looks.push_back(of.look(problem.members[m].searcher, paths[m], problem.members[m].pose.heading));
    }
  }
  LooksOfPaths of;
  std::vector<Look> looks;
  std::size_t first_member = 0;
};

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

TimedPath path_until(const TimedPath& path, double end_s) {
  TimedPath cut;
  for (const TimedPoint& point : path.points) {
    if (point.time_s > end_s) {
      cut.points.push_back({end_s, pose_at(path, end_s).position()});
      break;
    }
    cut.points.push_back(point);
  }
  return cut;
}

JointPlan evaluated(const SearchProblem& problem, std::vector<TimedPath> paths) {
  SearchObjective objective(problem.masses, problem.horizon_s, problem.tail_s);
  for (std::size_t m = 0; m < paths.size(); ++m) paths[m] = path_until(paths[m], problem.members[m].battery_s);
  PlanLooks plan_looks(problem, paths);
  JointPlan plan;
  // Each person who may not follow is taken by themselves: that two go astray at once is left out.
  double followed = 1.0;
  for (std::size_t m = 0; m < problem.members.size(); ++m) {
    for (const PathHypothesis& hypothesis : problem.members[m].hypotheses) {
      std::vector<Look> looks = plan_looks.looks;
      looks[plan_looks.first_member + m] =
          plan_looks.of.look(problem.members[m].searcher, hypothesis.path, problem.members[m].pose.heading);
      const Forecast otherwise = objective.forecast(looks);
      plan.forecast.expected_time_s += hypothesis.probability * otherwise.expected_time_s;
      plan.forecast.probability_found += hypothesis.probability * otherwise.probability_found;
      followed -= hypothesis.probability;
    }
  }
  const Forecast forecast = objective.forecast(plan_looks.looks);
  plan.forecast.expected_time_s += followed * forecast.expected_time_s;
  plan.forecast.probability_found += followed * forecast.probability_found;
  plan.value_s = plan.forecast.expected_time_s;
  if (std::ranges::any_of(problem.rejected, [&](const auto& rejected) { return is_like(paths, rejected); })) {
    plan.value_s += kRejectedPenalty_s;
  }
  for (std::size_t m = 0; m < problem.members.size(); ++m) {
    const auto& goal = problem.members[m].goal;
    plan.goal_reached_s.push_back(goal ? time_at_s(paths[m], *goal) : std::numeric_limits<double>::infinity());
  }
  plan.paths = std::move(paths);
  return plan;
}

std::vector<double> survival_of(const SearchProblem& problem, const std::vector<TimedPath>& paths, double step_s) {
  SearchObjective objective(problem.masses, problem.horizon_s, problem.tail_s);
  return objective.survival(PlanLooks(problem, paths).looks, step_s);
}

}  // namespace tandem
