#pragma once

#include <optional>
#include <vector>

#include "services/planner/core/motion/action_set.hpp"
#include "services/planner/core/search/forecast.hpp"

namespace tandem {

/// One who searches: where it starts, what it can do, where it was asked to go.
struct TeamMember {
  ActionSet* actions = nullptr;  ///< Outlives the problem.
  int start = -1;                ///< A place of `actions`.
  double heading_rad = 0.0;      ///< At the start.
  std::optional<int> goal;       ///< Its next goal, fixed by a person (digest H1).
};

/// What is to be planned. At most eight members, each with its own action set.
struct TeamProblem {
  std::vector<TeamMember> members;
  std::vector<double> mass;                   ///< Joint mass of each search cell.
  int horizon_steps = 200;                    ///< All plans are compared over this time.
  double tail_s = 120.0;                      ///< See SearchForecaster.
  std::vector<std::vector<TimedPath>> taboo;  ///< Plans that a person rejected: a path per member (digest A6).
};

/// What one member is to do.
struct MemberPlan {
  std::vector<int> places;  ///< To go to, one after the other.
  TimedPath path;           ///< Ends at the goal if there is one.
};

/// A plan for the team.
struct JointPlan {
  std::vector<MemberPlan> members;
  Forecast forecast;
  double value_s = 0.0;          ///< Expected time, and a penalty if it is like a rejected plan; lower is better.
  std::vector<double> survival;  ///< P(not found) at the end of each step.
};

/// Whether each member of `paths` would walk about as in the rejected plan: nearer than `near_m` on average over the
/// first `window_s`.
[[nodiscard]] bool is_like(const std::vector<TimedPath>& paths, const std::vector<TimedPath>& rejected,
                           double window_s = 30.0, double near_m = 2.0);

/// The plan in which each member goes to its places in turn, and its value. The only way a plan gets one.
[[nodiscard]] JointPlan evaluated(const TeamProblem& problem, const std::vector<std::vector<int>>& places,
                                  SearchForecaster& forecaster);

/// Adds what only the chosen plan needs: paths and survival.
void add_paths(const TeamProblem& problem, SearchForecaster& forecaster, JointPlan& plan);

}  // namespace tandem
