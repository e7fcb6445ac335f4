#include "services/map_builder/core/grid_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/mapping/core/map_file.hpp"

namespace tandem {
namespace {

bool go_on(double) {
  return true;
}

MapScan beams(std::vector<Eigen::Vector2d> endpoints) {
  MapScan scan;
  scan.endpoints_in_base = std::move(endpoints);
  return scan;
}

TEST(GridDrawing, ClearsTheWayAndHitsTheEnd) {
  MapBuilderConfig config;
  config.resolution_m = 1.0;
  const std::vector<MapScan> scans{beams({{3.0, 0.0}})};
  const std::vector<Pose2> poses{{0.5, 0.5, 0.0}};
  const OccupancyGrid grid = drawn_grid(scans, poses, config, go_on);
  EXPECT_EQ(grid.at(Eigen::Vector2d{0.5, 0.5}), CellState::Free);
  EXPECT_EQ(grid.at(Eigen::Vector2d{2.5, 0.5}), CellState::Free);
  EXPECT_EQ(grid.at(Eigen::Vector2d{3.5, 0.5}), CellState::Occupied);
  EXPECT_EQ(grid.at(Eigen::Vector2d{4.5, 0.5}), CellState::Unknown);
}

TEST(GridDrawing, LetsTheMajorityDecide) {
  MapBuilderConfig config;
  config.resolution_m = 1.0;
  config.occupied_share = 0.5;
  const std::vector<MapScan> scans{beams({{2.0, 0.0}}), beams({{4.0, 0.0}}), beams({{4.0, 0.0}})};
  const std::vector<Pose2> poses(3, Pose2{0.5, 0.5, 0.0});
  const OccupancyGrid grid = drawn_grid(scans, poses, config, go_on);
  EXPECT_EQ(grid.at(Eigen::Vector2d{2.5, 0.5}), CellState::Free);  // hit once, passed twice
  EXPECT_EQ(grid.at(Eigen::Vector2d{4.5, 0.5}), CellState::Occupied);
}

TEST(GridDrawing, StartsBeamsAtTheLaser) {
  MapBuilderConfig config;
  config.resolution_m = 1.0;
  MapScan scan = beams({{5.0, 0.0}});
  scan.laser_in_base = {2.0, 0.0};
  const std::vector<Pose2> poses{{0.5, 0.5, 0.0}};
  const OccupancyGrid grid = drawn_grid({&scan, 1}, poses, config, go_on);
  EXPECT_EQ(grid.at(Eigen::Vector2d{1.5, 0.5}), CellState::Unknown);  // behind the laser
  EXPECT_EQ(grid.at(Eigen::Vector2d{2.5, 0.5}), CellState::Free);
}

TEST(GridDrawing, LiesAlikeWhereverTheRimIs) {
  MapBuilderConfig config;
  config.resolution_m = 0.5;
  const std::vector<Pose2> poses{{0.3, 0.2, 0.0}};
  const std::vector<MapScan> scans{beams({{2.17, 1.33}})};
  const Pose2 origin = drawn_grid(scans, poses, config, go_on).map_from_grid();
  EXPECT_EQ(std::fmod(origin.x, 0.5), 0.0);
  EXPECT_EQ(std::fmod(origin.y, 0.5), 0.0);
}

TEST(GridDrawing, DrawsNothingOfNothing) {
  EXPECT_TRUE(drawn_grid({}, {}, {}, go_on).empty());
}

TEST(GridDrawing, LeavesTheRestOutWhenStopped) {
  const std::vector<MapScan> scans{beams({{2.0, 0.0}})};
  const std::vector<Pose2> poses{{}};
  const OccupancyGrid grid = drawn_grid(scans, poses, {}, [](double) { return false; });
  for (const CellState state : grid.cells()) ASSERT_EQ(state, CellState::Unknown);
}

TEST(GridDrawing, RefusesAMapLargerThanIsReasonable) {
  MapBuilderConfig config;
  config.resolution_m = 0.01;
  const std::vector<MapScan> scans{beams({{2.0, 0.0}}), beams({{2.0, 0.0}})};
  const std::vector<Pose2> poses{{}, {5000.0, 5000.0, 0.0}};
  EXPECT_THROW((void)drawn_grid(scans, poses, config, go_on), MapError);
}

}  // namespace
}  // namespace tandem
