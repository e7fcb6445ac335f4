#include "services/planner/core/srs/reward_source.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(RewardSource, ThePoolOfAConsumptionTimeLastsThatLongWhereItPaysMost) {
  const RewardRatio ratio{RatioShape::Ramp, 1.0, 4.0, 2.0, {}};
  EXPECT_DOUBLE_EQ(pool_of_consumption(ratio, 3.0), 12.0);
  EXPECT_DOUBLE_EQ(pool_of_consumption(constant_ratio(-2.0), 3.0), -6.0);
}

TEST(RewardSource, IsForEverybodyUnlessTargetsAreListed) {
  RewardSource source = disc_source("s", {0, 0}, 1.0, 1.0);
  EXPECT_TRUE(is_target(source, "a"));
  source.targets = {"b"};
  EXPECT_FALSE(is_target(source, "a"));
  EXPECT_TRUE(is_target(source, "b"));
}

}  // namespace
}  // namespace tandem
