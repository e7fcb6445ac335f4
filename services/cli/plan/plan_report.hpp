#pragma once

#include <string>

#include "services/cli/plan/plan_run.hpp"

namespace tandem::cli {

/// The plan for programs: one JSON object, with a line's end. Of a search `value` is the expected time to find, lower
/// is better; of a task it is the reward, higher is better, and what only a search has is null.
[[nodiscard]] std::string plan_json(const PlanningScenario& scenario, const PlanRequest& request,
                                    const PlannedScenario& planned);

/// The plan for people.
[[nodiscard]] std::string plan_text(const PlanningScenario& scenario, const PlanRequest& request,
                                    const PlannedScenario& planned);

/// The plan as a picture of it shows it. Throws MapError.
[[nodiscard]] PlanPicture picture_of(const PlanningScenario& scenario, const PlanRequest& request,
                                     const PlannedScenario& planned);

}  // namespace tandem::cli
