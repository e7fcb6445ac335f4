#include "services/mapping/core/map_zones.hpp"

#include <gtest/gtest.h>

#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem {
namespace {

TEST(MapZones, AreTheAreasWithARuleAndTheHashOfTheirMap) {
  const test::TemporaryFolder folder;
  const auto grid = test::ascii_map({"####", "#..#", "####"});
  save_map(grid, folder / "lab.yaml");
  EXPECT_TRUE(load_map_zones(folder / "lab.yaml").map_sha256.empty()) << "no areas, so any map will do";

  write_file_atomically(folder / "areas.json", R"({
    "kitchen": [[0, 0], [4, 0], [4, 3]],
    "ramp": {"corners": [[0, 0], [1, 0], [1, 1]], "rule": "slow", "max_speed_mps": 0.2},
    "stairs": {"corners": [[1, 0], [2, 0], [2, 1], [1, 1]], "rule": "keep_out"}})");
  const MapZones found = load_map_zones(folder / "lab.yaml");

  ASSERT_EQ(found.areas.size(), 2u);
  EXPECT_EQ(found.areas[0].rule, AreaRule::Slow);
  EXPECT_EQ(found.areas[1].rule, AreaRule::KeepOut);
  EXPECT_EQ(found.map_sha256, sha256_of_cells(grid));
}

TEST(MapZones, OfAMapThatIsNotThereAreRefused) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "areas.json",
                        R"({"stairs": {"corners": [[1, 0], [2, 0], [2, 1]], "rule": "keep_out"}})");
  EXPECT_THROW(static_cast<void>(load_map_zones(folder / "lab.yaml")), MapError);
  EXPECT_TRUE(load_map_zones("").areas.empty());
}

TEST(MapZones, OfAHostAreThoseOfTheMapThatItsMapServerPublishes) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(load_zones_of_host(folder.path()).areas.empty()) << "its map comes from the other host";
  std::filesystem::create_directory(folder / "maps");
  save_map(test::ascii_map({"####", "#..#", "####"}), folder / "maps/lab.yaml");
  write_file_atomically(folder / "maps/areas.json",
                        R"({"stairs": {"corners": [[1, 0], [2, 0], [2, 1]], "rule": "keep_out"}})");
  write_file_atomically(folder / "map-server.toml", "map = \"maps/lab.yaml\"\n");
  EXPECT_EQ(load_zones_of_host(folder.path()).areas.size(), 1u);
}

MapArea square(double from, double to, AreaRule rule = AreaRule::KeepOut) {
  return {"square", {{from, from}, {to, from}, {to, to}, {from, to}}, rule, 0.0};
}

TEST(MapZones, AreAsFarAwayAsTheirOutlineAndNotAtAllInside) {
  const MapArea area = square(0.0, 2.0);
  EXPECT_DOUBLE_EQ(distance_to_area_m(area, {1.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(distance_to_area_m(area, {2.0, 1.0}), 0.0);
  EXPECT_DOUBLE_EQ(distance_to_area_m(area, {5.0, 1.0}), 3.0);
  EXPECT_DOUBLE_EQ(distance_to_area_m(area, {5.0, 6.0}), 5.0) << "3, 4, 5 from the corner";
}

TEST(MapZones, MakeUnknownGroundOfEveryCellThatAKeepOutAreaTouches) {
  const OccupancyGrid map = test::ascii_map({"......", "......", "......", "..#...", "......", "......"}, 1.0);
  EXPECT_FALSE(ground_outside(map, {}, 0.0));
  EXPECT_FALSE(ground_outside(map, {square(1.5, 3.5, AreaRule::Slow)}, 0.0));
  const auto ground = ground_outside(map, {square(1.5, 2.5)}, 0.0);
  ASSERT_TRUE(ground);
  for (const CellIndex cell : {CellIndex{1, 1}, {1, 2}, {2, 1}}) EXPECT_EQ(ground->at(cell), CellState::Unknown);
  EXPECT_EQ(ground->at(CellIndex{2, 2}), CellState::Occupied) << "a wall stays a wall";
  EXPECT_TRUE(ground->is_free({4, 2}));
  const auto wider = ground_outside(map, {square(1.5, 2.5)}, 1.5);
  EXPECT_EQ(wider->at(CellIndex{4, 2}), CellState::Unknown);
  EXPECT_TRUE(map.is_free({1, 1})) << "the map of everybody else";
}

}  // namespace
}  // namespace tandem
