#include "services/simulator/core/map_plan.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem::simulator {
namespace {

constexpr const char* kSquare = R"({"outline": [[0, 0], [4, 0], [4, 4], [0, 4]], "outline_thickness_m": 0.2,
  "margin_m": 1, "resolution_m": 0.1,
  "walls": [{"from": [2, 0], "to": [2, 2], "thickness_m": 0.2}],
  "blocks": [{"min": [3, 3], "max": [3.5, 3.5]}],
  "columns": [{"first": [0.5, 3], "pitch": [1, 0], "count": [2, 1], "size_m": 0.4}]})";

TEST(MapPlan, DrawsWallsBlocksAndColumnsInsideAClosedOutline) {
  const OccupancyGrid map = draw(parse_map_plan(kSquare, "square"));

  EXPECT_EQ(map.width(), 60);
  EXPECT_EQ(map.height(), 60);
  EXPECT_EQ(map.at(Eigen::Vector2d{1.0, 1.0}), CellState::Free);
  EXPECT_EQ(map.at(Eigen::Vector2d{0.0, 1.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Eigen::Vector2d{2.0, 1.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Eigen::Vector2d{2.0, 2.5}), CellState::Free);
  EXPECT_EQ(map.at(Eigen::Vector2d{3.2, 3.2}), CellState::Occupied);
  EXPECT_EQ(map.at(Eigen::Vector2d{0.5, 3.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Eigen::Vector2d{1.5, 3.0}), CellState::Occupied);
  EXPECT_EQ(map.at(Eigen::Vector2d{-0.5, 1.0}), CellState::Unknown);
}

TEST(MapPlan, RefusesWhatItDoesNotKnowAndSaysWhere) {
  try {
    (void)parse_map_plan(R"({"outline": [[0,0],[1,0],[1,1]], "walls": [{"from": [0,0], "too": [1,1]}]})",
                         "a.plan.json");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string{error.what()}.find("a.plan.json: walls[0]: to: is missing"), std::string::npos)
        << error.what();
  }
}

TEST(MapPlan, TheShippedMapsAreDrawnFromTheirPlans) {
  const std::filesystem::path maps = std::filesystem::path{TANDEM_SOURCE_DIR} / "config" / "maps";
  for (const std::string name : {"brl", "room"}) {
    const auto plan = maps / (name + ".plan.json");
    EXPECT_EQ(draw(parse_map_plan(read_file(plan), plan.string())), load_map(maps / (name + ".yaml"))) << name;
  }
}

TEST(MapPlan, BrlHasAbout750SquareMetresToSearch) {
  const OccupancyGrid map = load_map(std::filesystem::path{TANDEM_SOURCE_DIR} / "config/maps/brl.yaml");
  EXPECT_NEAR(free_area_m2(map), 750.0, 15.0);
}

}  // namespace
}  // namespace tandem::simulator
