// Whatever zones there are, no path that is planned for the robot comes near one that keeps it out.
#include <gtest/gtest.h>

#include "services/common/random.hpp"
#include "services/mapping/core/map_zones.hpp"
#include "services/planner/core/mission/search_mission.hpp"
#include "tests/services/planner/support/mission_in_hall.hpp"

namespace tandem {
namespace {

constexpr double kHullCorner_m = 0.402;

/// A triangle or a rectangle somewhere in the hall, not where the robot starts.
MapArea random_zone(Rng& rng) {
  const Pose2 place{rng.uniform(5.5, 15.0), rng.uniform(1.0, 10.0), rng.uniform(0.0, 6.28)};
  const double half_m = rng.uniform(0.2, 1.2);
  MapArea zone{"zone", {{-half_m, -0.8}, {half_m, -0.8}, {half_m, 0.8}}, AreaRule::KeepOut, 0.0};
  if (rng.index(2) == 0) zone.corners_in_map.emplace_back(-half_m, 0.8);
  for (auto& corner : zone.corners_in_map) corner = place * corner;
  return zone;
}

double distance_m(const TimedPath& path, const MapArea& zone) {
  double nearest_m = 99.0;
  for (double t = 0.0; t < path.duration_s(); t += 0.05) {
    nearest_m = std::min(nearest_m, distance_to_area_m(zone, pose_at(path, t).position()));
  }
  return nearest_m;
}

TEST(ZonesOfMissions, NoPlannedPathOfTheRobotEntersAKeepOutZone) {
  constexpr int kMissions = 30;
  PlannerConfig config;
  config.rollouts = 20;
  config.horizon_s = 60.0;
  int entered_by_person = 0;
  double robots_way_m = 0.0;
  for (int seed = 1; seed <= kMissions; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng{static_cast<std::uint64_t>(seed)};
    std::vector<MapArea> zones;
    for (std::size_t i = 0, count = 1 + rng.index(4); i < count; ++i) zones.push_back(random_zone(rng));
    config.seed = seed;
    SearchMission mission{config, "robot", "person"};
    Time now = from_stamp_ns(1'700'000'000'000'000'000);
    mission.set_map(empty_room(16, 10), zones);
    const auto tell = [&] {
      mission.robot_at(now, {3, 3, 0});
      mission.person_at(now, {2, 2, 0}, 0.0);
    };
    tell();
    mission.step(now, kNeverOver);
    mission.run_session("s1", now);
    for (int i = 0; i < 100 && !mission.step(now, kNeverOver); ++i) {
      now += std::chrono::milliseconds{100};
      tell();
    }
    ASSERT_TRUE(mission.plan());
    const TimedPath& robot = mission.plan()->members[0].path;
    for (std::size_t i = 1; i < robot.points.size(); ++i) {
      robots_way_m += (robot.points[i].point_in_map - robot.points[i - 1].point_in_map).norm();
    }
    for (const MapArea& zone : zones) {
      ASSERT_GT(distance_m(robot, zone), kHullCorner_m) << "wherever it turns, its hull is out of it";
      entered_by_person += distance_m(mission.plan()->members[1].path, zone) == 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(robots_way_m, 10.0 * kMissions) << "it does go somewhere";
  EXPECT_GT(entered_by_person, 0) << "the zones are the robot's alone";
}

}  // namespace
}  // namespace tandem
