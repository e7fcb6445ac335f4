#include "services/planner/core/tasks/task_planner.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <map>

#include "services/planner/core/tasks/task_branch_and_bound.hpp"
#include "services/planner/core/tasks/task_replay.hpp"
#include "services/planner/core/tasks/task_tree.hpp"

namespace tandem {
namespace {

constexpr std::int64_t kDecisionsPerRollout = 1;  ///< of branch and bound: about half of the time
constexpr double kSameValue = 1e-8;               ///< values nearer to each other, relatively, count as equal

double slack_of(double value) {
  return kSameValue * std::max(1.0, std::abs(value));
}

/// The best complete plan by the rules of digest A3, and the best of each set of messages.
class BestPlan : public TaskIncumbent {
 public:
  explicit BestPlan(TaskModel& model) : model_(model) {}

  void offer(const std::vector<TaskAction>& decisions, const TaskState& final_state) override {
    const double value = final_state.value;
    if (final_state.told == 0) untold_ = std::max(untold_, value);
    if (found_ && !is_better(decisions, value, final_state.makespan_ms)) return;
    const std::size_t common = visits_in_common(model_.problem().world, decisions, model_.problem().in_execution);
    if (is_rejected(decisions)) return;
    best_ = {decisions, value, final_state.makespan_ms};
    common_ = common;
    found_ = true;
  }

  [[nodiscard]] bool can_be_beaten_by(double bound, std::int64_t least_makespan_ms) const override {
    if (!found_) return true;
    const double slack = slack_of(best_.value);
    return bound > best_.value + slack || (bound >= best_.value - slack && least_makespan_ms < best_.makespan_ms);
  }

  [[nodiscard]] double value() const override {
    return found_ ? best_.value : -std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] const std::vector<TaskAction>& decisions() const override { return best_.decisions; }
  [[nodiscard]] double untold() const { return untold_; }
  [[nodiscard]] bool is_found() const { return found_; }

 private:
  [[nodiscard]] bool is_better(const std::vector<TaskAction>& decisions, double value, std::int64_t makespan_ms) const {
    const double slack = slack_of(best_.value);
    if (value > best_.value + slack) return true;
    if (value < best_.value - slack) return false;
    if (makespan_ms != best_.makespan_ms) return makespan_ms < best_.makespan_ms;
    const std::size_t common = visits_in_common(model_.problem().world, decisions, model_.problem().in_execution);
    if (common != common_) return common > common_;
    return decisions < best_.decisions;
  }

  [[nodiscard]] bool is_rejected(const std::vector<TaskAction>& decisions) {
    if (model_.problem().rejected.empty()) return false;
    const TaskPlan plan = replayed(model_, decisions);
    std::vector<TimedPath> paths;
    for (const TaskAgentPlan& agent : plan.agents) paths.push_back(agent.path);
    for (const auto& rejected : model_.problem().rejected) {
      if (walks_like(paths, rejected)) return true;
    }
    return false;
  }

  TaskModel& model_;
  TaskCandidate best_;
  std::size_t common_ = 0;
  double untold_ = -std::numeric_limits<double>::infinity();
  bool found_ = false;
};

}  // namespace

class TaskPlanner::Impl {
 public:
  Impl(TaskProblem given, Rng generator)
      : problem(std::move(given)), rng(generator), model(problem), best(model), tree(model, best), proof(model, best) {
    tree.offer_greedy_plans();
    tree.offer_plan_in_execution();
  }

  const TaskProblem problem;
  Rng rng;
  TaskModel model;
  BestPlan best;
  TaskTree tree;
  TaskBranchAndBound proof;
  std::int64_t rollouts = 0;
};

TaskPlanner::TaskPlanner(TaskProblem problem, Rng rng) : impl_(std::make_unique<Impl>(std::move(problem), rng)) {}
TaskPlanner::~TaskPlanner() = default;
TaskPlanner::TaskPlanner(TaskPlanner&&) noexcept = default;
TaskPlanner& TaskPlanner::operator=(TaskPlanner&&) noexcept = default;

void TaskPlanner::run(std::int64_t rollouts, const std::function<bool()>& stop) {
  for (std::int64_t i = 0; i < rollouts && !impl_->tree.is_finished(); ++i) {
    impl_->tree.roll_out(impl_->rng);
    impl_->proof.go_on(kDecisionsPerRollout);
    ++impl_->rollouts;
    if (stop && stop()) return;
  }
}

bool TaskPlanner::is_finished() const {
  return impl_->tree.is_finished();
}

std::int64_t TaskPlanner::rollouts() const {
  return impl_->rollouts;
}

double TaskPlanner::value() const {
  return impl_->best.value();
}

double TaskPlanner::upper_bound() const {
  if (impl_->tree.is_finished()) return impl_->best.value();
  return std::max(std::min(impl_->tree.bound(), impl_->proof.bound()), impl_->best.value());
}

std::optional<TaskPlan> TaskPlanner::best() {
  if (!impl_->best.is_found()) return std::nullopt;
  TaskPlan plan = replayed(impl_->model, impl_->best.decisions());
  plan.value_untold = plan.informs.empty() ? plan.value : impl_->best.untold();
  plan.upper_bound = upper_bound();
  plan.rollouts = impl_->rollouts;
  return plan;
}

std::optional<TaskPlan> plan_task(const TaskProblem& problem, std::int64_t rollouts, Rng rng) {
  TaskPlanner planner{problem, rng};
  planner.run(rollouts);
  return planner.best();
}

}  // namespace tandem
