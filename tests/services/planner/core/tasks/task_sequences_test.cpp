#include "services/planner/core/tasks/task_sequences.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tandem {
namespace {

TaskAction visit(int agent, int source, StayEnd until = StayEnd::Consumed) {
  TaskAction action;
  action.kind = TaskActionKind::Visit;
  action.until = until;
  action.agent = static_cast<std::int16_t>(agent);
  action.source = static_cast<std::int16_t>(source);
  return action;
}

TaskAction wait(int agent) {
  TaskAction action;
  action.agent = static_cast<std::int16_t>(agent);
  return action;
}

TEST(TaskSequences, AreTheDecisionsOfEachAgent) {
  const TaskSequences sequences = sequences_of({visit(0, 3), visit(1, 4), visit(0, 5), wait(1)}, 2);
  EXPECT_EQ(sequences[0], (std::vector<TaskAction>{visit(0, 3), visit(0, 5)}));
  EXPECT_EQ(sequences[1], (std::vector<TaskAction>{visit(1, 4), wait(1)}));
}

TEST(TaskSequences, AreFollowedAsFarAsPossible) {
  const std::vector<TaskAction> sequence{visit(0, 3), visit(0, 5), visit(0, 6)};
  const std::vector<TaskAction> possible{visit(0, 5), visit(0, 6), wait(0)};  // 3 is gone
  std::size_t next = 0;
  EXPECT_EQ(following(sequence, next, possible), 0);
  EXPECT_EQ(following(sequence, next, possible), 1);
  EXPECT_EQ(following(sequence, next, possible), -1);
}

TEST(TaskSequences, TheEndOfAStayIsKeptIfItIsStillPossible) {
  const std::vector<TaskAction> sequence{visit(0, 3, StayEnd::Triggered)};
  std::size_t next = 0;
  EXPECT_EQ(following(sequence, next, {visit(0, 3), visit(0, 3, StayEnd::Triggered)}), 1);
  next = 0;
  EXPECT_EQ(following(sequence, next, {visit(0, 3)}), 0);
}

TEST(TaskSequences, AChangeReachesEveryOrderAndEveryAgent) {
  Rng rng{1};
  bool swapped = false;
  bool given_away = false;
  bool dropped = false;
  bool added = false;
  for (int i = 0; i < 500; ++i) {
    TaskSequences sequences{{visit(0, 0), visit(0, 1)}, {}};
    change(sequences, 4, rng);
    swapped |= sequences[0].size() == 2 && sequences[0][0].source == 1 && sequences[0][1].source == 0;
    given_away |= sequences[1].size() == 1 && sequences[0].size() == 1;
    dropped |= sequences[0].size() + sequences[1].size() < 2;
    added |= sequences[0].size() + sequences[1].size() > 2;
  }
  EXPECT_TRUE(swapped && given_away && dropped && added);
}

}  // namespace
}  // namespace tandem
