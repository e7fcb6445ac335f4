#include "services/experiment/core/episode/robot_drive.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem::experiment {
namespace {

/// A robot in a hall of 16 m x 10 m with an accepted plan straight ahead, from (2, 5) to (10, 5).
struct Drive {
  Drive() : place(empty_room(16, 10)), drive(config(), no_slip(), {2.0, 5.0, 0.0}, Rng{1}) {}

  static navigator::NavigatorConfig config() {
    navigator::NavigatorConfig config;
    config.period_s = 0.1;
    return config;
  }
  static simulator::SlipModel no_slip() { return {0.0, 0.0, 0.0}; }
  void run(double seconds) {
    for (const Time end = now + from_seconds(seconds); now < end;) {
      drive.hear({"plan",
                  "s",
                  "planner",
                  ++sequence,
                  navigator::PlanState::Accepted,
                  now + std::chrono::minutes{5},
                  {{2.0, 5.0}, {10.0, 5.0}}},
                 now);
      now += std::chrono::milliseconds{100};
      drive.step(now, "s", true, place, people);
    }
  }

  simulator::Place place;
  RobotDrive drive;
  std::vector<Bystander> people;
  Time now = from_stamp_ns(1'700'000'000'000'000'000);
  std::uint64_t sequence = 0;
};

TEST(RobotDrive, DrivesAPlanAtTheNavigatorsSpeed) {
  Drive d;
  d.run(10.0);
  // 0.5 m/s after 0.5 / 0.3 s of acceleration.
  EXPECT_NEAR(d.drive.map_from_base().x, 2.0 + 0.5 * 10.0 - 0.5 * 0.5 * 0.5 / 0.3, 0.2);
  d.run(10.0);
  EXPECT_TRUE(d.drive.execution().finished);
  EXPECT_NEAR(d.drive.map_from_base().x, 10.0, 0.25);
  EXPECT_EQ(d.drive.tally().stops, 0);
  EXPECT_NEAR(d.drive.tally().distance_m, 8.0, 0.3);
}

TEST(RobotDrive, StopsBeforeAPersonWhoShutsTheWayAndCountsIt) {
  Drive d;
  for (double y = 0.6; y < 10.5; y += 0.35) d.people.push_back({{{6.0, y}, 0.2}, Eigen::Vector2d::Zero()});
  d.run(20.0);
  EXPECT_LT(d.drive.map_from_base().x, 6.0 - 0.2 - 0.31);
  EXPECT_EQ(d.drive.tally().collisions, 0);
  EXPECT_GE(d.drive.tally().stops, 1);
  EXPECT_TRUE(d.drive.execution().blocked);
  EXPECT_GT(d.drive.tally().longest_idle_s, 3.0);
}

TEST(RobotDrive, SomebodyWhoStepsBesideTheMovingRobotIsANearCollision) {
  Drive d;
  d.run(4.0);
  EXPECT_EQ(d.drive.tally().near_collisions, 0);
  // Beside the hull: half its width, 0.1 m of room, the radius of the person.
  const Eigen::Vector2d beside = d.drive.map_from_base() * Eigen::Vector2d{0.1, 0.2525 + 0.1 + 0.2};
  d.people.push_back({{beside, 0.2}, Eigen::Vector2d::Zero()});
  d.run(0.2);
  EXPECT_EQ(d.drive.tally().near_collisions, 1);
}

}  // namespace
}  // namespace tandem::experiment
