#include "services/recorder/core/clock_line.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

constexpr std::uint64_t kMinute_ns = 60'000'000'000;

TEST(ClockLine, OneBadMeasurementMovesNothing) {
  const ClockLine line{{{1, 0.5}, {2, 0.5}, {3, 7.0}, {4, 0.5}}};
  EXPECT_DOUBLE_EQ(line.offset_s_at(2), 0.5);
}

TEST(ClockLine, FollowsADriftFromMinuteToMinute) {
  // 0.1 s in the first minute, 0.3 s in the third; half way between them 0.2 s.
  const ClockLine line{{{2 * kMinute_ns + 10, 0.3}, {10, 0.1}}};
  EXPECT_DOUBLE_EQ(line.offset_s_at(kMinute_ns + 10), 0.2);
  EXPECT_DOUBLE_EQ(line.offset_s_at(0), 0.1);
  EXPECT_DOUBLE_EQ(line.offset_s_at(9 * kMinute_ns), 0.3);
}

TEST(ClockLine, ThatIsGivenIsTheSameEverywhere) {
  EXPECT_DOUBLE_EQ(ClockLine{-2.5}.offset_s_at(77), -2.5);
}

}  // namespace
}  // namespace tandem::recorder
