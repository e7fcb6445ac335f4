#include "services/localization/core/trajectory_file.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(TrajectoryFile, HasSixDecimalsOfTimeAndNineOfPose) {
  EXPECT_EQ(trajectory_line({from_stamp_ns(1'500'000'400), {1.0, -2.25, 0.5}}),
            "1.500000 1.000000000 -2.250000000 0.500000000\n");
}

TEST(TrajectoryFile, IsReadBack) {
  const std::vector<TimedPose> poses{{from_stamp_ns(1'000'000'000), {1.0, 2.0, 3.0}},
                                     {from_stamp_ns(2'500'000'000), {-1.0, 0.125, -3.0}}};

  const auto back = parse_trajectory("# a comment\n\n" + trajectory_text(poses), "t.txt");

  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(back[1].time, poses[1].time);
  EXPECT_EQ(back[1].map_from_base, poses[1].map_from_base);
}

TEST(TrajectoryFile, RefusesALineThatIsNoPoseWithItsPlace) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      (void)parse_trajectory(text, "t.txt");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint("1 2 3 4\n1 2 3\n"), "t.txt:2: expected 4 numbers");
  EXPECT_EQ(complaint("1 2 3 four\n"), "t.txt:1: expected 4 numbers");
  EXPECT_EQ(complaint("1 2 3 nan\n"), "t.txt:1: expected 4 numbers");
}

}  // namespace
}  // namespace tandem
