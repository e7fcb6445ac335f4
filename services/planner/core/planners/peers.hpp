#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "services/planner/core/planners/planner_options.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// Makes a planner with the options that are given, and asks for each of them once.
using MakePlanner = std::function<std::unique_ptr<Planner>(PlannerOptions&)>;

/// The paper's planner and the baselines, by name: what ours is measured against. None proposes a plan again
/// that a person rejected.
[[nodiscard]] std::map<std::string, MakePlanner> peers();

}  // namespace tandem
