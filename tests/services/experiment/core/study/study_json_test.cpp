#include "services/experiment/core/study/study_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tandem::experiment {
namespace {

EpisodeResult an_episode() {
  EpisodeResult episode;
  episode.seed = 12;
  episode.found = true;
  episode.time_s = 47.7000000001;
  episode.found_by = "human";
  episode.explored = 0.333333;
  episode.explored_robot = 0.123456;
  episode.explored_human = 0.21;
  episode.robot = {.stops = 2, .collisions = 0, .near_collisions = 1, .distance_m = 20.125, .longest_idle_s = 3.2};
  episode.human_distance_m = 33.0;
  episode.plans = 4;
  episode.messages = {{"my_pose", 5}, {"replan", 1}};
  episode.roles = {{0.0, Role::LeaderFollower}, {12.5, Role::PeerPeer}};
  return episode;
}

StudySettings some_settings() {
  return {.scenario = "brl", .planner = "tandem", .human = "own", .seed = 3, .rollouts = 300, .config_hash = "abc"};
}

TEST(StudyJson, AnEpisodeComesBackFromItsLine) {
  const std::string line = episode_line(an_episode());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const auto back = parse_episode_line(line);
  ASSERT_TRUE(back);
  EXPECT_EQ(episode_line(*back), line);
  EXPECT_EQ(back->seed, 12U);
  EXPECT_DOUBLE_EQ(back->time_s, 47.7);
  EXPECT_EQ(back->roles, an_episode().roles);
  EXPECT_EQ(back->messages, an_episode().messages);
}

TEST(StudyJson, HalfALineIsNoEpisode) {
  const std::string line = episode_line(an_episode());
  EXPECT_FALSE(parse_episode_line(line.substr(0, line.size() / 2)));
  EXPECT_FALSE(parse_episode_line(""));
  EXPECT_FALSE(parse_episode_line(settings_line(some_settings())));
}

TEST(StudyJson, HasTheKeysThatProgramsRelyOn) {
  const std::vector episodes{an_episode()};
  const auto json = nlohmann::json::parse(study_json(some_settings(), episodes));
  EXPECT_EQ(json.at("planner"), "tandem");
  EXPECT_EQ(json.at("human"), "own");
  EXPECT_EQ(json.at("mean_time_s"), 47.7);
  EXPECT_EQ(json.at("ci95_s"), nlohmann::json::parse("[47.7, 47.7]"));
  EXPECT_EQ(json.at("explored_at_find"), 0.3333);
  const auto& episode = json.at("episodes").at(0);
  for (const char* key : {"seed", "found", "time_s", "explored_robot", "explored_human", "stops", "collisions"}) {
    EXPECT_TRUE(episode.contains(key)) << key;
  }
}

TEST(StudyJson, TheSettingsSayTheBudgetThatCounts) {
  StudySettings settings = some_settings();
  EXPECT_EQ(nlohmann::json::parse(settings_line(settings)).at("study").at("rollouts"), 300);
  settings.budget_ms = 10.0;
  const auto json = nlohmann::json::parse(settings_line(settings)).at("study");
  EXPECT_EQ(json.at("budget_ms"), 10.0);
  EXPECT_FALSE(json.contains("rollouts"));
}

TEST(StudyCsv, IsALineAnEpisodeBelowTheHead) {
  const std::vector episodes{an_episode()};
  const std::string csv = study_csv(episodes);
  EXPECT_TRUE(csv.starts_with("seed,found,time_s,found_by,"));
  EXPECT_NE(csv.find("\n12,true,47.7,human,0.3333,0.1235,0.21,2,0,1,3.2,20.13,33.0,4,5,0,1\n"), std::string::npos)
      << csv;
}

}  // namespace
}  // namespace tandem::experiment
