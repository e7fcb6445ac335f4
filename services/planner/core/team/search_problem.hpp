#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "services/planner/core/search/search_objective.hpp"
#include "services/planner/core/team/search_world.hpp"

namespace tandem {

/// What a person may do instead of following the plan.
struct PathHypothesis {
  double probability = 0.0;
  TimedPath path;  ///< from now
};

/// One who searches: where they start, what they can do, where they were asked to go.
struct SearchMember {
  int searcher = 0;  ///< of the world
  Pose2 pose;        ///< now
  double battery_s =
      std::numeric_limits<double>::infinity();  ///< So long it can go on; then it stops and looks no more.
  /// Walked first whatever is planned, from `pose`: an action under way, or the old plan while a person reads the new
  /// one (digest F8). Empty: the plan begins now.
  TimedPath committed;
  std::optional<Eigen::Vector2d> goal;     ///< The next goal, fixed by a person (digest H1) [m].
  std::vector<PathHypothesis> hypotheses;  ///< Probabilities add up to at most 1; the rest follows the plan.
};

/// An accepted plan of a robot that is not planned here (digest A5).
struct OthersPath {
  int searcher = 0;  ///< of the world
  double initial_heading_rad = 0.0;
  TimedPath path;  ///< from now
};

/// What is to be planned, the same for every planner.
struct SearchProblem {
  SearchWorld* world = nullptr;       ///< Outlives the problem.
  std::vector<SearchMember> members;  ///< One to eight.
  /// For each object still missing the joint mass of each search cell: the objects lie independently of each other.
  std::vector<std::vector<double>> masses;
  double horizon_s = 120.0;                      ///< All plans are compared over this time.
  double tail_s = 120.0;                         ///< See SearchObjective.
  std::vector<OthersPath> others;                ///< What is looked at anyway.
  std::vector<std::vector<TimedPath>> rejected;  ///< Plans that a person rejected: a path per member (digest A6).
  std::vector<TimedPath> current;                ///< The plan in execution, from now: a path per member; or empty.
};

/// A plan for the team.
struct JointPlan {
  std::vector<TimedPath>
      paths;  ///< per member, from `pose`, as far as its battery lasts; may go on behind a fixed goal
  /// Per member, when it is at its fixed goal; infinite without one. What it is told ends there (digest H1).
  std::vector<double> goal_reached_s;
  Forecast forecast;
  double value_s = 0.0;  ///< Expected time, and a penalty if it is like a rejected plan; lower is better.
};

/// So near to it a goal is reached [m].
inline constexpr double kGoalReach_m = 0.5;

/// What is added to the value of a plan like a rejected one [s].
inline constexpr double kRejectedPenalty_s = 1e4;

/// Whether each member of `paths` would walk about as in the rejected plan: nearer than `near_m` on average over the
/// first `window_s`.
[[nodiscard]] bool is_like(const std::vector<TimedPath>& paths, const std::vector<TimedPath>& rejected,
                           double window_s = 30.0, double near_m = 2.0);

/// The path up to `end_s`.
[[nodiscard]] TimedPath path_until(const TimedPath& path, double end_s);

/// The plan in which the members walk `paths` as far as their batteries last, and its value. The only way a plan gets
/// one. A member reaches its goal
/// at the first corner of its path within `kGoalReach_m` of it.
[[nodiscard]] JointPlan evaluated(const SearchProblem& problem, std::vector<TimedPath> paths);

/// P(not found) at 0, `step_s`, ... if the members walk `paths` to the letter.
[[nodiscard]] std::vector<double> survival_of(const SearchProblem& problem, const std::vector<TimedPath>& paths,
                                              double step_s);

}  // namespace tandem
