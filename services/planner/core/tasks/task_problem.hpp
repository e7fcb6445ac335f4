#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/mapping/core/occupancy_grid.hpp"
#include "services/planner/core/motion/timed_path.hpp"
#include "services/planner/core/search/searcher.hpp"
#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

/// Who decides what an agent does once its committed path ends.
enum class TaskFreedom {
  Planned,  ///< this planner
  Fixed,    ///< nobody: the accepted plan of another robot; it waits at the end
};

/// One of a team with a task: where it starts, how it moves, what is settled already.
struct TaskAgent {
  Searcher searcher;  ///< Its id is that of an agent of the world; its layer is one of TaskProblem::layers.
  Pose2 start;        ///< map_from_agent
  double altitude_m = 0.0;
  /// Walked first, whatever is planned: an action under way when the plan is made, or the time a person takes to react
  /// (digest F8). May be empty.
  TimedPath committed;
  TaskFreedom freedom = TaskFreedom::Planned;
  std::optional<Eigen::Vector2d> goal_in_map;  ///< Fixed by a person: its path ends there (digest H1).
};

/// A team, a place and a world of reward sources to be consumed.
struct TaskProblem {
  RewardWorld world;
  std::vector<TaskAgent> agents;                 ///< As many as the world has, in its order; at most kMaxTaskAgents.
  std::vector<OccupancyGrid> layers;             ///< By Searcher::layer; none: an open plane.
  double horizon_s = 60.0;                       ///< All plans are compared over this time (digest A2).
  std::vector<std::vector<TimedPath>> rejected;  ///< Plans that a person rejected: a path per agent (digest A6).
  std::vector<std::vector<std::string>> in_execution;  ///< The sources that each agent is on its way to now, in order.
};

inline constexpr std::size_t kMaxTaskAgents = 8;
/// Sources of one task; a search has its own planner.
inline constexpr std::size_t kMaxTaskSources = 256;

/// The first thing that makes the problem unusable, for people; none if it can be planned.
[[nodiscard]] std::optional<std::string> problem_of(const TaskProblem& problem);

}  // namespace tandem
