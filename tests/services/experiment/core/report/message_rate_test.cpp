#include "services/experiment/core/report/message_rate.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tandem::experiment {
namespace {

constexpr double kAll = std::numeric_limits<double>::infinity();

EpisodeLog episode_with(double duration_s, std::initializer_list<double> my_poses_s) {
  EpisodeLog log;
  log.duration_s = duration_s;
  for (const double time_s : my_poses_s) log.presses.push_back({time_s, "my_pose", std::nullopt});
  return log;
}

TEST(TimesBetweenMessages, TheFirstCountsFromTheMessageBeforeTheSearch) {
  const auto log = episode_with(60.0, {-2.0, 4.0, 10.0, 25.0});
  EXPECT_EQ(times_between_messages(log, "my_pose", kAll), (std::vector{6.0, 6.0, 15.0}));
}

TEST(TimesBetweenMessages, WithoutOneBeforeTheFirstCountsFromTheBeginning) {
  const auto log = episode_with(60.0, {4.0, 10.0});
  EXPECT_EQ(times_between_messages(log, "my_pose", kAll), (std::vector{4.0, 6.0}));
}

TEST(TimesBetweenMessages, OtherKindsAndWhatCameLaterDoNotCount) {
  auto log = episode_with(60.0, {5.0, 20.0});
  log.presses.insert(log.presses.begin() + 1, {10.0, "replan", std::nullopt});
  EXPECT_EQ(times_between_messages(log, "my_pose", 15.0), (std::vector{5.0}));
  EXPECT_EQ(times_between_messages(log, "my_pose", 20.0), (std::vector{5.0, 15.0}));
}

// Two episodes by hand. First minute: 6 messages in 60 s (6/min) and 3 in 30 s (6/min: it is over by then);
// in all: 8 in 120 s (4/min) and 3 in 30 s (6/min): mean 5, deviation sqrt(2).
TEST(MessageRate, IsTheMeanOverEpisodesOfTheirBeginnings) {
  const auto longer = episode_with(120.0, {5, 10, 15, 20, 25, 30, 90, 95});
  const auto shorter = episode_with(30.0, {10, 20, 30});
  const std::vector<const EpisodeLog*> both{&longer, &shorter};
  const auto minute = message_rate(both, "my_pose", 60.0, 10.0);
  EXPECT_DOUBLE_EQ(minute.per_min, 6.0);
  EXPECT_DOUBLE_EQ(minute.per_min_deviation, 0.0);
  EXPECT_DOUBLE_EQ(minute.within, 1.0);
  const auto all = message_rate(both, "my_pose", kAll, 10.0);
  EXPECT_DOUBLE_EQ(all.per_min, 5.0);
  EXPECT_DOUBLE_EQ(all.per_min_deviation, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(all.within, (7.0 / 8.0 + 1.0) / 2.0);
  EXPECT_EQ(all.episodes, 2U);
}

TEST(MessageRate, WhoSaidNothingHasARateButNoShare) {
  const auto silent = episode_with(60.0, {});
  const std::vector<const EpisodeLog*> one{&silent};
  const auto rate = message_rate(one, "my_pose", kAll, 10.0);
  EXPECT_EQ(rate.episodes, 1U);
  EXPECT_EQ(rate.with_messages, 0U);
  EXPECT_DOUBLE_EQ(rate.per_min, 0.0);
}

TEST(MatchingThreshold, IsTheSmallestThatReachesTheShare) {
  const std::vector<double> times{9.0, 1.0, 7.0, 5.0, 3.0, 11.0, 2.0, 8.0, 4.0, 20.0};
  EXPECT_DOUBLE_EQ(matching_threshold_s(times, 0.7), 8.0);
  EXPECT_DOUBLE_EQ(matching_threshold_s(times, 0.71), 9.0);
  EXPECT_DOUBLE_EQ(matching_threshold_s(times, 1.0), 20.0);
  EXPECT_DOUBLE_EQ(matching_threshold_s({}, 0.5), 0.0);
}

TEST(MatchingThreshold, GivesTheShareBack) {
  const std::vector<double> times{2.5, 3.5, 8.32, 10.0, 30.0};
  for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    EXPECT_DOUBLE_EQ(share_within(times, matching_threshold_s(times, share)), share);
  }
}

}  // namespace
}  // namespace tandem::experiment
