#pragma once

#include <memory>
#include <string>

#include "services/planner/core/mission/search_mission.hpp"

namespace tandem {

/// A plan in the making.
struct SearchMission::Computation {
  SearchProblem problem;
  std::unique_ptr<Planner> planner;  ///< of `problem`, so this never moves
  std::string reason;
};

}  // namespace tandem
