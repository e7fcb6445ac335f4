#include "services/experiment/core/episode/person_watch.hpp"

#include <gtest/gtest.h>

#include "tests/services/planner/support/room.hpp"

namespace tandem::experiment {
namespace {

using Eigen::Vector2d;

/// A robot at (2, 5) that looks along x, in a hall of 16 m x 10 m; a person somewhere.
struct Watch {
  void run(double seconds, const Vector2d& person) {
    const std::vector<Vector2d> people{person};
    for (const Time end = now + from_seconds(seconds); now < end; now += std::chrono::milliseconds{100}) {
      watch.see(now, map, robot, people);
    }
  }
  void say(const Vector2d& point) { watch.hear(now, {simulator::PhonePress::MyPose, point, 0.0}); }

  OccupancyGrid map = empty_room(16, 10);
  Pose2 robot{2.0, 5.0, 0.0};
  PersonWatch watch{{}, Rng{1}};
  Time now = from_stamp_ns(1'700'000'000'000'000'000);
};

TEST(PersonWatch, NobodyIsKnownBeforeTheySayWhereTheyAre) {
  Watch w;
  w.run(2.0, {5.0, 5.0});
  EXPECT_FALSE(w.watch.estimate(w.now));
  w.say({5.2, 5.0});
  ASSERT_TRUE(w.watch.estimate(w.now));
  EXPECT_NEAR((w.watch.estimate(w.now)->map_from_agent.position() - Vector2d(5.0, 5.0)).norm(), 0.0, 0.3);
}

TEST(PersonWatch, WhoIsInSightStaysKnownAndWhoIsFarIsLostAfterTenSeconds) {
  Watch w;
  w.run(2.0, {5.0, 5.0});
  w.say({5.0, 5.0});
  w.run(20.0, {5.0, 5.0});
  EXPECT_FALSE(w.watch.estimate(w.now)->lost);
  w.run(9.0, {12.0, 5.0});  // 10 m away
  EXPECT_FALSE(w.watch.estimate(w.now)->lost);
  w.run(3.0, {12.0, 5.0});
  EXPECT_TRUE(w.watch.estimate(w.now)->lost);
}

TEST(PersonWatch, TheLaserDoesNotSeeBehindTheRobot) {
  Watch w;
  w.robot = {8.0, 5.0, 0.0};
  w.run(2.0, {5.0, 5.0});
  w.say({5.0, 5.0});
  w.run(11.0, {5.0, 5.0});
  EXPECT_TRUE(w.watch.estimate(w.now)->lost);
}

}  // namespace
}  // namespace tandem::experiment
