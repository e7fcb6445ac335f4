#include "services/planner/core/team/course.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

/// Some who start at one place of a hall of 16 m x 10 m.
SearchCase team_in_a_hall(std::vector<Searcher> searchers) {
  return {empty_room(16, 10), {3, 3}, std::move(searchers)};
}

TEST(Course, ChoicesComeBestFirstAndNeverMoreThanAsked) {
  SearchCase hall = team_in_a_hall({test_person()});
  const PreparedProblem prepared{hall.problem};
  const auto choices = Course{prepared}.choices(0, 4);

  ASSERT_FALSE(choices.empty());
  EXPECT_LE(choices.size(), 4U);
  for (std::size_t i = 1; i < choices.size(); ++i) EXPECT_GE(choices[i - 1].score, choices[i].score);
}

TEST(Course, WhatOneHasPromisedToLookAtIsWorthLessToTheOther) {
  SearchCase hall = team_in_a_hall({test_person(), test_person()});
  const PreparedProblem prepared{hall.problem};
  Course course{prepared};
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
  SearchCase hall = team_in_a_hall({test_person(), test_robot()});
  const PreparedProblem prepared{hall.problem};
  Course course{prepared};
  EXPECT_EQ(course.next_member(), 0);
  course.choose(0, course.choices(0, 1).front().place);
  EXPECT_EQ(course.next_member(), 1);
  int choices_made = 1;
  for (int member = course.next_member(); member >= 0; member = course.next_member(), ++choices_made) {
    ASSERT_LT(choices_made, 200);
    course.choose(member, course.choices(member, 1).front().place);
  }
  EXPECT_GT(course.routes()[0].size(), 1U);
  EXPECT_GT(course.routes()[1].size(), 1U);
}

}  // namespace
}  // namespace tandem
