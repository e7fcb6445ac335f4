#include "services/planner/core/srs/reward_source.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/sources.hpp"

namespace tandem {
namespace {

TEST(RewardSource, T1PaysTheInnerRateOnItsBoundaryAndFadesOutside) {
  RewardSource source = disc_source("s", {0, 0}, 2.0, 3.0);
  source.outer_rate_per_s = -1.0;

  EXPECT_DOUBLE_EQ(rate_at(source, {2, 0}), 3.0);
  EXPECT_NEAR(rate_at(source, {5, 0}), -0.049787, 1e-6);  // -e^-3
}

}  // namespace
}  // namespace tandem
