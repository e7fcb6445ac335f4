#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "services/planner/core/scenario/drawn_room.hpp"
#include "services/planner/core/scenario/scenario_search.hpp"
#include "services/planner/core/search/searcher.hpp"
#include "services/planner/core/srs/reward_world.hpp"

namespace tandem {

enum class ScenarioAgentKind { Robot, Person, Drone };

/// One of the team in a planning scenario: where it starts, and how it moves and sees.
struct ScenarioAgent {
  ScenarioAgentKind kind = ScenarioAgentKind::Robot;
  Searcher searcher;  ///< Its id is the agent's, its layer one of PlanningScenario::altitudes_m.
  Pose2 start;        ///< map_from_agent
  double altitude_m = 0.0;
  double latency_s = 0.0;                      ///< Until it begins to follow a new plan.
  std::optional<Eigen::Vector2d> goal_in_map;  ///< Fixed by a person [m].
};

/// A place, a team and a task to be planned: a search, a world of reward sources, or both. Written in
/// config/scenarios/tasks/*.json and by benchmarks; config/scenarios/planning.schema.json describes the file.
struct PlanningScenario {
  std::string name;
  std::string description;
  std::variant<DrawnRoom, std::filesystem::path> place;  ///< The path is a map_server YAML file.
  std::vector<double> altitudes_m{0.0};                  ///< One layer each; 0 is the floor.
  std::vector<ScenarioAgent> agents;
  RewardWorld world;
  std::optional<ScenarioSearch> search;
  double horizon_s = 100.0;
};

/// The scenario in `json`; `file` stands in messages, and a map is looked for in the folder that holds scenarios/.
/// Throws ConfigError with file and key.
[[nodiscard]] PlanningScenario parse_planning_scenario(std::string_view json, const std::filesystem::path& file);

/// Reads and parses `file`. Throws ConfigError or FileError.
[[nodiscard]] PlanningScenario load_planning_scenario(const std::filesystem::path& file);

/// The map of each layer. A map file has no heights: all its layers are the same. Throws MapError.
[[nodiscard]] std::vector<OccupancyGrid> layers_of(const PlanningScenario& scenario);

}  // namespace tandem
