#include "services/planner/core/tasks/task_courses.hpp"

#include <utility>

namespace tandem {

TaskCourses::TaskCourses(TaskModel& model, TaskState start) : model_(model) {
  add(std::move(start));
}

std::int32_t TaskCourses::add(TaskState state) {
  if (used_ == moments_.size()) moments_.emplace_back();
  Moment& moment = moments_[used_];
  moment.state = std::move(state);
  moment.noted_choice = -1;
  moment.has_actions = false;
  return static_cast<std::int32_t>(used_++);
}

const std::vector<TaskAction>& TaskCourses::actions(std::int32_t number) {
  Moment& moment = moments_[index(number)];
  if (!moment.has_actions) {
    model_.actions(moment.state, moment.actions);
    moment.next.assign(moment.actions.size(), -1);
    moment.has_actions = true;
  }
  return moment.actions;
}

std::int32_t TaskCourses::after(std::int32_t number, std::size_t action) {
  const TaskAction& chosen = actions(number)[action];
  Moment& moment = moments_[index(number)];
  if (moment.next[action] < 0) moment.next[action] = add(model_.after(moment.state, chosen));
  return moment.next[action];
}

void TaskCourses::forget() {
  used_ = 1;
  Moment& start = moments_.front();
  start.next.assign(start.actions.size(), -1);
}

}  // namespace tandem
