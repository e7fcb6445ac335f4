#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/tasks/task_bound.hpp"
#include "services/planner/core/tasks/task_courses.hpp"
#include "services/planner/core/tasks/task_incumbent.hpp"
#include "services/planner/core/tasks/task_score.hpp"
#include "services/planner/core/tasks/task_sequences.hpp"

namespace tandem {

struct TaskTreeOptions {
  double exploration = 0.4;  ///< of PUCT, in units of the range of values
  double widening = 2.0;     ///< a node visited n times looks at widening * n^widening_exponent decisions
  double widening_exponent = 0.5;
  std::size_t most_nodes = 100000;  ///< then it only rolls out
};

/// Monte Carlo tree search over the decisions of a TaskModel.
///
/// Selection: PUCT on the best value below a child (the world is deterministic) with the score as prior (digest F3).
/// A child whose optimistic bound cannot beat the incumbent is closed, and a node whose children are all closed too;
/// the root's bound is certified. Small worlds are searched to the end.
class TaskTree {
 public:
  /// `model` and `incumbent` must outlive it.
  TaskTree(TaskModel& model, TaskIncumbent& incumbent, const TaskTreeOptions& options = {});

  /// Offers plans of greedy decisions, each time the best by score, with several degrees of impatience.
  void offer_greedy_plans();
  /// Offers the plan in which everybody goes on as in the plan in execution, then greedily.
  void offer_plan_in_execution();
  /// One walk down the tree, one new node, one randomised greedy course from there; mostly, a good plan with a
  /// few things changed at random (simulated annealing).
  void roll_out(Rng& rng);
  /// Everything was looked at or ruled out.
  [[nodiscard]] bool is_finished() const { return nodes_.front().is_closed; }
  /// No plan that was not ruled out is worth more.
  [[nodiscard]] double bound() const { return nodes_.front().bound; }

 private:
  struct Child {
    TaskAction action;
    double prior = 0.0;
    std::int32_t node = -1;
  };
  struct Node {
    TaskState state;
    std::vector<Child> children;  ///< the most promising first
    double bound = 0.0;
    double best = 0.0;  ///< best value below
    std::int32_t visits = 0;
    bool is_expanded = false;
    bool is_closed = false;
  };

  void walk_down(Rng& rng);
  void change_current(Rng& rng);
  double finish_as_in(const TaskSequences& sequences, std::int32_t told, std::vector<TaskAction>& decisions);
  void expand(Node& node);
  [[nodiscard]] std::size_t select(const Node& node) const;
  std::int32_t add_node(TaskState state);
  void close(Node& node);
  template <typename Choice>
  double finish(TaskState state, std::vector<TaskAction>& decisions, const Choice& choice);
  double offered(const std::vector<TaskAction>& decisions, const TaskState& final_state);
  [[nodiscard]] std::size_t greedy_choice(const TaskState& state, const std::vector<TaskAction>& actions,
                                          double impatience);
  [[nodiscard]] std::size_t random_choice(const TaskState& state, double impatience, Rng& rng);
  double finish_at_random(TaskState state, std::vector<TaskAction>& decisions, Rng& rng);
  void back_up(const std::vector<std::int32_t>& path, double value);

  TaskModel& model_;
  TaskIncumbent& incumbent_;
  TaskTreeOptions options_;
  TaskBound bound_of_;
  TaskScore score_;
  std::deque<Node> nodes_;  ///< a deque: nodes stay where they are
  std::vector<std::int32_t> free_nodes_;
  TaskCourses courses_;
  double lowest_ = 0.0;  ///< value seen
  bool has_values_ = false;
  std::int64_t rollouts_ = 0;
  std::vector<TaskAction> current_;  ///< the plan that is being changed
  double current_value_ = 0.0;
  std::vector<TaskAction> changed_;
  std::vector<std::size_t> next_in_sequence_;  ///< by agent
  std::vector<TaskAction> actions_;
  std::vector<double> scores_;
};

}  // namespace tandem
