#include "services/bus/event_log.hpp"

#include <gtest/gtest.h>

namespace tandem::bus {
namespace {

using std::chrono::seconds;
using State = EventOutcome::State;

TEST(SentEvents, RepeatsEverySecondUntilEveryApplierHasAnswered) {
  SentEvents events{{"planner", "tracker"}, seconds{1}, seconds{10}};
  const Time start{};
  events.sent("a", start);

  EXPECT_TRUE(events.due(start).empty());
  EXPECT_EQ(events.due(start + seconds{1}).size(), 1U);
  EXPECT_TRUE(events.due(start + seconds{1}).empty());

  EXPECT_TRUE(events.answered("a", "planner", true, ""));
  EXPECT_EQ(events.outcome("a").state, State::Pending);
  EXPECT_EQ(events.due(start + seconds{2}).size(), 1U);

  EXPECT_TRUE(events.answered("a", "tracker", true, ""));
  EXPECT_EQ(events.outcome("a").state, State::Applied);
  EXPECT_TRUE(events.due(start + seconds{3}).empty());
}

TEST(SentEvents, OneRefusalIsARefusalAndSaysByWhom) {
  SentEvents events{{"planner", "tracker"}, seconds{1}, seconds{10}};
  events.sent("a", Time{});
  EXPECT_TRUE(events.answered("a", "tracker", false, "outside the map"));

  EXPECT_EQ(events.outcome("a").state, State::Refused);
  EXPECT_EQ(events.outcome("a").by, "tracker");
  EXPECT_EQ(events.outcome("a").reason, "outside the map");
}

TEST(SentEvents, GivesUpAfterItsTimeAndSaysWhoDidNotAnswer) {
  SentEvents events{{"base"}, seconds{1}, seconds{10}};
  events.sent("a", Time{});
  EXPECT_TRUE(events.due(Time{} + seconds{10}).empty());

  EXPECT_EQ(events.outcome("a").state, State::Undelivered);
  EXPECT_EQ(events.outcome("a").by, "base");
}

TEST(SentEvents, IgnoresReceiptsOfOthers) {
  SentEvents events{{"base"}, seconds{1}, seconds{10}};
  EXPECT_FALSE(events.answered("unknown", "base", true, ""));
}

TEST(AppliedEvents, AppliesOnceAndRepeatsItsAnswer) {
  AppliedEvents events;
  EXPECT_TRUE(events.is_new("a"));
  EXPECT_FALSE(events.answer_to("a"));
  events.answer("a", {false, "why"});

  EXPECT_FALSE(events.is_new("a"));
  ASSERT_TRUE(events.answer_to("a"));
  EXPECT_EQ(events.answer_to("a")->reason, "why");
}

}  // namespace
}  // namespace tandem::bus
