#include "services/planner/core/tasks/task_branch_and_bound.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace tandem {
namespace {

/// A makespan no plan has: plans of equal value are left to the tree, which looks for the one that ends first.
constexpr std::int64_t kOnlyByValue = std::numeric_limits<std::int64_t>::max();

}  // namespace

TaskBranchAndBound::TaskBranchAndBound(TaskModel& model, TaskIncumbent& incumbent)
    : model_(model), incumbent_(incumbent), bound_of_(model) {
  const TaskState start = model.start();
  branch(start, bound_of_(start));
  if (levels_.back().branches.empty()) levels_.clear();  // nobody has anything to decide
}

void TaskBranchAndBound::branch(const TaskState& state, double bound) {
  model_.actions(state, actions_);
  Level level;
  level.branches.reserve(actions_.size());
  for (const TaskAction& action : actions_) {
    Branch& next = level.branches.emplace_back(action, model_.after(state, action));
    next.bound = std::min(bound, bound_of_(next.state, incumbent_.value()));
  }
  credit_ -= static_cast<std::int64_t>(actions_.size());
  std::ranges::stable_sort(level.branches, std::greater{}, &Branch::bound);
  levels_.push_back(std::move(level));
}

void TaskBranchAndBound::go_on(std::int64_t decisions) {
  if (is_finished()) return;
  credit_ += decisions;
  while (credit_ > 0 && !levels_.empty()) {
    Level& level = levels_.back();
    if (level.next == level.branches.size()) {
      levels_.pop_back();
      if (!levels_.empty()) decisions_.pop_back();
      continue;
    }
    Branch& next = level.branches[level.next++];
    if (!incumbent_.can_be_beaten_by(next.bound, kOnlyByValue)) continue;
    decisions_.push_back(next.action);
    if (model_.decider(next.state) == TaskModel::kNobody) {
      incumbent_.offer(decisions_, next.state);
      decisions_.pop_back();
    } else {
      const Branch here = std::move(next);  // the levels may move
      branch(here.state, here.bound);
    }
  }
}

double TaskBranchAndBound::bound() const {
  double bound = -std::numeric_limits<double>::infinity();
  for (const Level& level : levels_) {
    if (level.next < level.branches.size()) bound = std::max(bound, level.branches[level.next].bound);
  }
  return bound;
}

}  // namespace tandem
