#include "gateway/server/core/rate_limit.hpp"

#include <gtest/gtest.h>

namespace tandem::gateway {
namespace {

TEST(RateLimit, AllowsABurstThenItsRate) {
  const Time start{};
  RateLimit limit{20.0, 40.0, start};
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(limit.allows(start));
  EXPECT_FALSE(limit.allows(start));
  EXPECT_TRUE(limit.allows(start + from_seconds(0.05)));
  EXPECT_FALSE(limit.allows(start + from_seconds(0.05)));
}

TEST(RateLimit, NeverSavesMoreThanABurst) {
  const Time later{from_seconds(3600.0)};
  RateLimit limit{20.0, 2.0, Time{}};
  EXPECT_TRUE(limit.allows(later));
  EXPECT_TRUE(limit.allows(later));
  EXPECT_FALSE(limit.allows(later));
}

}  // namespace
}  // namespace tandem::gateway
