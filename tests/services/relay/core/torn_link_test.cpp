#include "services/relay/core/torn_link.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

TEST(TornLink, IsJoinedAnewWhenNoMoreIsFoundForFiveSeconds) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), true, 3));
  EXPECT_FALSE(link.add(at(4.9), true, 3));
  EXPECT_TRUE(link.add(at(5.0), true, 3));
}

TEST(TornLink, HasPatienceWhileMoreIsFound) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), true, 30));
  EXPECT_FALSE(link.add(at(4.0), true, 10));
  EXPECT_FALSE(link.add(at(8.0), true, 2));
  EXPECT_FALSE(link.add(at(12.9), true, 2));
  EXPECT_TRUE(link.add(at(13.0), true, 2));
}

TEST(TornLink, IsLeftAloneWhileItIsWholeOrDown) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), true, 0));
  EXPECT_FALSE(link.add(at(100.0), true, 0));
  EXPECT_FALSE(link.add(at(101.0), false, 30));
  EXPECT_FALSE(link.add(at(200.0), false, 30));
  EXPECT_FALSE(link.add(at(201.0), true, 30));  // the patience begins when it is up
  EXPECT_TRUE(link.add(at(206.0), true, 30));
}

TEST(TornLink, IsJoinedAnewLessAndLessOftenUntilItIsWhole) {
  TornLink link;
  int joined = 0;
  for (int second = 0; second <= 600; ++second) joined += link.add(at(second), true, 1) ? 1 : 0;
  // After 5, 10, 20, 40 and then 60 s each, and a second more each time: the next look begins the next wait.
  EXPECT_EQ(joined, 4 + (600 - 5 - 11 - 21 - 41) / 61);

  EXPECT_FALSE(link.add(at(601.0), true, 0));
  EXPECT_FALSE(link.add(at(602.0), true, 1));
  EXPECT_TRUE(link.add(at(607.0), true, 1));
}

}  // namespace
}  // namespace tandem
