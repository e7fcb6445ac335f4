#include "bench/recording/damage.hpp"

#include <gtest/gtest.h>

namespace tandem::bench {
namespace {

TEST(RecordingDamage, CostsNothingThatIsWhole) {
  const DamageResult cuts = cut_everywhere(49'999);
  EXPECT_GT(cuts.tried, 50U);  // three files of 1 MB
  EXPECT_EQ(cuts.failed, 0U);
  const DamageResult flips = flip_bits(5);
  EXPECT_EQ(flips.tried, 15U);
  EXPECT_EQ(flips.failed, 0U);
}

}  // namespace
}  // namespace tandem::bench
