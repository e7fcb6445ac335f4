#include "services/recorder/core/pre_roll.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

using std::chrono::seconds;

constexpr std::size_t kPlenty = 1'000'000;

/// A sample of `source` at `time_s`, for the instance `instance`, that is `size` bytes of its own number.
Arrival arrival(std::size_t source, int time_s, std::uint8_t instance = 0, std::size_t size = 1) {
  Arrival one;
  one.source = source;
  one.payload = mcap::Bytes(size, static_cast<std::uint8_t>(time_s));
  one.key[0] = instance;
  one.received = Time{seconds{time_s}};
  return one;
}

std::vector<int> times(const PreRoll& pre_roll) {
  std::vector<int> all;
  for (const Arrival& one : pre_roll.everything()) {
    all.push_back(static_cast<int>(one.received.time_since_epoch() / seconds{1}));
  }
  return all;
}

TEST(PreRoll, KeepsTheSpanBeforeTheNewest) {
  PreRoll pre_roll{seconds{3}, kPlenty};
  for (int time = 1; time <= 10; ++time) pre_roll.keep(arrival(0, time), false);
  EXPECT_EQ(times(pre_roll), (std::vector<int>{7, 8, 9, 10}));
}

TEST(PreRoll, KeepsTheLastWordOfEachStateThatIsOlder) {
  PreRoll pre_roll{seconds{3}, kPlenty};
  pre_roll.keep(arrival(1, 1, 7), true);
  pre_roll.keep(arrival(1, 2, 7), true);  // the same instance, later
  pre_roll.keep(arrival(1, 3, 8), true);
  for (int time = 4; time <= 10; ++time) pre_roll.keep(arrival(0, time), false);
  EXPECT_EQ(times(pre_roll), (std::vector<int>{2, 3, 7, 8, 9, 10}));
}

TEST(PreRoll, AnInstanceThatHasEndedIsNoLongerKept) {
  PreRoll pre_roll{seconds{3}, kPlenty};
  pre_roll.keep(arrival(1, 1, 7), true);
  Arrival end = arrival(1, 2, 7, 0);
  end.disposed = true;
  pre_roll.keep(end, true);
  pre_roll.keep(arrival(0, 10), false);
  EXPECT_EQ(times(pre_roll), std::vector<int>{10});
}

TEST(PreRoll, IsShorterWhereItWouldTakeTooMuchMemory) {
  PreRoll pre_roll{seconds{100}, 50};
  for (int time = 1; time <= 10; ++time) pre_roll.keep(arrival(0, time, 0, 10), false);
  EXPECT_EQ(times(pre_roll), (std::vector<int>{6, 7, 8, 9, 10}));
  EXPECT_EQ(pre_roll.bytes(), 50U);
}

TEST(PreRoll, WhatWasRecordedIsNotKeptForTheNextEventButForTheStates) {
  PreRoll pre_roll{seconds{100}, kPlenty};
  pre_roll.keep(arrival(1, 1), true);
  pre_roll.keep(arrival(0, 2), false);
  pre_roll.settle();
  pre_roll.keep(arrival(0, 3), false);
  EXPECT_EQ(times(pre_roll), (std::vector<int>{1, 3}));
}

}  // namespace
}  // namespace tandem::recorder
