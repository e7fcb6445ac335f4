#pragma once

#include <array>
#include <optional>
#include <string>

#include "services/planner/core/mission/search_mission.hpp"

namespace tandem {

/// A plan in the making.
struct SearchMission::Computation {
  TeamProblem problem;
  std::optional<TeamPlanner> planner;  ///< of `problem`, so this never moves
  std::string reason;
  std::array<bool, 2> goal_fixed{};
};

}  // namespace tandem
