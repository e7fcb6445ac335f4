#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "services/planner/core/tasks/task_model.hpp"

namespace tandem {

/// Remembers the states that chains of decisions led to, and what can be decided there: most changes of a plan leave
/// its beginning as it is, and a plan that was seen before costs nothing.
class TaskCourses {
 public:
  /// `model` must outlive it.
  TaskCourses(TaskModel& model, TaskState start);

  /// The number of the state in which nothing is decided yet.
  static constexpr std::int32_t kStart = 0;
  [[nodiscard]] const TaskState& state(std::int32_t number) const { return moments_[index(number)].state; }
  /// What can be decided in the state; nothing where the course is over.
  [[nodiscard]] const std::vector<TaskAction>& actions(std::int32_t number);
  /// The state after the one of actions() with this index.
  [[nodiscard]] std::int32_t after(std::int32_t number, std::size_t action);
  /// For the one who decides: a choice it made in the state, to be looked up later; -1 if there is none.
  [[nodiscard]] std::int32_t& noted_choice(std::int32_t number) { return moments_[index(number)].noted_choice; }

  [[nodiscard]] std::size_t size() const { return used_; }
  /// Keeps the start only; all other numbers are void.
  void forget();

 private:
  struct Moment {
    TaskState state;
    std::vector<TaskAction> actions;
    std::vector<std::int32_t> next;  ///< by action; -1: not looked at yet
    std::int32_t noted_choice = -1;
    bool has_actions = false;
  };
  [[nodiscard]] static std::size_t index(std::int32_t number) { return static_cast<std::size_t>(number); }
  std::int32_t add(TaskState state);

  TaskModel& model_;
  std::deque<Moment> moments_;  ///< a deque: they stay where they are
  std::size_t used_ = 0;        ///< of moments_; the others keep their memory for later
};

}  // namespace tandem
