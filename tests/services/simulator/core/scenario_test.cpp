#include "services/simulator/core/scenario.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::simulator {
namespace {

const std::filesystem::path kConfig = std::filesystem::path{TANDEM_SOURCE_DIR} / "config";

constexpr const char* kScenario = R"({"map": "maps/hall.yaml", "robot": {"start": [2.5, 2.5, 0.5]},
  "person": {"start": [2.5, 4.5, 0]}, "tokens": {"min_distance_m": 10}, "passers_by": 3, "limit_s": 300})";

Scenario scenario() {
  return parse_scenario(kScenario, "/etc/tandem/scenarios/hall.json");
}

/// 24 x 6 m, a pillar in the middle.
Place hall() {
  return Place{test::ascii_map({"########################", "#......................#", "#..........##..........#",
                                "#..........##..........#", "#......................#", "########################"})};
}

std::string refusal(const std::string& json) {
  try {
    (void)parse_scenario(json, "hall.json");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Scenario, ReadsEveryField) {
  const Scenario read = scenario();
  EXPECT_EQ(read.name, "hall");
  EXPECT_EQ(read.map_file, "/etc/tandem/maps/hall.yaml");
  EXPECT_EQ(read.robot_start, (Pose2{2.5, 2.5, 0.5}));
  EXPECT_EQ(read.person_model, "obedient");
  EXPECT_FALSE(read.tokens_in_map);
  EXPECT_EQ(read.passers_by, 3);
  EXPECT_EQ(read.limit_s, 300.0);
}

TEST(Scenario, RefusesUnknownKeysWrongTypesAndValuesOutsideTheirRange) {
  const std::string text = kScenario;
  const auto with = [&](const std::string& from, const std::string& to) {
    return std::string{text}.replace(text.find(from), from.size(), to);
  };
  EXPECT_NE(refusal(with("limit_s", "limits")).find("hall.json: limits: unknown key; known: limit_s, map"),
            std::string::npos)
      << refusal(with("limit_s", "limits"));
  EXPECT_NE(refusal(with("[2.5, 2.5, 0.5]", "[2.5, 2.5]")).find("robot: start: must be 3 numbers"), std::string::npos);
  EXPECT_NE(refusal(with("300", "-1")).find("limit_s: -1 is outside [1, 36000]"), std::string::npos);
  EXPECT_NE(refusal(with("\"map\": \"maps/hall.yaml\", ", "")).find("map: is missing"), std::string::npos);
  EXPECT_NE(refusal("{\"map\": ").find("hall.json: [json.exception.parse_error"), std::string::npos);
  EXPECT_NE(refusal("[]").find("must be an object"), std::string::npos);
}

TEST(Scenario, DrawsTokensFartherThanTenMetresFreeReachableAndFifteenCentimetresApart) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Place place = hall();
    const Scene scene = scene_of(scenario(), place, MapChoice::OwnMap, seed);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const auto& token : scene.tokens_in_map) middle += token / 3.0;
    EXPECT_GT((middle - scene.robot_start.position()).norm(), 10.0) << "seed " << seed;
    EXPECT_TRUE(place.has_room(middle, 0.45)) << "seed " << seed;
    EXPECT_FALSE(shortest_walk(place, scene.robot_start.position(), middle, 0.4).empty()) << "seed " << seed;
    EXPECT_NEAR((scene.tokens_in_map[0] - scene.tokens_in_map[1]).norm(), 0.15, 1e-12);
    EXPECT_NEAR((scene.tokens_in_map[1] - scene.tokens_in_map[2]).norm(), 0.15, 1e-12);
  }
}

TEST(Scenario, EqualSeedsGiveEqualScenes) {
  const Place place = hall();
  const auto tokens = [&](std::uint64_t seed) {
    return scene_of(scenario(), place, MapChoice::OwnMap, seed).tokens_in_map;
  };
  EXPECT_EQ(tokens(7), tokens(7));
  EXPECT_NE(tokens(7), tokens(8));
}

TEST(Scenario, SaysThatNoPlaceIsFarEnough) {
  Scenario far = scenario();
  far.tokens_min_distance_m = 100.0;
  EXPECT_THROW((void)scene_of(far, hall(), MapChoice::OwnMap, 1), ConfigError);
}

TEST(Scenario, RefusesAStartInAWallOfItsOwnMap) {
  Scenario walled = scenario();
  walled.robot_start = {11.5, 2.5, 0.0};
  EXPECT_THROW((void)scene_of(walled, hall(), MapChoice::OwnMap, 1), ConfigError);
}

TEST(Scenario, OnAnotherMapTheRobotKeepsAStartThatIsFree) {
  const Scene scene = scene_of(scenario(), hall(), MapChoice::OtherMap, 1);
  EXPECT_EQ(scene.robot_start, scenario().robot_start);
  EXPECT_EQ(scene.person_start, scenario().person_start);
}

TEST(Scenario, OnAnotherMapTheRobotMovesToTheMiddleOfTheLargestGroundWithAMetreOfRoom) {
  const Place place{test::ascii_map({"#################", "#...#...........#", "#...#...........#", "#...#...........#",
                                     "#...#...........#", "#...#...........#", "#################"})};
  const auto start = robot_start_on(place, {4.5, 3.5, 1.0});  // a wall
  ASSERT_TRUE(start);
  EXPECT_EQ(*start, (Pose2{10.5, 3.5, 0.0}));                // of the right room, 11 x 5 m
  EXPECT_EQ(robot_start_on(place, {2.5, 3.5, 1.0}), start);  // free, but in the smaller room
}

TEST(Scenario, OnAnotherMapThePersonStartsBesideTheRobot) {
  Scenario elsewhere = scenario();
  elsewhere.robot_start = {-50.0, -50.0, 0.0};
  elsewhere.person_start = {-51.0, -50.0, 0.0};
  const Place place = hall();
  const Scene scene = scene_of(elsewhere, place, MapChoice::OtherMap, 1);
  const double apart = (scene.person_start.position() - scene.robot_start.position()).norm();
  EXPECT_GE(apart, 1.2);
  EXPECT_LT(apart, 3.0);
  EXPECT_TRUE(place.has_room(scene.person_start.position(), kPersonRoom_m));
}

TEST(Scenario, OnNoGroundAtAllThereIsNoStart) {
  EXPECT_FALSE(robot_start_on(Place{test::ascii_map({"###", "#.#", "###"})}, {0.5, 0.5, 0.0}));
}

TEST(Scenario, EveryShippedScenarioHasASceneOnItsMap) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kConfig / "scenarios")) {
    if (!entry.is_regular_file() || entry.path().string().ends_with(".schema.json")) continue;
    ++count;
    const Scenario shipped = load_scenario(entry.path());
    const Place place{load_map(shipped.map_file)};
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      EXPECT_NO_THROW((void)scene_of(shipped, place, MapChoice::OwnMap, seed)) << entry.path();
    }
  }
  EXPECT_GE(count, 2);
}

TEST(Scenario, BrlAlsoPlaysOnTheRealPlace) {
  TANDEM_NEEDS_DATA("maps/brl29a.yaml")
  const Place place{load_map(test::data_folder() / "maps" / "brl29a.yaml")};
  const Scene scene = scene_of(load_scenario(kConfig / "scenarios/brl.json"), place, MapChoice::OtherMap, 1);
  EXPECT_TRUE(place.has_room(scene.robot_start.position(), kRobotRoom_m));
  EXPECT_GT((scene.tokens_in_map[0] - scene.robot_start.position()).norm(), 9.8);
}

}  // namespace
}  // namespace tandem::simulator
