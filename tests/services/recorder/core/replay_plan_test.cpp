#include "services/recorder/core/replay_plan.hpp"

#include <gtest/gtest.h>

namespace tandem::recorder {
namespace {

Time at(double seconds) {
  return Time{} + from_seconds(seconds);
}

TEST(ReplayPlan, NeitherAVelocityNorTheMomentOfRecordingIsSentAgain) {
  const ReplayOptions usual;
  for (const char* topic : {"odometry", "scan", "robot_pose", "team_plan", "map"})
    EXPECT_TRUE(is_replayed(topic, usual));
  for (const char* topic : {"velocity_command", "clock", "service_health", "link_heartbeat", "message_receipt"}) {
    EXPECT_FALSE(is_replayed(topic, usual)) << topic;
  }
}

TEST(ReplayPlan, AChoiceOfTopicsIsKeptTo) {
  ReplayOptions chosen;
  chosen.topics = {"scan", "clock"};
  EXPECT_TRUE(is_replayed("scan", chosen));
  EXPECT_TRUE(is_replayed("clock", chosen));
  EXPECT_FALSE(is_replayed("odometry", chosen));
}

TEST(ReplayPlan, LockstepSendsWhatLocalizationTakesInAndNotWhatItGives) {
  ReplayOptions options;
  options.lockstep = true;
  EXPECT_TRUE(is_replayed("odometry", options));
  EXPECT_TRUE(is_replayed("scan", options));
  EXPECT_TRUE(is_replayed("pose_hint", options));
  EXPECT_FALSE(is_replayed("robot_pose", options));
}

TEST(ReplayPlan, TwiceTheRateIsHalfTheTime) {
  const ReplayPace pace{at(100.0), at(7.0), 2.0};
  EXPECT_EQ(pace.due(at(104.0)), at(9.0));           // 4 s of recording in 2 s
  EXPECT_EQ(pace.mission_time(at(8.0)), at(102.0));  // 1 s in, 2 s of recording
}

TEST(ReplayPlan, WhileStoppedRecordedTimeStandsAndThenGoesOnFromThere) {
  ReplayPace pace{at(100.0), at(0.0), 2.0};
  pace.stop(at(5.0));
  EXPECT_TRUE(pace.is_stopped());
  EXPECT_EQ(pace.mission_time(at(8.0)), at(110.0));
  pace.go_on(at(9.0));
  EXPECT_EQ(pace.mission_time(at(10.0)), at(112.0));
  EXPECT_EQ(pace.due(at(112.0)), at(10.0));
}

TEST(ReplayPlan, AStepMovesRecordedTimeAndLeavesItStanding) {
  ReplayPace pace{at(100.0), at(0.0), 1.0};
  pace.stop(at(5.0));
  pace.step_to(at(107.0));
  EXPECT_EQ(pace.mission_time(at(50.0)), at(107.0));
}

TEST(ReplayPlan, AtFullSpeedEverythingIsDueAtOnce) {
  const ReplayPace pace{at(100.0), at(7.0), 0.0};
  EXPECT_EQ(pace.due(at(1e6)), at(7.0));
}

}  // namespace
}  // namespace tandem::recorder
