#pragma once

#include <memory>

#include "services/planner/core/baselines/team_walk.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

/// A planner that makes one plan and never a better one.
class OnePlanPlanner : public Planner {
 public:
  void begin(const SearchProblem& problem, Rng /*rng*/) final {
    problem_ = std::make_unique<PreparedProblem>(problem);
    best_ = routes(*problem_);
  }
  void run(int /*rollouts*/, const std::function<bool()>& /*stop*/) final {}
  [[nodiscard]] int rollouts() const final { return 0; }
  [[nodiscard]] JointPlan best() final { return problem_->plan(best_); }

 protected:
  [[nodiscard]] virtual Routes routes(const PreparedProblem& problem) const = 0;

 private:
  std::unique_ptr<PreparedProblem> problem_;
  Routes best_;
};

}  // namespace tandem
