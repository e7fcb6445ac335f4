#include "services/planner/core/inform/inform_schedule.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

using std::chrono::seconds;

/// A message costs 3 s, there is one every 20 s, each lives for 30 s.
class InformScheduleTest : public ::testing::Test {
 protected:
  std::string next(const std::vector<InformOption>& options) {
    const auto chosen = schedule.next(options, now);
    return chosen ? chosen->source_id : "";
  }
  Time now = from_stamp_ns(1'700'000'000'000'000'000);
  InformSchedule schedule{{3.0, 20.0, 30.0}};
};

TEST_F(InformScheduleTest, TellsWhatGainsMostIfItGainsMoreThanItCosts) {
  EXPECT_EQ(next({}), "");
  EXPECT_EQ(next({{"a", 2.9, ""}, {"b", 3.0, ""}}), "");
  EXPECT_EQ(next({{"a", 4.0, ""}, {"b", 5.0, ""}, {"c", 5.0, ""}}), "b");
}

TEST_F(InformScheduleTest, TellsOneThingAtATimeAndPausesAfterIt) {
  EXPECT_EQ(next({{"a", 4.0, ""}}), "a");
  now += seconds{29};
  EXPECT_EQ(next({{"b", 9.0, ""}}), "");  // a has not been taken notice of yet
  schedule.heard("a");
  EXPECT_EQ(next({{"b", 9.0, ""}}), "b");
  schedule.heard("b");
  now += seconds{19};
  EXPECT_EQ(next({{"c", 9.0, ""}}), "");
  now += seconds{1};
  EXPECT_EQ(next({{"c", 9.0, ""}}), "c");
}

TEST_F(InformScheduleTest, WhatNobodyTakesNoticeOfIsToldOnceMoreAndThenNoMore) {
  EXPECT_EQ(next({{"a", 4.0, ""}}), "a");
  now += seconds{30};
  EXPECT_EQ(next({{"a", 4.0, ""}}), "a");
  now += seconds{30};
  EXPECT_EQ(next({{"a", 4.0, ""}, {"b", 3.5, ""}}), "b");
}

TEST_F(InformScheduleTest, NewsOfWhatWasHeardOfAreToldAnew) {
  for (int i = 0; i < 4; ++i, now += seconds{20}) {
    EXPECT_EQ(next({{"a", 4.0, ""}}), "a");
    schedule.heard("a");
  }
}

TEST_F(InformScheduleTest, WhatIsGoneIsNotWaitedFor) {
  EXPECT_EQ(next({{"a", 4.0, ""}}), "a");
  schedule.forget("a");
  now += seconds{20};
  EXPECT_EQ(next({{"b", 4.0, ""}}), "b");
}

}  // namespace
}  // namespace tandem
