#pragma once

#include <string>
#include <vector>

#include "services/planner/core/scenario/planning_scenario.hpp"
#include "services/planner/core/tasks/task_plan.hpp"

namespace tandem::cli {

/// What one of the team does.
struct PicturedAgent {
  std::string id;
  ScenarioAgentKind kind = ScenarioAgentKind::Robot;
  Pose2 start;  ///< map_from_agent
  TimedPath path;
  std::vector<TaskVisit> visits;
};

/// How likely the object lies where, in square cells along the map's axes.
struct PicturedBelief {
  Eigen::Vector2d origin_in_map = Eigen::Vector2d::Zero();  ///< lower left corner [m]
  double cell_size_m = 1.0;
  int width = 0;
  int height = 0;
  std::vector<double> density;  ///< per square metre, row by row; 0 where nothing is searched
};

/// All that a picture of a plan shows.
struct PlanPicture {
  std::string title;
  std::string subtitle;
  std::vector<OccupancyGrid> layers;  ///< the floor first
  RewardWorld world;
  std::vector<PicturedAgent> agents;  ///< in the order of the world
  std::vector<Inform> informs;
  std::vector<std::vector<DrainPoint>> drains;  ///< by source
  PicturedBelief belief;
  std::vector<double> found;  ///< probability that the object is found by 0, `found_step_s`, ...
  double found_step_s = 1.0;
  double end_s = 1.0;  ///< of the axis of time
};

/// The picture as SVG: the place with sources, belief and paths; the graph of relations; who is where and what is left
/// in the pools, over time. Equal input, equal bytes.
[[nodiscard]] std::string svg_of(const PlanPicture& picture);

}  // namespace tandem::cli
