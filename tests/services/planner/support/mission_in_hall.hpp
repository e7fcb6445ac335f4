#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "services/planner/core/mission/search_mission.hpp"
#include "tests/services/planner/support/room.hpp"

namespace tandem {

inline const auto kNeverOver = [] { return false; };

/// A mission in a hall of 16 m x 10 m whose plans are carried out to the letter.
class MissionInHall : public ::testing::Test {
 protected:
  MissionInHall() : mission(config(), "robot", "person") {
    mission.set_map(empty_room(16, 10));
    robot = {3, 3, 0};
    person = {2, 2, 0};
    tell_poses();
    mission.step(now, kNeverOver);  // prepares
  }
  static PlannerConfig config() {
    PlannerConfig config;
    config.rollouts = 20;
    config.horizon_s = 40.0;
    return config;
  }
  void tell_poses() {
    mission.robot_at(now, robot);
    if (person_known) mission.person_at(now, person, 0.0);
  }
  void run() { mission.run_session("s1", now); }
  /// Steps until there is a new plan.
  bool plan() {
    for (int i = 0; i < 1000; ++i) {
      if (mission.step(now, kNeverOver)) return true;
      pass(std::chrono::milliseconds{100});
    }
    return false;
  }
  void pass(Duration duration) {
    now += duration;
    tell_poses();
  }
  /// Both walk along their paths for so long.
  void carry_out(Duration duration) {
    for (const Time end = now + duration; now < end;) {
      now += std::chrono::milliseconds{200};
      const double time_s = to_seconds(now - mission.plan()->start);
      if (time_s > 0.0) {
        robot = pose_at(mission.plan()->members[0].path, time_s);
        person = pose_at(mission.plan()->members[1].path, time_s - person_late_s);
      }
      tell_poses();
    }
  }
  std::vector<TimedPath> paths() const {
    std::vector<TimedPath> all;
    for (const auto& member : mission.plan()->members) all.push_back(member.path);
    return all;
  }
  RobotProgress progress() const { return {mission.plan()->id, false, false, Eigen::Vector2d::Zero()}; }

  Time now = from_stamp_ns(1'700'000'000'000'000'000);
  SearchMission mission;
  Pose2 robot;
  Pose2 person;
  bool person_known = true;
  double person_late_s = 0.0;
};

}  // namespace tandem
