#include "services/planner/core/srs/search_sources.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(SearchSources, ASearchCellPaysTheProbabilityOfItsDetection) {
  Course search{search_world({"a", "b"}, {search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)})};

  const auto paid = search.advance({stay_at({0, 0}), stay_at({1, 0})}, 2.0);
  EXPECT_NEAR(paid[0] + paid[1], 0.25 * (1.0 - std::exp(-2.0)), 1e-12);  // two agents, 0.5 per s, 2 s
  EXPECT_NEAR(paid[0], paid[1], 1e-12);
  EXPECT_NEAR(search.account().drawn(search.source(kFoundId)), paid[0] + paid[1], 1e-12);
}

TEST(SearchSources, NothingPaysOnceTheObjectIsFound) {
  Course search{search_world({"a"}, {search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)})};
  search.account().consume(search.source(kFoundId));

  EXPECT_DOUBLE_EQ(search.advance({stay_at({0, 0})}, 2.0)[0], 0.0);
}

TEST(SearchSources, APersonAtTheirGoalStopsSearchingButTheRobotDoesNot) {
  RewardWorld world = search_world({"person", "robot"}, {search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)});
  ASSERT_FALSE(add_source(world, goal_source("person", {0, 0}, 0.5)));
  ASSERT_FALSE(add_relation(world, soft("cell", "goal_person", {"person"})));
  Course course{world};
  course.account().consume(course.source("goal_person"));

  const auto paid = course.advance({stay_at({0, 0}), stay_at({1, 0})}, 1.0);
  EXPECT_DOUBLE_EQ(paid[0], 0.0);
  EXPECT_GT(paid[1], 0.0);
}

TEST(SearchSources, TimeCostsOnlyWhileTheObjectIsNotFoundInExpectation) {
  // One cell that surely holds the object, detected at 0.5 per s: E[T] of 4 s of it is (1 - e^-2) / 0.5.
  Course search{
      search_world({"a"}, {search_cell_source("cell", Disc{{0, 0}, 3.0}, 1.0, 0.5), time_cost_source("a", 1.0)})};

  const double value = search.advance({stay_at({0, 0})}, 4.0)[0];
  EXPECT_NEAR(value, (1.0 - std::exp(-2.0)) - (1.0 - std::exp(-2.0)) / 0.5, 1e-12);
}

TEST(SearchSources, T15TheLikelyRoomComesFirstThoughItIsFarther) {
  // Rooms 1 m to the left with 0.2 and 3 m to the right with 0.8, seen at once on arrival, 1 m/s.
  const RewardWorld world = search_world(
      {"a"}, {search_cell_source("left", HalfPlane{{-1, 0}, {1, 0}}, 0.2, 1e9),
              search_cell_source("right", HalfPlane{{3, 0}, {-1, 0}}, 0.8, 1e9), time_cost_source("a", 1.0)});
  const auto expected_time_s = [&](double first, double second) {
    Course course{world};
    course.advance({straight_move({0, 0}, {first, 0})}, std::abs(first));
    course.advance({stay_at({first, 0})}, 1e-7);  // the blink of an eye in which it is seen
    course.advance({straight_move({first, 0}, {second, 0})}, std::abs(second - first));
    course.advance({stay_at({second, 0})}, 1e-7);
    return -course.record().paid[course.source("time_of_a")];
  };
  EXPECT_NEAR(expected_time_s(3.0, -1.0), 3.8, 1e-6);
  EXPECT_NEAR(expected_time_s(-1.0, 3.0), 4.2, 1e-6);
}

}  // namespace
}  // namespace tandem
