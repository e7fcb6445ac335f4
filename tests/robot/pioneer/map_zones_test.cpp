#include "robot/pioneer/map_zones.hpp"

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

  ASSERT_EQ(found.zones.size(), 2u);
  EXPECT_DOUBLE_EQ(found.zones[0].max_speed_mps, 0.2);
  EXPECT_TRUE(found.zones[1].is_keep_out());
  EXPECT_EQ(found.zones[1].corners_in_map.size(), 4u);
  EXPECT_EQ(found.map_sha256, sha256_of_cells(grid));
}

TEST(MapZones, OfAMapThatIsNotThereAreRefused) {
  const test::TemporaryFolder folder;
  write_file_atomically(folder / "areas.json",
                        R"({"stairs": {"corners": [[1, 0], [2, 0], [2, 1]], "rule": "keep_out"}})");
  EXPECT_THROW(static_cast<void>(load_map_zones(folder / "lab.yaml")), MapError);
  EXPECT_TRUE(load_map_zones("").zones.empty());
}

}  // namespace
}  // namespace tandem
