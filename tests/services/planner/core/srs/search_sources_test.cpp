#include "services/planner/core/srs/search_sources.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(SearchSources, ASearchCellPaysTheProbabilityOfItsDetection) {
  const RewardWorld world = search_world({search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)});
  RewardAccount search{world};

  const auto paid = search.advance({move("a", {0, 0}, {0, 0}), move("b", {1, 0}, {1, 0})}, 2.0);
  EXPECT_NEAR(paid[0] + paid[1], 0.25 * (1.0 - std::exp(-2.0)), 1e-12);  // two agents, 0.5 per s, 2 s
  EXPECT_NEAR(paid[0], paid[1], 1e-12);
}

TEST(SearchSources, NothingPaysOnceTheObjectIsFound) {
  const RewardWorld world = search_world({search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)});
  RewardAccount account{world};
  account.consume(*index_of(world, kFoundId));

  EXPECT_DOUBLE_EQ(account.advance({move("a", {0, 0}, {0, 0})}, 2.0)[0], 0.0);
}

TEST(SearchSources, APersonAtTheirGoalStopsSearchingButTheRobotDoesNot) {
  RewardWorld world = search_world({search_cell_source("cell", Disc{{0, 0}, 3.0}, 0.25, 0.5)});
  world.sources.push_back(goal_source("person", {0, 0}, 0.5));
  world.relations.push_back({RelationKind::Soft, "cell", "goal_person", 1.0, {"person"}});
  RewardAccount account{world};
  account.consume(*index_of(world, "goal_person"));

  const auto paid = account.advance({move("person", {0, 0}, {0, 0}), move("robot", {1, 0}, {1, 0})}, 1.0);
  EXPECT_DOUBLE_EQ(paid[0], 0.0);
  EXPECT_GT(paid[1], 0.0);
}

}  // namespace
}  // namespace tandem
