#include "services/planner/core/paper/joint_reward.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/services/planner/support/action_trees.hpp"
#include "tests/services/planner/support/search_case.hpp"

namespace tandem {
namespace {

constexpr double kFirstSight = std::numeric_limits<double>::infinity();

TEST(JointReward, APoolPaysOnceWhoeverDrawsOnIt) {
  ActionTree a = hand_tree({{0, 1.0, 0}, {1, 1.0, 1}});
  ActionTree b = hand_tree({{0, 1.0, 0}, {0, 1.0, 2}});
  DetectedMass mass({0.5, 0.3, 0.2}, {&a, &b}, 0.0);
  EXPECT_DOUBLE_EQ(mass.of({2, 1}), 0.8);  // both see cell 0
  EXPECT_DOUBLE_EQ(mass.of({2, 2}), 1.0);
  EXPECT_DOUBLE_EQ(mass.of({0, 2}), 0.2);
}

TEST(JointReward, ASourceHalfDrawnByOnePaysTheOtherAQuarter) {
  ActionTree a = hand_tree({{0, 1.0, 0, 0.5}});
  ActionTree b = hand_tree({{0, 1.0, 0, 0.5}});
  DetectedMass mass({1.0}, {&a, &b}, 0.0);
  EXPECT_DOUBLE_EQ(mass.of({1, 0}), 0.5);
  EXPECT_DOUBLE_EQ(mass.of({1, 1}), 0.75);
}

TEST(JointReward, T20TheOrderOfAgentsDoesNotMatter) {
  ActionTree a = hand_tree({{0, 1.0, 0, 0.5}, {1, 1.0, 1}});
  ActionTree b = hand_tree({{0, 1.0, 0, 0.25}, {0, 1.0, 2}});
  DetectedMass mass({0.5, 0.3, 0.2}, {&a, &b}, 0.01);
  DetectedMass swapped({0.5, 0.3, 0.2}, {&b, &a}, 0.01);
  EXPECT_DOUBLE_EQ(mass.of({2, 1}), swapped.of({1, 2}));
}

TEST(JointReward, WhatIsDetectedIsCountedInPartsOfWhatIsLeft) {
  ActionTree a = hand_tree({{0, 1.0, 0}});
  DetectedMass mass({0.1, 0.3}, {&a}, 0.0);
  EXPECT_DOUBLE_EQ(mass.of({1}), 0.25);
}

/// T15: room A with 0.2 is 1 s away, room B with 0.8 is 3 s away on the other side. Last actions 2: A first, 4: B
/// first.
ActionTree two_rooms() {
  return hand_tree({{0, 1.0, 0}, {1, 4.0, 1}, {0, 3.0, 1}, {3, 4.0, 0}});
}

TEST(JointReward, T15TheObjectiveAsPrintedDoesNotCareForTheOrderAndItsTravelCostPicksTheWrongOne) {
  ActionTree tree = two_rooms();
  DetectedMass without_cost({0.2, 0.8}, {&tree}, 0.0);
  EXPECT_DOUBLE_EQ(without_cost.of({2}), without_cost.of({4}));
  DetectedMass with_cost({0.2, 0.8}, {&tree}, 0.01);
  EXPECT_DOUBLE_EQ(with_cost.of({2}), 0.95);  // 5 s on the way
  EXPECT_DOUBLE_EQ(with_cost.of({4}), 0.93);  // 7 s
}

TEST(JointReward, T15TheExpectedTimePicksTheLikelyRoomFirst) {
  ActionTree tree = two_rooms();
  NegativeExpectedTime time(SearchObjective({{0.2, 0.8}}, 100.0, 0.0), {&tree}, {0.0}, {kFirstSight}, {}, 0.5, 1.0);
  EXPECT_NEAR(time.of({2}), -4.2, 1e-12);  // 0.2 * 1 + 0.8 * 5
  EXPECT_NEAR(time.of({4}), -3.8, 1e-12);  // 0.8 * 3 + 0.2 * 7
}

TEST(JointReward, WhatABranchLeavesIsFoundAfterItsEndOnASweepOfTheRest) {
  ActionTree tree = two_rooms();
  NegativeExpectedTime time(SearchObjective({{0.2, 0.8}}, 100.0, 50.0), {&tree}, {0.0}, {kFirstSight}, {}, 0.5, 1.0);
  EXPECT_NEAR(time.of({3}), -(0.8 * 3.0 + 0.2 * (3.0 + 0.5 * 50.0 * 0.2)), 1e-12);  // only B, after 3 s
}

TEST(JointReward, TheShareWithMassIsThatOfTheFloorWhereItLiesHoweverMuchItIs) {
  const OccupancyGrid map = empty_room(4, 2);
  const SearchArea area(map, start_at(1, 1));
  std::vector<double> mass = uniform_prior(area, {1, 1}, 0.0);
  EXPECT_NEAR(share_with_mass(mass, area), 1.0, 1e-12);
  for (double& one : mass) one *= 1e-6;
  EXPECT_NEAR(share_with_mass(mass, area), 1.0, 1e-12);
  double kept_m2 = 0.0;
  for (int cell = 0; cell < area.size(); ++cell) {
    if (area.point(cell).x() > 2.5) mass[static_cast<std::size_t>(cell)] = 0.0;
    if (area.point(cell).x() <= 2.5) kept_m2 += area.floor_m2(cell);
  }
  EXPECT_NEAR(share_with_mass(mass, area), kept_m2 / area.area_m2(), 1e-12);
  EXPECT_NEAR(kept_m2 / area.area_m2(), 0.5, 0.01);
  EXPECT_EQ(share_with_mass(std::vector<double>(mass.size(), 0.0), area), 0.0);
}

TEST(JointReward, T16TwoAgentsSplit) {
  ActionTree a = two_rooms();
  ActionTree b = two_rooms();
  NegativeExpectedTime time(SearchObjective({{0.2, 0.8}}, 100.0, 0.0), {&a, &b}, {0.0, 0.0}, {kFirstSight, kFirstSight},
                            {}, 0.5, 1.0);
  EXPECT_NEAR(time.of({1, 3}), -2.6, 1e-12);  // 0.2 * 1 + 0.8 * 3
}

}  // namespace
}  // namespace tandem
