#include "services/planner/core/team/joint_walk.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

/// Some who start at one place of a hall of 16 m x 10 m.
struct Hall {
  explicit Hall(std::vector<Searcher> searchers) : search(empty_room(16, 10), {3, 3}, std::move(searchers)) {}
  SearchCase search;
  PreparedProblem prepared{search.problem};
  TeamGround ground = team_ground(prepared);
};

TEST(JointWalk, ChoicesComeBestFirstAndNeverMoreThanAsked) {
  Hall hall({test_person()});
  JointWalk walk(hall.ground, {});
  const auto choices = walk.choices(0, 4);

  ASSERT_FALSE(choices.empty());
  EXPECT_LE(choices.size(), 4U);
  for (std::size_t i = 1; i < choices.size(); ++i) EXPECT_GE(choices[i - 1].score, choices[i].score);
}

TEST(JointWalk, WhatOneHasPromisedToLookAtIsWorthLessToTheOther) {
  Hall hall({test_person(), test_person()});
  JointWalk walk(hall.ground, {});
  const Choice best = walk.choices(0, 1).front();
  const auto gain_of_best = [&](int member) {
    for (const Choice& choice : walk.choices(member, 100)) {
      if (choice.place == best.place) return choice.gain;
    }
    return 0.0F;
  };
  EXPECT_FLOAT_EQ(gain_of_best(1), best.gain);  // equal members, equal sets
  walk.choose(0, best.place);
  EXPECT_LT(gain_of_best(1), best.gain);
}

TEST(JointWalk, WhoArrivesFirstChoosesNextUntilAllAreAtTheEnd) {
  Hall hall({test_person(), test_robot()});
  JointWalk walk(hall.ground, {});
  EXPECT_EQ(walk.next_member(), 0);
  walk.choose(0, walk.choices(0, 1).front().place);
  EXPECT_EQ(walk.next_member(), 1);
  int chosen = 1;
  for (int member = walk.next_member(); member >= 0; member = walk.next_member(), ++chosen) {
    ASSERT_LT(chosen, 300);
    walk.choose(member, walk.choices(member, 1).front().place);
  }
  EXPECT_GT(walk.routes()[0].size(), 1U);
  EXPECT_GT(walk.routes()[1].size(), 1U);
}

TEST(JointWalk, ARestartForgetsWhatWasChosen) {
  Hall hall({test_person()});
  JointWalk walk(hall.ground, {});
  const float before = walk.mass_left();
  walk.choose(0, walk.choices(0, 1).front().place);
  EXPECT_LT(walk.mass_left(), before);
  walk.restart();
  EXPECT_EQ(walk.mass_left(), before);
  EXPECT_TRUE(walk.routes()[0].empty());
}

}  // namespace
}  // namespace tandem
