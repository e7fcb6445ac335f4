#pragma once

#include <optional>
#include <string>

#include "services/planner/core/acceptance/plan_acceptance.hpp"
#include "services/planner/core/planner_config.hpp"

namespace tandem {

/// What speaks for or against a new plan, as it is now.
struct PlanSituation {
  PlanStanding standing = PlanStanding::None;
  double age_s = 0.0;              ///< of the plan, since it was proposed
  bool blocked = false;            ///< for long enough to be given up
  bool robot_finished = false;     ///< its path
  bool goal_reached = false;       ///< the person reached the goal they fixed
  bool person_said_where = false;  ///< the person edited the belief since the plan was made
  bool person_drew = false;        ///< the person drew or removed a source since
  bool edits_must_wait = false;    ///< edits have put off the acceptance of a plan already: see replan_reason()
  bool person_is_new = false;      ///< is known, but the plan was made without
  bool robot_is_ahead = false;     ///< of the person, whom it is to stay behind
  double surprise = 0.0;           ///< P(not found) now, minus what the plan promised for now
  double person_off_plan_s = 0.0;  ///< for how long the person has been elsewhere
};

/// Why to make a new plan, for people; none while the plan holds. (*Replan* itself ends the plan's standing.)
///
/// Edits put off the acceptance of a plan only once: what is edited while the next proposal is read waits until
/// everybody has heard that it is accepted, and then makes one plan. So nobody who keeps editing keeps the team from
/// moving.
[[nodiscard]] std::optional<std::string> replan_reason(const PlanSituation& situation, const PlannerConfig& config);

}  // namespace tandem
