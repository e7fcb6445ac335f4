#include "services/localization/core/trajectory_picture.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

TEST(TrajectoryPicture, ShowsWallsAndBothWays) {
  const OccupancyGrid map = test::ascii_map({"####", "#..#"});
  const std::vector<TimedPose> way{{Time{}, {1.5, 0.5, 0.0}}, {Time{}, {2.5, 0.5, 0.0}}};
  const std::string svg = trajectory_picture(map, way, {.truth = way});

  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_NE(svg.find("M20.0 32.5H120.0"), std::string::npos);  // the upper wall, 4 m at 25 pixels
  EXPECT_NE(svg.find("57.5 57.5 82.5 57.5"), std::string::npos);
  EXPECT_NE(svg.find(">true<"), std::string::npos);
}

TEST(TrajectoryPicture, LeavesOutATruthThatNobodyKnows) {
  const std::string svg = trajectory_picture(test::ascii_map({"#."}), {}, {});

  EXPECT_EQ(svg.find(">true<"), std::string::npos);
  EXPECT_EQ(svg.find(">closures<"), std::string::npos);
}

TEST(TrajectoryPicture, JoinsThePlacesThatWereRecognised) {
  const std::vector<PictureLink> closures{{{0.0, 0.0}, {1.0, 0.0}}};
  const std::string svg = trajectory_picture(test::ascii_map({"####"}), {}, {.closures = closures});

  EXPECT_NE(svg.find("M20.0 45.0L45.0 45.0"), std::string::npos);  // 1 m at 25 pixels, along the lower border
  EXPECT_NE(svg.find(">closures<"), std::string::npos);
}

TEST(TrajectoryPicture, DrawsALargePlaceSmaller) {
  const std::string svg = trajectory_picture(OccupancyGrid{6400, 1, 1.0, {}, CellState::Free}, {}, {});

  EXPECT_NE(svg.find("width=\"1640.0\""), std::string::npos);  // 1600 pixels and the margins
}

}  // namespace
}  // namespace tandem
