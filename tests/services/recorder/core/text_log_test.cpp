#include "services/recorder/core/text_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tandem {
namespace {

const std::string kGeometry =
    "# SCAN_GEOMETRY angle_min -1.0 angle_increment 0.5 n 3 range_min 0.02 range_max 5.6 frame laser\n";

std::string complaint_about(const std::string& text) {
  try {
    (void)parse_text_log(text, "log.txt", {});
  } catch (const carmen::LogError& error) {
    return error.what();
  }
  return "";
}

TEST(TextLog, GivesOdometryAndScansInTheirOrder) {
  const auto events =
      parse_text_log("ODOM 0.5 1 2 0.25 0.4 0.1\n" + kGeometry + "AMCL 0.5 1 1 1\nSCAN 0.6 0.019 2.5 nan\n", "log.txt",
                     {0.1, 0.0, 0.0});

  ASSERT_EQ(events.size(), 2U);
  const auto& odometry = std::get<carmen::Odometry>(events[0]);
  EXPECT_EQ(odometry.odom_from_base, (Pose2{1.0, 2.0, 0.25}));
  EXPECT_EQ(odometry.velocity, (Twist2{0.4, 0.0, 0.1}));
  const auto& scan = std::get<carmen::Scan>(events[1]);
  EXPECT_EQ(scan.time_s, 0.6);
  EXPECT_EQ(scan.angle_min_rad, -1.0);
  EXPECT_EQ(scan.range_max_m, 5.6);
  EXPECT_EQ(scan.base_from_laser.x, 0.1);
  ASSERT_EQ(scan.ranges_m.size(), 3U);
  EXPECT_TRUE(std::isnan(scan.ranges_m[0]));  // below range_min
  EXPECT_EQ(scan.ranges_m[1], 2.5F);
  EXPECT_TRUE(std::isnan(scan.ranges_m[2]));
}

TEST(TextLog, SaysWhichLineIsWrong) {
  EXPECT_EQ(complaint_about("SCAN 0.6 1\n"), "log.txt:1: a scan before any # SCAN_GEOMETRY line");
  EXPECT_EQ(complaint_about(kGeometry + "SCAN 0.6 1 2\n"), "log.txt:2: a scan of 2 ranges, and not 3");
  EXPECT_EQ(complaint_about("ODOM 0.5 1 2\n"), "log.txt:1: ODOM wants t x y theta v w");
  EXPECT_EQ(complaint_about("ODOM 0.5 1 2 x 0 0\n"), "log.txt:1: \"x\" is not a number");
  EXPECT_EQ(complaint_about("BLAH 1\n"), "log.txt:1: unknown record \"BLAH\"");
  EXPECT_EQ(complaint_about("ODOM 0.5 1 2 0 0 0\n"), "log.txt: holds no scan (SCAN line)");
  EXPECT_EQ(complaint_about("# SCAN_GEOMETRY angle_min 0\n"), "log.txt:1: SCAN_GEOMETRY does not tell angle_increment");
}

}  // namespace
}  // namespace tandem
