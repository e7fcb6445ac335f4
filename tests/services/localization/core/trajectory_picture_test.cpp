#include "services/localization/core/trajectory_picture.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/ascii_map.hpp"

namespace tandem {
namespace {

TEST(TrajectoryPicture, ShowsWallsAndBothWays) {
  const OccupancyGrid map = test::ascii_map({"####", "#..#"});
  const std::vector<TimedPose> way{{Time{}, {1.5, 0.5, 0.0}}, {Time{}, {2.5, 0.5, 0.0}}};
  const std::string svg = trajectory_picture(map, way, way);

  EXPECT_TRUE(svg.starts_with("<svg"));
  EXPECT_NE(svg.find("M20.0 32.5H120.0"), std::string::npos);  // the upper wall, 4 m at 25 pixels
  EXPECT_NE(svg.find("57.5 57.5 82.5 57.5"), std::string::npos);
  EXPECT_NE(svg.find(">true<"), std::string::npos);
}

TEST(TrajectoryPicture, LeavesOutATruthThatNobodyKnows) {
  const std::string svg = trajectory_picture(test::ascii_map({"#."}), {}, {});

  EXPECT_EQ(svg.find(">true<"), std::string::npos);
}

}  // namespace
}  // namespace tandem
