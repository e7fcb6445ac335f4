#include "services/experiment/core/episode/episode.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/experiment/core/study/study_json.hpp"
#include "tests/services/experiment/core/episode/room_scenario.hpp"

namespace tandem::experiment {
namespace {

TEST(Episode, AnObedientPersonAndTheRobotFindInAnEmptyHall) {
  EpisodeWorld world(hall_scenario(), hall_map(), quick_team());
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto episode = world.play("obedient", seed);
    ASSERT_TRUE(episode);
    EXPECT_TRUE(episode->found) << "seed " << seed;
    // 96 m2; together they sweep about 3 m2/s and 80 % of what they look at: twice the time is ample.
    EXPECT_LT(episode->time_s, 100.0) << "seed " << seed;
    EXPECT_EQ(episode->robot.collisions, 0) << "seed " << seed;
    EXPECT_NEAR(episode->explored, episode->explored_robot + episode->explored_human, 1e-9);
  }
}

TEST(Episode, EqualSeedsAreEqualWhateverWasPlayedBefore) {
  EpisodeWorld fresh(hall_scenario(), hall_map(), quick_team());
  EpisodeWorld used(hall_scenario(), hall_map(), quick_team());
  for (const std::string& human : human_names()) (void)used.play(human, 99);
  for (const std::string& human : human_names()) {
    EXPECT_EQ(episode_line(*fresh.play(human, 7)), episode_line(*used.play(human, 7))) << human;
  }
}

TEST(Episode, EverybodyFindsOrReachesTheLimitAndNobodyMakesTheRobotIdle) {
  simulator::Scenario scenario = hall_scenario();
  scenario.limit_s = 60.0;
  TeamOptions team = quick_team();
  team.planner.camera_detection_rate_per_s = team.planner.person_detection_rate_per_s = 0.01;  // a long search
  EpisodeWorld world(scenario, hall_map(), team);
  for (const std::string& human : human_names()) {
    const auto episode = world.play(human, 3);
    ASSERT_TRUE(episode) << human;
    EXPECT_TRUE(episode->found || episode->time_s == 60.0) << human;
    EXPECT_LT(episode->robot.longest_idle_s, 12.0) << human;
    EXPECT_GT(episode->robot.distance_m, 0.2 * episode->time_s) << human;
    EXPECT_GT(episode->human_distance_m, 0.1 * episode->time_s) << human;
    EXPECT_GE(episode->messages.at("my_pose"), episode->time_s / 20.0) << human;
  }
}

TEST(Episode, AnAnnouncedGoalMakesPeersAndOnlyIt) {
  simulator::Scenario scenario = hall_scenario();
  scenario.limit_s = 40.0;
  TeamOptions team = quick_team();
  team.planner.camera_detection_rate_per_s = team.planner.person_detection_rate_per_s = 0.001;
  EpisodeWorld world(scenario, hall_map(), team);
  const auto announced = world.play("announces", 1);
  ASSERT_TRUE(announced);
  EXPECT_GT(announced->messages.at("my_goal"), 0);
  EXPECT_TRUE(
      std::ranges::any_of(announced->roles, [](const RoleSince& since) { return since.role == Role::PeerPeer; }));
  const auto own = world.play("own", 1);
  ASSERT_TRUE(own);
  EXPECT_EQ(own->roles.size(), 1U);
  EXPECT_EQ(own->roles.front().role, Role::LeaderFollower);
}

TEST(Episode, APlanHasTheTimeItIsGivenAndNoMore) {
  TeamOptions team = quick_team();
  team.planner.rollouts = 1'000'000;  // nobody waits for that
  EpisodeWorld world(hall_scenario(), hall_map(), team);
  int asked = 0;
  const PlanningTime three_slices{[&] { asked = 0; }, [&] { return ++asked > 3; }};
  const auto episode = world.play("obedient", 1, three_slices);
  ASSERT_TRUE(episode);
  EXPECT_TRUE(episode->found);
  EXPECT_GT(episode->plans, 0);
}

TEST(Episode, EndsWhenAskedTo) {
  EpisodeWorld world(hall_scenario(), hall_map(), quick_team());
  int steps = 0;
  EXPECT_FALSE(world.play("obedient", 1, {}, [&] { return ++steps > 10; }));
  EXPECT_TRUE(world.play("obedient", 1));  // and the next one goes as ever
}

TEST(Episode, AScenarioWithoutRoomForTheRobotIsRefused) {
  simulator::Scenario scenario = hall_scenario();
  scenario.robot_start = {0.6, 0.6, 0.0};
  EpisodeWorld world(scenario, hall_map(), quick_team());
  EXPECT_THROW((void)world.play("obedient", 1), ConfigError);
}

}  // namespace
}  // namespace tandem::experiment
