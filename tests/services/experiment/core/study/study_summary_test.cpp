#include "services/experiment/core/study/study_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/common/random.hpp"

namespace tandem::experiment {
namespace {

TEST(MeanWithInterval, OfEqualValuesIsThatValue) {
  const std::vector<double> values(10, 3.0);
  const auto mean = mean_with_interval(values);
  EXPECT_DOUBLE_EQ(mean.mean, 3.0);
  EXPECT_DOUBLE_EQ(mean.low, 3.0);
  EXPECT_DOUBLE_EQ(mean.high, 3.0);
}

TEST(MeanWithInterval, IsTwoStandardErrorsWideToEachSide) {
  Rng rng{5};
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(rng.normal(100.0, 20.0));
  const auto mean = mean_with_interval(values);
  EXPECT_NEAR(mean.mean, 100.0, 3.0);
  EXPECT_NEAR(mean.high - mean.low, 2.0 * 1.96 * 20.0 / 20.0, 0.6);  // 20 / sqrt(400) is one
  EXPECT_LT(mean.low, mean.mean);
  EXPECT_EQ(mean_with_interval({}).mean, 0.0);
}

TEST(StudySummary, CountsTheLimitForWhatWasNotFound) {
  EpisodeResult one;
  one.found = true;
  one.time_s = 60.0;
  one.explored = 0.5;
  one.explored_robot = 0.2;
  one.explored_human = 0.3;
  one.robot.stops = 3;
  one.messages = {{"my_pose", 6}};
  one.roles = {{0.0, Role::LeaderFollower}, {45.0, Role::PeerPeer}};
  EpisodeResult other;
  other.time_s = 120.0;  // the limit
  other.explored = 0.9;
  other.robot.longest_idle_s = 7.0;
  other.messages = {{"my_pose", 12}, {"replan", 3}};
  other.roles = {{0.0, Role::LeaderFollower}};

  const auto summary = summary_of(std::vector{one, other});
  EXPECT_EQ(summary.episodes, 2U);
  EXPECT_EQ(summary.found, 1U);
  EXPECT_DOUBLE_EQ(summary.time_s.mean, 90.0);
  EXPECT_DOUBLE_EQ(summary.explored_at_find, 0.5);
  EXPECT_DOUBLE_EQ(summary.explored_robot, 0.2);
  EXPECT_DOUBLE_EQ(summary.stops, 1.5);
  EXPECT_DOUBLE_EQ(summary.longest_idle_s, 7.0);
  EXPECT_DOUBLE_EQ(summary.messages_per_min.at("my_pose"), 6.0);  // 18 in three minutes
  EXPECT_DOUBLE_EQ(summary.messages_per_min.at("replan"), 1.0);
  EXPECT_DOUBLE_EQ(summary.role_shares.at("leader_follower"), 165.0 / 180.0);
  EXPECT_DOUBLE_EQ(summary.role_shares.at("peer_peer"), 15.0 / 180.0);
}

TEST(StudySummary, OfNothingIsNothing) {
  EXPECT_EQ(summary_of({}).episodes, 0U);
}

}  // namespace
}  // namespace tandem::experiment
