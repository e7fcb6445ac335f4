#include "services/planner/core/planners/heeding_rejections.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "services/planner/core/baselines/team_walk.hpp"

namespace tandem {
namespace {

constexpr int kNearest = 40;
constexpr double kExponent = 1.5;      ///< of the time, when first steps are put in order
constexpr int kRolloutsPerCheck = 16;  ///< a whole plan is valued and compared after so many, as that takes long

struct FirstStep {
  std::size_t member = 0;
  TimedPath committed;          ///< what was committed before, and the step
  bool is_as_rejected = false;  ///< the member begins about as in a rejected plan
  double gain_for_time = 0.0;
};

bool is_rejected(const SearchProblem& problem, const JointPlan& plan) {
  return std::ranges::any_of(problem.rejected, [&](const auto& rejected) { return is_like(plan.paths, rejected); });
}

/// Whether a member walks about as in a rejected plan for as long as `path` lasts.
bool is_as_rejected(const SearchProblem& problem, std::size_t member, const TimedPath& path) {
  return std::ranges::any_of(problem.rejected, [&](const auto& rejected) {
    return member < rejected.size() && is_like({path}, {rejected[member]}, path.duration_s());
  });
}

/// For each member its first steps: those that lead elsewhere than a rejected plan before the others, the best first.
std::vector<std::vector<FirstStep>> first_steps(const SearchProblem& problem) {
  const PreparedProblem prepared(problem);
  const TeamWalk walk(prepared, kNearest);
  std::vector<std::vector<FirstStep>> steps(problem.members.size());
  for (std::size_t m = 0; m < steps.size(); ++m) {
    if (prepared.members()[m].start < 0) continue;
    for (const WalkOption& option : walk.options(static_cast<int>(m))) {
      if (option.time_s <= 0.0) continue;
      TimedPath committed = prepared.path(m, {option.place});
      const bool as_rejected = is_as_rejected(problem, m, committed);
      steps[m].push_back({m, std::move(committed), as_rejected, option.gain / std::pow(option.time_s, kExponent)});
    }
    std::ranges::stable_sort(steps[m], [](const FirstStep& a, const FirstStep& b) {
      return a.is_as_rejected != b.is_as_rejected ? b.is_as_rejected : a.gain_for_time > b.gain_for_time;
    });
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
  const FirstStep* begun = nullptr;
  const FirstStep* chosen = nullptr;
  const auto begin_with = [&](const FirstStep* step) {
    if (step == begun) return;
    begun = step;
    problem_ = problem;
    if (step != nullptr) problem_.members[step->member].committed = step->committed;
    planner_->begin(problem_, rng);
  };
  // To begin may take a planner long: one step of each member, and more only while all lead to a rejected plan.
  for (std::size_t rank = 0; rank < most && is_rejected(problem, best_); ++rank) {
    for (const auto& of_member : steps) {
      if (rank >= of_member.size()) continue;
      begin_with(&of_member[rank]);
      JointPlan plan = planner_->best();
      if (plan.value_s >= best_.value_s) continue;
      best_ = std::move(plan);
      chosen = begun;
    }
  }
  begin_with(chosen);
}

void HeedingRejections::run(int rollouts, const std::function<bool()>& stop) {
  if (problem_.rejected.empty()) {
    planner_->run(rollouts, stop);
    return;
  }
  // Compared at fixed numbers of rollouts, so that the plan does not depend on how they are cut into calls.
  for (int left = rollouts; left > 0;) {
    const int before = planner_->rollouts();
    const int until_check = kRolloutsPerCheck - before % kRolloutsPerCheck;
    planner_->run(std::min(left, until_check), stop);
    const int made = planner_->rollouts() - before;
    if (made == until_check) (void)best();
    if (made < std::min(left, until_check)) return;  // stopped, or it makes one plan and never a better one
    left -= made;
  }
}

JointPlan HeedingRejections::best() {
  JointPlan plan = planner_->best();
  if (problem_.rejected.empty()) return plan;
  if (plan.value_s < best_.value_s) best_ = std::move(plan);
  return best_;
}

}  // namespace tandem
