#include "services/experiment/core/report/report_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tandem::experiment {
namespace {

EpisodeLog episode() {
  EpisodeLog log;
  log.name = "first, \"quoted\"";
  log.code = "s1";
  log.robot = "robot1";
  log.agent = "human1";
  log.fields = {{"condition", "app"}};
  log.outcome = "found";
  log.found_by = "human1";
  log.duration_s = 12.3456;
  log.map = OccupancyGrid{2, 1, 0.5};
  log.map->cells()[0] = CellState::Free;
  log.map->cells()[1] = CellState::Occupied;
  log.plans = {{.time_s = 1.0,
                .id = "p1",
                .paths = {{.agent = "robot1",
                           .times_s = {0.0, 1.0, 2.0},
                           .points_in_map = {{0.0, 0.0}, {0.1, 0.0}, {1.004, 0.0}}}}},
               {.time_s = 2.0, .id = "p1", .state = PlanAt::State::Accepted}};
  log.beliefs = {{.time_s = 0.0, .explored = 0.5, .explored_robot = 0.25, .width = 1, .height = 1, .cells = {254}}};
  return log;
}

TEST(ReportJson, HoldsWhatThePageShows) {
  const std::vector<EpisodeLog> episodes{episode(), episode()};
  const auto report = make_report(episodes, {});
  const auto json = nlohmann::json::parse(report_json(episodes, report, {.title = "A study"}));
  EXPECT_EQ(json["title"], "A study");
  EXPECT_EQ(json["episodes"].size(), 2U);
  EXPECT_EQ(json["episodes"][0]["duration_s"], 12.346);
  EXPECT_EQ(json["episodes"][0]["values"]["explored"], 0.5);
  EXPECT_TRUE(json["episodes"][0]["values"]["stops"].is_null());
  EXPECT_TRUE(json["groups"][0]["my_pose"][3]["until_s"].is_null());  // of the whole episode
  EXPECT_EQ(json["comparisons"].size(), measures().size());
  EXPECT_EQ(json["maps"].size(), 1U) << "the same map is kept once";
  EXPECT_EQ(json["maps"][0]["cells"], ".#");
  EXPECT_EQ(json["replays"][1]["map"], 0);
  const auto& plans = json["replays"][0]["plans"];
  EXPECT_EQ(plans[0]["paths"]["robot1"], nlohmann::json::parse("[[0.0,0.0],[1.0,0.0]]")) << "points 0.3 m apart";
  EXPECT_FALSE(plans[1].contains("paths")) << "drawn once";
}

TEST(ReportJson, WithoutReplayIsWithoutMaps) {
  const std::vector<EpisodeLog> episodes{episode()};
  const auto json =
      nlohmann::json::parse(report_json(episodes, make_report(episodes, {}), {.title = "", .with_replay = false}));
  EXPECT_FALSE(json.contains("replays"));
  EXPECT_FALSE(json.contains("maps"));
}

TEST(ReportJson, SurvivesNamesInAnyEncoding) {
  auto odd = episode();
  odd.code = "caf\xe9";
  const std::vector<EpisodeLog> episodes{odd};
  const auto json = nlohmann::json::parse(report_json(episodes, make_report(episodes, {}), {}));
  EXPECT_TRUE(json["episodes"][0]["code"].get<std::string>().starts_with("caf"));
}

}  // namespace
}  // namespace tandem::experiment
