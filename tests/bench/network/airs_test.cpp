#include "bench/network/airs.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tandem::bench {
namespace {

using std::chrono::milliseconds;

TEST(Airs, AreWhatTheirNamesSay) {
  EXPECT_DOUBLE_EQ(conditions_of("clean").loss, 0.0);
  EXPECT_DOUBLE_EQ(conditions_of("loss20").loss, 0.2);
  EXPECT_EQ(conditions_of("bursts").dead_for, milliseconds{300});
  EXPECT_EQ(conditions_of("bursts").dead_every, milliseconds{1000});
  EXPECT_DOUBLE_EQ(conditions_of("2M").rate_bps, 2e6);
  EXPECT_DOUBLE_EQ(conditions_of("2M+loss10").rate_bps, 2e6);
  EXPECT_DOUBLE_EQ(conditions_of("2M+loss10").loss, 0.1);
  EXPECT_DOUBLE_EQ(conditions_of("loss30+bursts").loss, 0.3);
  EXPECT_EQ(conditions_of("loss30+bursts").dead_for, milliseconds{300});
  EXPECT_FALSE(conditions_of("no_multicast").multicast);
  EXPECT_TRUE(conditions_of("loss20").multicast);
  EXPECT_THROW(std::ignore = conditions_of("foggy"), std::invalid_argument);
}

TEST(Airs, HaveTitlesForReaders) {
  EXPECT_EQ(title_of("clean"), "0 %");
  EXPECT_EQ(title_of("loss20"), "20 %");
  EXPECT_EQ(title_of("2M+loss10"), "2 Mbit/s, 10 %");
  EXPECT_EQ(title_of("loss30+bursts"), "30 %, bursts");
}

}  // namespace
}  // namespace tandem::bench
