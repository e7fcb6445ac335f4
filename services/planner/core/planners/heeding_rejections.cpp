#include "services/planner/core/planners/heeding_rejections.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "services/planner/core/baselines/team_walk.hpp"

namespace tandem {
namespace {

constexpr int kNearest = 40;
constexpr std::size_t kTried = 3;  ///< first steps of each member, and more of them only while all lead to the rejected
constexpr double kExponent = 1.5;  ///< of the time, when first steps are put in order

struct FirstStep {
  std::size_t member = 0;
  TimedPath committed;  ///< what was committed before, and the step
};

bool is_rejected(const SearchProblem& problem, const JointPlan& plan) {
  return std::ranges::any_of(problem.rejected, [&](const auto& rejected) { return is_like(plan.paths, rejected); });
}

/// For each member its first steps, the best ones first.
std::vector<std::vector<FirstStep>> first_steps(const SearchProblem& problem) {
  const PreparedProblem prepared(problem);
  const TeamWalk walk(prepared, kNearest);
  std::vector<std::vector<FirstStep>> steps(problem.members.size());
  for (std::size_t m = 0; m < steps.size(); ++m) {
    if (prepared.members()[m].start < 0) continue;
    std::vector<WalkOption> options = walk.options(static_cast<int>(m));
    std::erase_if(options, [](const WalkOption& option) { return option.time_s <= 0.0; });
    std::ranges::stable_sort(options, std::greater{},
                             [](const WalkOption& option) { return option.gain / std::pow(option.time_s, kExponent); });
    for (const WalkOption& option : options) steps[m].push_back({m, prepared.path(m, {option.place})});
  }
  return steps;
}

}  // namespace

void HeedingRejections::begin(const SearchProblem& problem, Rng rng) {
  problem_ = problem;
  planner_->begin(problem_, rng);
  if (problem.rejected.empty()) return;
  best_ = planner_->best();
  if (!is_rejected(problem, best_)) return;
  const auto steps = first_steps(problem);
  std::size_t most = 0;
  for (const auto& of_member : steps) most = std::max(most, of_member.size());
  const FirstStep* chosen = nullptr;
  const auto begin_with = [&](const FirstStep& step) {
    problem_ = problem;
    problem_.members[step.member].committed = step.committed;
    planner_->begin(problem_, rng);
  };
  for (std::size_t rank = 0; rank < most && (rank < kTried || is_rejected(problem, best_)); ++rank) {
    for (const auto& of_member : steps) {
      if (rank >= of_member.size()) continue;
      begin_with(of_member[rank]);
      const JointPlan plan = planner_->best();
      if (plan.value_s >= best_.value_s) continue;
      best_ = plan;
      chosen = &of_member[rank];
    }
  }
  if (chosen != nullptr) {
    begin_with(*chosen);
  } else {
    problem_ = problem;
    planner_->begin(problem_, rng);
  }
}

void HeedingRejections::run(int rollouts, const std::function<bool()>& stop) {
  if (problem_.rejected.empty()) {
    planner_->run(rollouts, stop);
    return;
  }
  // One by one, so that the plan does not depend on how rollouts are cut into calls.
  for (int i = 0; i < rollouts && !(stop && stop()); ++i) {
    const int before = planner_->rollouts();
    planner_->run(1, {});
    if (planner_->rollouts() == before) return;  // makes one plan and never a better one
    JointPlan plan = planner_->best();
    if (plan.value_s < best_.value_s) best_ = std::move(plan);
  }
}

}  // namespace tandem
