#include "services/relay/core/torn_link.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

OtherRelay heard(std::size_t unmatched) {
  return {.is_heard = true, .is_found = true, .unmatched = unmatched};
}

constexpr OtherRelay kSilent{.is_heard = false, .is_found = true, .unmatched = 0};
constexpr OtherRelay kAway{.is_heard = false, .is_found = false, .unmatched = 30};

TEST(TornLink, IsJoinedAnewWhenNoMoreIsFoundForFiveSeconds) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), heard(3)));
  EXPECT_FALSE(link.add(at(4.9), heard(3)));
  EXPECT_TRUE(link.add(at(5.0), heard(3)));
}

TEST(TornLink, HasPatienceWhileMoreIsFound) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), heard(30)));
  EXPECT_FALSE(link.add(at(4.0), heard(10)));
  EXPECT_FALSE(link.add(at(8.0), heard(2)));
  EXPECT_FALSE(link.add(at(12.9), heard(2)));
  EXPECT_TRUE(link.add(at(13.0), heard(2)));
}

TEST(TornLink, IsLeftAloneWhileItIsWholeOrTheOtherIsAway) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), heard(0)));
  EXPECT_FALSE(link.add(at(100.0), heard(0)));
  EXPECT_FALSE(link.add(at(101.0), kAway));
  EXPECT_FALSE(link.add(at(200.0), kAway));
  EXPECT_FALSE(link.add(at(201.0), heard(30)));  // the patience begins when it is up
  EXPECT_TRUE(link.add(at(206.0), heard(30)));
}

TEST(TornLink, IsJoinedAnewLessAndLessOftenUntilItIsWhole) {
  TornLink link;
  int joined = 0;
  for (int second = 0; second <= 600; ++second) joined += link.add(at(second), heard(1)) ? 1 : 0;
  // After 5, 10, 20, 40 and then 60 s each, and a second more each time: the next look begins the next wait.
  EXPECT_EQ(joined, 4 + (600 - 5 - 11 - 21 - 41) / 61);

  EXPECT_FALSE(link.add(at(601.0), heard(0)));
  EXPECT_FALSE(link.add(at(602.0), heard(1)));
  EXPECT_TRUE(link.add(at(607.0), heard(1)));
}

TEST(TornLink, IsJoinedAnewWhenTheOtherIsThereButNotHeardForFiveSeconds) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), heard(0)));
  EXPECT_FALSE(link.add(at(1.0), kSilent));
  EXPECT_FALSE(link.add(at(5.9), kSilent));
  EXPECT_TRUE(link.add(at(6.0), kSilent));
}

TEST(TornLink, IsLeftAloneInAnOutage) {
  TornLink link;
  EXPECT_FALSE(link.add(at(0.0), heard(0)));
  // Heartbeats count as lost after 1.5 s, the other as gone after the lease of 5 s: silent for 3.5 s in between.
  for (double s = 1.5; s < 5.0; s += 0.1) EXPECT_FALSE(link.add(at(s), kSilent));
  for (double s = 5.0; s < 300.0; s += 0.1) EXPECT_FALSE(link.add(at(s), kAway));
  EXPECT_FALSE(link.add(at(300.0), kSilent));  // back, and found before it is heard
  EXPECT_FALSE(link.add(at(304.0), heard(30)));
  EXPECT_FALSE(link.add(at(308.0), heard(0)));
}

TEST(TornLink, IsJoinedAnewLessAndLessOftenWhileTheOtherStaysSilent) {
  TornLink link;
  int joined = 0;
  for (int second = 0; second <= 600; ++second) joined += link.add(at(second), kSilent) ? 1 : 0;
  EXPECT_EQ(joined, 4 + (600 - 5 - 11 - 21 - 41) / 61);  // as above
}

}  // namespace
}  // namespace tandem
