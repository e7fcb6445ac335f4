#include "services/planner/core/tasks/task_state.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(TaskState, AnAgentArrivesAtTheEndOfItsLeg) {
  const TaskLeg leg{{{0, {0.0, 0.0}, 0.0, 0.0}, {1500, {1.0, 0.0}, 0.0, 0.0}, {4000, {1.0, 2.5}, 0.0, 1.57}}};
  EXPECT_EQ(leg.duration_ms(), 4000);
  TaskAgentState agent;
  agent.leg = &leg;
  agent.leg_start_ms = 2000;
  EXPECT_EQ(agent.arrival_ms(), 6000);
}

TEST(TaskState, WhoGoesNowhereIsThere) {
  TaskAgentState agent;
  agent.leg_start_ms = 2000;
  EXPECT_EQ(agent.arrival_ms(), 2000);
}

// Ties between plans are broken by the order of their decisions, so it must not change by chance.
TEST(TaskState, ActionsAreOrderedByKindThenAgentThenSource) {
  const TaskAction tell{.kind = TaskActionKind::Tell};
  TaskAction first{.kind = TaskActionKind::Visit, .agent = 0, .source = 5};
  TaskAction second{.kind = TaskActionKind::Visit, .agent = 1, .source = 2};
  EXPECT_LT(tell, first);
  EXPECT_LT(first, second);
  second.agent = 0;
  EXPECT_GT(first, second);
  second.source = 5;
  EXPECT_EQ(first, second);
  second.until = StayEnd::Triggered;
  EXPECT_LT(first, second);
  EXPECT_LT(second, (TaskAction{.kind = TaskActionKind::Wait}));
}

}  // namespace
}  // namespace tandem
