#include "services/planner/core/team/course.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_world.hpp"

namespace tandem {
namespace {

/// Two who start at one place of a hall of 16 m x 10 m.
SearchWorld team_in_a_hall() {
  return {empty_room(16, 10), {3, 3}};
}

TEST(Course, ChoicesComeBestFirstAndNeverMoreThanAsked) {
  SearchWorld world = team_in_a_hall();
  world.add(test_person(), {3, 3});
  const auto choices = Course{world.problem}.choices(0, 4);

  ASSERT_FALSE(choices.empty());
  EXPECT_LE(choices.size(), 4U);
  for (std::size_t i = 1; i < choices.size(); ++i) EXPECT_GE(choices[i - 1].score, choices[i].score);
}

TEST(Course, WhatOneHasPromisedToLookAtIsWorthLessToTheOther) {
  SearchWorld world = team_in_a_hall();
  world.add(test_person(), {3, 3});
  world.add(test_person(), {3, 3});
  Course course{world.problem};
  const Choice best = course.choices(0, 1).front();
  const auto gain_of_best = [&](int member) {
    for (const Choice& choice : course.choices(member, 100)) {
      if (choice.place == best.place) return choice.gain;
    }
    return 0.0;
  };
  EXPECT_DOUBLE_EQ(gain_of_best(1), best.gain);  // equal members, equal sets
  course.choose(0, best.place);
  EXPECT_LT(gain_of_best(1), best.gain);
}

TEST(Course, WhoArrivesFirstChoosesNextUntilAllAreBusyToTheEnd) {
  SearchWorld world = team_in_a_hall();
  world.add(test_person(), {3, 3});
  world.add(test_robot(), {3, 3});
  Course course{world.problem};
  EXPECT_EQ(course.next_member(), 0);
  course.choose(0, course.choices(0, 1).front().place);
  EXPECT_EQ(course.next_member(), 1);
  int choices_made = 1;
  for (int member = course.next_member(); member >= 0; member = course.next_member(), ++choices_made) {
    ASSERT_LT(choices_made, 2 * world.problem.horizon_steps);
    course.choose(member, course.choices(member, 1).front().place);
  }
  EXPECT_GT(course.places()[0].size(), 1U);
  EXPECT_GT(course.places()[1].size(), 1U);
}

}  // namespace
}  // namespace tandem
