#include "services/experiment/core/report/episode_metrics.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem::experiment {
namespace {

using Eigen::Vector2d;

/// The robot drives 5 m along x in 10 s, then stands for 10 s; the person stands at (8, 0) all the time.
EpisodeLog straight_episode() {
  EpisodeLog log;
  log.outcome = "found";
  log.duration_s = 20.0;
  for (int i = 0; i <= 200; ++i) {
    const double time_s = 0.1 * i;
    log.robot_poses.push_back({time_s, {std::min(5.0, 0.5 * time_s), 0.0, 0.0}});
    log.human_poses.push_back({time_s, {8.0, 0.0, 0.0}});
  }
  return log;
}

TEST(EpisodeMetrics, MotionByHand) {
  const auto metrics = metrics_of(straight_episode());
  EXPECT_NEAR(metrics.robot.distance_m, 5.0, 1e-9);
  EXPECT_NEAR(metrics.robot.mean_mps, 0.25, 1e-9);
  EXPECT_NEAR(metrics.robot.max_mps, 0.5, 1e-9);
  EXPECT_NEAR(metrics.robot.idle_s, 10.0, 1e-9);
  EXPECT_NEAR(metrics.robot_idle, 0.5, 1e-9);
  EXPECT_NEAR(metrics.human_idle, 1.0, 1e-9);
  EXPECT_NEAR(metrics.both_active, 0.0, 1e-9);
}

TEST(EpisodeMetrics, TurningOnTheSpotIsNotIdle) {
  EpisodeLog log;
  log.duration_s = 10.0;
  for (int i = 0; i <= 10; ++i) {
    log.robot_poses.push_back({1.0 * i, {0.0, 0.0, wrap_to_pi(0.5 * std::numbers::pi * i)}});
  }
  const auto metrics = metrics_of(log);
  EXPECT_NEAR(metrics.robot_idle, 0.0, 1e-9);
  EXPECT_NEAR(metrics.robot.turning_rad, 5.0 * std::numbers::pi, 1e-6);
}

// 8 m at first, 3 m at last and for half of the 20.5 s that are looked at; 1.2 to 3.6 m from 4.4 m driven (8.8 s) on.
TEST(EpisodeMetrics, DistanceToTheTeammateByHand) {
  const auto distances = metrics_of(straight_episode()).teammate;
  EXPECT_NEAR(distances.known_s, 20.5, 1e-9);
  EXPECT_NEAR(distances.nearest_m, 3.0, 1e-9);
  EXPECT_NEAR(distances.social, 11.5 / 20.5, 0.5 / 20.5);
  EXPECT_DOUBLE_EQ(distances.intimate, 0.0);
  ASSERT_TRUE(distances.min_time_to_collision_s);
  EXPECT_NEAR(*distances.min_time_to_collision_s, (3.0 - 0.65) / 0.5, 1e-6);  // at the last step of the drive
}

TEST(EpisodeMetrics, WhoGoAwayFromEachOtherDoNotCollide) {
  EpisodeLog log;
  log.duration_s = 5.0;
  for (int i = 0; i <= 5; ++i) {
    log.robot_poses.push_back({1.0 * i, {-1.0 * i, 0.0, 0.0}});
    log.human_poses.push_back({1.0 * i, {1.0 + i, 0.0, 0.0}});
  }
  EXPECT_FALSE(metrics_of(log).teammate.min_time_to_collision_s);
}

TEST(EpisodeMetrics, TheNearestPasserByCounts) {
  auto log = straight_episode();
  for (int i = 0; i <= 40; ++i) log.passers_by.push_back({0.5 * i, {Vector2d{5.0, 0.3}, Vector2d{5.0, 9.0}}});
  const auto distances = metrics_of(log).passers_by;
  EXPECT_NEAR(distances.nearest_m, 0.3, 1e-9);
  EXPECT_NEAR(distances.intimate, 11.0 / 20.5, 1e-9);  // from 9.5 s on
}

TEST(EpisodeMetrics, StopsCountAtTheirOnset) {
  EpisodeLog log;
  log.duration_s = 20.0;
  log.base = {{0.0, 0.5, false, {}},
              {4.0, 0.5, false, {"obstacle"}},
              {5.0, 0.5, false, {"obstacle", "no link"}},
              {8.0, 0.25, false, {}},
              {12.0, 0.5, false, {"no link"}}};
  const auto metrics = metrics_of(log);
  EXPECT_EQ(metrics.stop_count, 2);
  EXPECT_EQ(metrics.stops.at("obstacle"), 1);
  EXPECT_EQ(metrics.stops.at("no link"), 1);
  EXPECT_DOUBLE_EQ(metrics.stopped_s.at("obstacle"), 4.0);
  EXPECT_DOUBLE_EQ(metrics.stopped_s.at("no link"), 8.0);
  EXPECT_DOUBLE_EQ(metrics.slowed.value(), 0.2);
}

TEST(EpisodeMetrics, PlansAndAnswers) {
  EpisodeLog log;
  log.duration_s = 60.0;
  log.presses = {{-3.0, "my_pose", std::nullopt},
                 {1.0, "replan", std::nullopt},
                 {20.0, "my_pose", std::nullopt},
                 {30.0, "replan", std::nullopt},
                 {59.0, "replan", std::nullopt}};
  using State = PlanAt::State;
  log.plans = {{.time_s = 1.5, .id = "a", .state = State::Proposed, .expected_time_s = 80.0, .lower_bound_s = 60.0},
               {.time_s = 5.0, .id = "a", .state = State::Accepted},
               {.time_s = 30.0, .id = "a", .state = State::Rejected},
               {.time_s = 30.4, .id = "b", .state = State::Proposed}};
  const auto metrics = metrics_of(log);
  EXPECT_EQ(metrics.plans, 2);
  EXPECT_EQ(metrics.rejected, 1);
  ASSERT_EQ(metrics.answer_s.size(), 2U);  // the last Replan was not answered
  EXPECT_NEAR(metrics.answer_s[0], 0.5, 1e-9);
  EXPECT_NEAR(metrics.answer_s[1], 0.4, 1e-9);
  ASSERT_EQ(metrics.pose_age_at_plan_s.size(), 2U);
  EXPECT_NEAR(metrics.pose_age_at_plan_s[0], 4.5, 1e-9);
  EXPECT_NEAR(metrics.pose_age_at_plan_s[1], 10.4, 1e-9);
  EXPECT_EQ(metrics.first_expected_s, 80.0);
  EXPECT_EQ(metrics.first_lower_bound_s, 60.0);
  EXPECT_EQ(metrics.messages.at("replan"), 3);
  EXPECT_EQ(metrics.messages.at("my_pose"), 1);
  EXPECT_DOUBLE_EQ(metrics.my_pose_per_min, 1.0);
  EXPECT_DOUBLE_EQ(metrics.longest_silence_s, 40.0);
}

TEST(EpisodeMetrics, RemindersAndTheLink) {
  EpisodeLog log;
  log.duration_s = 10.0;
  log.reminders = {{1.0, "toast", false}, {2.0, "toast", true}, {5.0, "toast", false}};
  log.link = {{0.0, true, 0.02, 0.0}, {4.0, false, 0.0, 1.0}, {6.0, true, 0.04, 0.1}};
  const auto metrics = metrics_of(log);
  EXPECT_DOUBLE_EQ(metrics.reminder_effect.value(), 0.5);
  EXPECT_DOUBLE_EQ(metrics.link_up.value(), 0.8);
  EXPECT_DOUBLE_EQ(metrics.round_trip_s.value(), 0.03);
}

TEST(EpisodeMetrics, WhatWasNotRecordedIsNone) {
  EpisodeLog log;
  log.duration_s = 10.0;
  const auto metrics = metrics_of(log);
  EXPECT_FALSE(metrics.explored);
  EXPECT_FALSE(metrics.stop_count);
  EXPECT_FALSE(metrics.slowed);
  EXPECT_FALSE(metrics.link_up);
  EXPECT_FALSE(metrics.reminder_effect);
  EXPECT_DOUBLE_EQ(metrics.teammate.known_s, 0.0);
}

}  // namespace
}  // namespace tandem::experiment
