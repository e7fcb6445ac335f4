#include "services/planner/core/tasks/task_model.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/tasks.hpp"

namespace tandem {
namespace {

using Eigen::Vector2d;

std::vector<TaskAction> actions_of(TaskModel& model, const TaskState& state) {
  std::vector<TaskAction> actions;
  model.actions(state, actions);
  return actions;
}

TaskAction visit_of(TaskModel& model, const TaskState& state, int source, StayEnd until = StayEnd::Consumed) {
  for (const TaskAction& action : actions_of(model, state)) {
    if (action.kind == TaskActionKind::Visit && action.source == source && action.until == until) return action;
  }
  ADD_FAILURE() << "no visit of " << source;
  return {};
}

bool offers(TaskModel& model, const TaskState& state, TaskActionKind kind) {
  const auto actions = actions_of(model, state);
  return std::ranges::any_of(actions, [&](const TaskAction& action) { return action.kind == kind; });
}

TEST(TaskModel, AVisitLastsUntilThePoolIsEmpty) {
  // 3 m there; from 2.5 m on it draws 2/s from a pool of 7: 3.5 s, empty at 6 s.
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)}, {disc_source("s", {3.0, 0.0}, 0.5, 2.0, 7.0)}, {}, 20.0);
  TaskModel model{problem};
  const TaskState start = model.start();
  const TaskState after = model.after(start, visit_of(model, start, 0));
  EXPECT_EQ(after.now_ms, 6000);
  EXPECT_NEAR(after.value, 7.0, 1e-9);
  EXPECT_EQ(model.decider(after), 0);
  EXPECT_FALSE(model.is_hopeful(after, 0, 0));
}

TEST(TaskModel, WhoComesTooEarlyWaitsUntilAMateHasOpenedTheSource) {
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0), task_agent("b", 0.0, 5.0)},
              {spot("key", 8.0, 5.0, 1.0, {"b"}), spot("door", 2.0, 0.0, 3.0, {"a"})}, {strict("key", "door")}, 30.0);
  TaskModel model{problem};
  TaskState state = model.start();
  state = model.after(state, visit_of(model, state, 1));
  state = model.after(state, visit_of(model, state, 0));
  // The first decision is due when b has the key, at 8 s; a, there since 2 s, has got the door at that instant.
  EXPECT_NEAR(static_cast<double>(state.now_ms), 8000.0, 2.0);
  EXPECT_NEAR(state.value, 4.0, 1e-6);
}

TEST(TaskModel, AnUnlimitedSourceIsLeftJustInTimeForAnother) {
  // Stay at "view" (rate 1) until 20 - 4 m - 0.5 s of drawing = 15.5 s.
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0)},
              {disc_source("view", {2.0, 0.0}, 0.1, 1.0), disc_source("last", {6.0, 0.0}, 0.1, 2.0, 1.0)}, {}, 20.0);
  TaskModel model{problem};
  const TaskState start = model.start();
  const TaskState after = model.after(start, visit_of(model, start, 0, StayEnd::InTimeFor));
  EXPECT_EQ(after.now_ms, 15500);
}

TEST(TaskModel, SomeActionsAreOnlyOfferedWhereTheyMatter) {
  const TaskProblem alone = task_of({task_agent("a", 0.0, 0.0)}, {spot("s", 1.0, 0.0, 1.0)}, {}, 5.0);
  TaskModel model{alone};
  EXPECT_FALSE(offers(model, model.start(), TaskActionKind::Hold));
  EXPECT_FALSE(offers(model, model.start(), TaskActionKind::Accompany));
  EXPECT_FALSE(offers(model, model.start(), TaskActionKind::Goal));
  EXPECT_TRUE(offers(model, model.start(), TaskActionKind::Wait));
}

TEST(TaskModel, HoldingLetsAMateGoFirst) {
  // b may only take j after a took i, which pays nothing later: b holds until a has it.
  const TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0), task_agent("b", 0.0, 5.0)},
              {spot("i", 4.0, 0.0, 5.0, {"a"}), spot("j", 1.0, 5.0, 5.0, {"b"})}, {soft("i", "j")}, 30.0);
  TaskModel model{problem};
  TaskState state = model.start();
  state = model.after(state, visit_of(model, state, 0));
  ASSERT_EQ(model.decider(state), 1);
  ASSERT_TRUE(offers(model, state, TaskActionKind::Hold));
  TaskAction hold;
  hold.kind = TaskActionKind::Hold;
  hold.agent = 1;
  state = model.after(state, hold);
  EXPECT_EQ(state.now_ms, 4000);
  EXPECT_EQ(model.decider(state), 0);  // both are free again
  EXPECT_EQ(state.agents[1].occupation, Occupation::Free);
}

TEST(TaskModel, WhatIsCommittedIsWalkedFirst) {
  TaskProblem problem = task_of({task_agent("a", 0.0, 0.0)}, {spot("s", 0.0, 5.0, 1.0)}, {}, 20.0);
  problem.agents[0].committed.points = {{0.0, {0.0, 0.0}}, {3.0, {3.0, 0.0}}};
  TaskModel model{problem};
  const TaskState start = model.start();
  EXPECT_EQ(start.now_ms, 3000);
  EXPECT_EQ(model.decider(start), 0);
  EXPECT_NEAR((start.agents[0].point_in_map - Vector2d{3.0, 0.0}).norm(), 0.0, 1e-9);
}

TEST(TaskModel, AFixedPlanIsNotDecidedAnyMore) {
  TaskProblem problem =
      task_of({task_agent("a", 0.0, 0.0), task_agent("other", 0.0, 5.0)}, {spot("s", 2.0, 5.0, 1.0)}, {}, 10.0);
  problem.agents[1].committed.points = {{0.0, {0.0, 5.0}}, {2.0, {2.0, 5.0}}};
  problem.agents[1].freedom = TaskFreedom::Fixed;
  TaskModel model{problem};
  TaskState state = model.start();
  TaskAction wait;
  wait.agent = 0;
  state = model.after(state, wait);
  EXPECT_EQ(model.decider(state), TaskModel::kNobody);
  EXPECT_NEAR(state.value, 1.0, 1e-9);  // the other passes it
}

TEST(TaskModel, ARobotThatSeesOnlyAheadTurnsFirst) {
  TaskProblem problem = task_of({task_agent("a", 0.0, 0.0)}, {spot("s", 0.0, 2.0, 1.0)}, {}, 20.0);
  problem.agents[0].searcher.field_of_view_rad = 1.0;
  problem.agents[0].searcher.turn_rate_radps = 0.5;
  TaskModel model{problem};
  const TaskState start = model.start();
  // A quarter turn takes pi s, then 2 m.
  EXPECT_EQ(model.arrival_ms(start, visit_of(model, start, 0)), 5142);
}

TEST(TaskModel, AProblemThatDoesNotFitTogetherIsNamed) {
  TaskProblem problem = task_of({task_agent("a", 0.0, 0.0)}, {}, {}, 5.0);
  EXPECT_FALSE(problem_of(problem));
  problem.world.agents = {"b"};
  EXPECT_EQ(problem_of(problem), "agent a is not in its place");
  problem.world.agents = {"a", "b"};
  EXPECT_EQ(problem_of(problem), "the agents are not those of the world");
}

}  // namespace
}  // namespace tandem
