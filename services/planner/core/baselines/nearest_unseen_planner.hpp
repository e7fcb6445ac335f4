#pragma once

#include "services/planner/core/baselines/one_plan_planner.hpp"

namespace tandem {

/// Whoever arrives first goes to the nearest lookout that shows something nobody is on the way to see.
class NearestUnseenPlanner final : public OnePlanPlanner {
 private:
  [[nodiscard]] Routes routes(const PreparedProblem& problem) const override {
    TeamWalk walk(problem, 1);
    for (int member = walk.next_member(); member >= 0; member = walk.next_member()) {
      const auto options = walk.options(member);
      options.empty() ? walk.stay(member) : walk.go(member, options.front().place);
    }
    return walk.routes();
  }
};

}  // namespace tandem
