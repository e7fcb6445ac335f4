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
  bool overtaken = false;      ///< the person has edited something that it does not know of
  bool leads_behind = false;   ///< the robot's path ends behind the person
  bool while_reading = false;  ///< begun while another plan was proposed and not accepted yet
};

}  // namespace tandem
