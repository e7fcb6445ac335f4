// The laws T2 to T8 of docs/srs_model.md.
#include "services/planner/core/srs/reward_account.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(RewardAccount, T2PaysForTheTimeInsideUntilThePoolIsEmpty) {
  RewardWorld world{{disc_source("s", {0, 0}, 2.0, 3.0)}, {}};
  RewardAccount unlimited{world};
  EXPECT_NEAR(unlimited.advance({move("a", {-4, 0}, {4, 0})}, 8.0)[0], 12.0, 1e-12);  // 4 s at 3 per s

  world.sources[0].pool = 5.0;
  RewardAccount limited{world};
  EXPECT_NEAR(limited.advance({move("a", {-4, 0}, {-1.0 / 3.0, 0})}, 4.0 - 1.0 / 3.0)[0], 5.0, 1e-12);
  EXPECT_TRUE(limited.is_consumed(0));  // exactly at x = -1/3
  EXPECT_DOUBLE_EQ(limited.advance({move("a", {-1.0 / 3.0, 0}, {4, 0})}, 4.0 + 1.0 / 3.0)[0], 0.0);
}

TEST(RewardAccount, T3SplittingAMoveChangesNothing) {
  RewardWorld world{{disc_source("s", {0, 0}, 2.0, 3.0)}, {}};
  world.sources[0].pool = 5.0;
  for (const int pieces : {1, 2, 7, 100}) {
    RewardAccount account{world};
    double sum = 0.0;
    for (int i = 0; i < pieces; ++i) {
      const double from = -4.0 + 8.0 * i / pieces;
      const double to = -4.0 + 8.0 * (i + 1) / pieces;
      sum += account.advance({move("a", {from, 0}, {to, 0})}, 8.0 / pieces)[0];
    }
    EXPECT_NEAR(sum, 5.0, 1e-9) << pieces;
  }
}

TEST(RewardAccount, T4TwoAgentsShareAPoolInProportionToTheirRates) {
  // An agent that draws three times as fast stands in three equal sources whose pools are one.
  RewardWorld world{{disc_source("fast", {0, 0}, 1.0, 3.0), disc_source("slow", {0, 0}, 1.0, 1.0)}, {}};
  world.sources[0].targets = {"a"};
  world.sources[1].targets = {"b"};
  world.sources[0].pool = world.sources[1].pool = 8.0;
  world.relations.push_back({RelationKind::Codependent, "fast", "slow", 1.0, {}});
  RewardAccount account{world};

  const auto until_empty = account.advance({move("a", {0, 0}, {0, 0}), move("b", {0, 0}, {0, 0})}, 2.0);
  EXPECT_TRUE(account.is_consumed(0));
  EXPECT_NEAR(until_empty[0], 6.0, 1e-12);
  EXPECT_NEAR(until_empty[1], 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(account.advance({move("a", {0, 0}, {0, 0})}, 5.0)[0], 0.0);
}

TEST(RewardAccount, T5ANegativePoolRepelsOnlyUntilItIsEmpty) {
  RewardWorld world{{disc_source("s", {0, 0}, 1.0, -2.0)}, {}};
  world.sources[0].pool = -4.0;
  RewardAccount account{world};

  EXPECT_NEAR(account.advance({move("a", {0, 0}, {0, 0})}, 5.0)[0], -4.0, 1e-12);
  EXPECT_DOUBLE_EQ(account.advance({move("a", {0, 0}, {0, 0})}, 5.0)[0], 0.0);
}

TEST(RewardAccount, T6TheDoorPaysOnlyAfterTheKey) {
  RewardWorld world{{disc_source("key", {2, 0}, 0.1, 1e6), disc_source("door", {-2, 0}, 0.1, 1e7)}, {}};
  world.sources[0].pool = 1.0;
  world.sources[1].pool = 10.0;
  world.relations.push_back({RelationKind::Strict, "key", "door", 1.0, {}});

  RewardAccount key_first{world};
  double sum = key_first.advance({move("a", {0, 0}, {2, 0})}, 2.0)[0];
  sum += key_first.advance({move("a", {2, 0}, {-2, 0})}, 4.0)[0];
  EXPECT_NEAR(sum, 11.0, 1e-9);

  RewardAccount door_first{world};
  EXPECT_DOUBLE_EQ(door_first.advance({move("a", {0, 0}, {-2, 0})}, 2.0)[0], 0.0);
}

TEST(RewardAccount, T7AProductPaysOnlyBeforeTheCashier) {
  RewardWorld world{{disc_source("product", {0, 0}, 1.0, 1.0), disc_source("cashier", {9, 0}, 1.0, 1.0)}, {}};
  world.sources[0].pool = world.sources[1].pool = 2.0;
  world.relations.push_back({RelationKind::Soft, "product", "cashier", 1.0, {}});
  RewardAccount account{world};

  EXPECT_NEAR(account.advance({move("a", {9, 0}, {9, 0})}, 3.0)[0], 2.0, 1e-12);  // skipping the product is legal
  EXPECT_DOUBLE_EQ(account.advance({move("a", {0, 0}, {0, 0})}, 3.0)[0], 0.0);
}

TEST(RewardAccount, T8CodependentPoolsEmptyTogether) {
  RewardWorld world{{disc_source("one", {0, 0}, 1.0, 10.0), disc_source("other", {9, 0}, 1.0, 10.0)}, {}};
  world.sources[0].pool = world.sources[1].pool = 10.0;
  world.relations.push_back({RelationKind::Codependent, "one", "other", 0.4, {}});
  RewardAccount account{world};

  EXPECT_NEAR(account.advance({move("a", {0, 0}, {0, 0})}, 1.0)[0], 10.0, 1e-12);
  EXPECT_NEAR(account.left(1), 6.0, 1e-12);
}

}  // namespace
}  // namespace tandem
