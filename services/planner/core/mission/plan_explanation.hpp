#pragma once

#include <optional>
#include <string>

namespace tandem {

/// What a plan is explained with.
struct PlanFacts {
  std::string occasion;  ///< why there is a new plan, e.g. "first plan"
  double robot_way_m = 0.0;
  bool robot_goal_fixed = false;       ///< a person chose where it ends
  std::optional<double> person_way_m;  ///< none: planned without
  bool person_goal_fixed = false;
  double probability_found = 0.0;
  double horizon_s = 0.0;
  std::optional<double> without_person_s;  ///< what the expected time grows by if the person stays where they are
};

/// Why this plan, in a sentence or two for the person it is made for.
[[nodiscard]] std::string explanation_of(const PlanFacts& facts);

}  // namespace tandem
