#include "services/common/time.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace tandem {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

TEST(Time, SecondsBecomeTheNearestNanosecond) {
  EXPECT_EQ(from_seconds(1.5), milliseconds{1500});
  EXPECT_EQ(from_seconds(-0.25), milliseconds{-250});
  EXPECT_EQ(from_seconds(1.6e-9), nanoseconds{2});
  EXPECT_EQ(from_seconds(-1.6e-9), nanoseconds{-2});
}

TEST(Time, ToSecondsUndoesFromSeconds) {
  for (const double value_s : {0.0, 0.001, 0.1, 3.25, -7.5, 86400.0}) {
    EXPECT_NEAR(to_seconds(from_seconds(value_s)), value_s, 1e-9);
  }
}

TEST(Time, AStampIsNanosecondsOfTheUnixEpoch) {
  const Time time = Time{} + std::chrono::seconds{1'700'000'000} + nanoseconds{7};

  EXPECT_EQ(to_stamp_ns(time), 1'700'000'000'000'000'007);
  EXPECT_EQ(from_stamp_ns(to_stamp_ns(time)), time);
}

TEST(Time, AnotherClocksTimeDoesNotConvert) {
  EXPECT_FALSE((std::is_convertible_v<std::chrono::system_clock::time_point, Time>));
  EXPECT_FALSE((std::is_convertible_v<std::chrono::steady_clock::time_point, Time>));
}

}  // namespace
}  // namespace tandem
