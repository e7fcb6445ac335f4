#include "services/mapping/core/map_areas.hpp"

#include <gtest/gtest.h>

#include "services/common/config.hpp"

namespace tandem {
namespace {

std::string complaint_about(const std::string& json) {
  try {
    static_cast<void>(parse_map_areas(json, "areas.json"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return {};
}

TEST(MapAreas, HaveANameAndMayHaveARule) {
  const auto areas = parse_map_areas(R"({
    "kitchen": [[0, 0], [4, 0], [4, 3]],
    "ramp": {"corners": [[5, 0], [9, 0], [9, 3], [5, 3]], "rule": "slow", "max_speed_mps": 0.2},
    "stairs": {"corners": [[1, 1], [2, 1], [2, 2]], "rule": "keep_out", "comment": "no rail"}})",
                                     "areas.json");
  ASSERT_EQ(areas.size(), 3u);
  EXPECT_EQ(areas[0].name, "kitchen");
  EXPECT_EQ(areas[0].rule, AreaRule::None);
  EXPECT_EQ(areas[0].corners_in_map[2], Eigen::Vector2d(4, 3));
  EXPECT_EQ(areas[1].rule, AreaRule::Slow);
  EXPECT_DOUBLE_EQ(areas[1].max_speed_mps, 0.2);
  EXPECT_EQ(areas[1].corners_in_map.size(), 4u);
  EXPECT_EQ(areas[2].rule, AreaRule::KeepOut);
}

TEST(MapAreas, SayWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint_about(R"({"a": [[0, 0], [1, 0]]})"), "areas.json: a: a polygon needs at least three corners");
  EXPECT_NE(complaint_about(R"({"a": {"corners": [[0, 0], [1, 0], [1, 1]]}})").find("rule"), std::string::npos);
  EXPECT_NE(complaint_about(R"({"a": {"corners": [[0, 0], [1, 0], [1, 1]], "rule": "slow"}})").find("max_speed_mps"),
            std::string::npos);
  EXPECT_NE(complaint_about(R"({"a": {"corners": [[0, 0], [1, 0], [1, 1]], "rule": "keep_out", "max_speed_mps": 1}})")
                .find("goes with the rule slow"),
            std::string::npos);
  EXPECT_NE(complaint_about(R"({"a": {"corners": [[0, 0], [1, 0], [1, 1]], "rule": "keep_out", "speed": 1}})")
                .find("unknown key"),
            std::string::npos);
}

TEST(MapAreas, AreNoneWhereThereIsNoFile) {
  EXPECT_TRUE(load_map_areas("/nowhere/map.yaml").empty());
}

}  // namespace
}  // namespace tandem
