#include "services/recorder/core/carmen_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "services/common/file_io.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/test_data.hpp"

namespace tandem::carmen {
namespace {

std::string ranges(int count, const std::string& first = "1.5") {
  std::string text = std::to_string(count) + " " + first;
  for (int i = 1; i < count; ++i) text += " 2";
  return text;
}

std::string error_of(const std::string& text) {
  try {
    (void)parse_log(text, "a.log");
  } catch (const LogError& error) {
    return error.what();
  }
  return "";
}

TEST(CarmenLog, TheOdometryOfACorrectedLogIsTheChainOfTheMotionsBetweenOdomLines) {
  const std::string scan = "FLASER " + ranges(180) + " 10 10 1.5707963267948966 10 10 1.5707963267948966 ";
  const auto events = parse_log(
      "ODOM 0 0 0 0 0 0 1.0 host 1.0\n"
      "ODOM 3 0 0 0 0 0 2.0 host 2.0\n" +
          scan + "2.0 host 2.0\n" +
          "ODOM 10 10 1.5707963267948966 0 0 0 0 host 0\n"  // re-based
          "NEFF 10\n"
          "ODOM 10 14 1.5707963267948966 0 0 0 3.0 host 3.0\n",
      "a.log");
  ASSERT_EQ(events.size(), 4U);  // two odometries, the scan, one more odometry
  EXPECT_EQ(std::get<Scan>(events[2]).time_s, 2.0);
  const auto& last = std::get<Odometry>(events[3]);
  EXPECT_EQ(last.time_s, 3.0);
  EXPECT_NEAR(last.odom_from_base.x, 7.0, 1e-12);  // 3 m, then 4 m straight on
  EXPECT_NEAR(last.odom_from_base.y, 0.0, 1e-12);
  EXPECT_NEAR(last.odom_from_base.heading, 0.0, 1e-12);
}

TEST(CarmenLog, BeforeEachScanStandsAnOdometryOfItsTime) {
  const auto events =
      parse_log("O 1 0 0 0\nO 2 1 0 0\nS 2 1 0 0 " + ranges(180) + "\nS 3 2 0 0 " + ranges(180) + "\n", "b");
  ASSERT_EQ(events.size(), 5U);
  EXPECT_EQ(std::get<Odometry>(events[1]).time_s, 2.0);
  EXPECT_EQ(std::get<Scan>(events[2]).time_s, 2.0);
  EXPECT_EQ(std::get<Odometry>(events[3]).odom_from_base.x, 2.0);
  EXPECT_EQ(std::get<Scan>(events[4]).time_s, 3.0);
}

TEST(CarmenLog, AnOdometryWhoseTimeWasNeverSetIsLeftOut) {
  const auto events = parse_log("O 100 0 0 0\nS 100 0 0 0 " + ranges(180) + "\nO 0.71 0 0 0\nO 99.5 1 0 0\n", "b");
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(std::get<Odometry>(events[2]).time_s, 99.5);  // half a second out of order is how logs are
}

TEST(CarmenLog, TheFieldOfViewIsAHalfCircleFromTheRight) {
  for (const auto& [beams, step_deg] : {std::pair{180, 1.0}, {181, 1.0}, {360, 0.5}, {361, 0.5}}) {
    const auto events = parse_log("S 0 0 0 0 " + ranges(beams), "b");
    const Scan& scan = std::get<Scan>(events.back());
    EXPECT_EQ(scan.ranges_m.size(), static_cast<std::size_t>(beams));
    EXPECT_DOUBLE_EQ(scan.angle_min_rad, -std::numbers::pi / 2.0);
    EXPECT_DOUBLE_EQ(scan.angle_increment_rad, step_deg * std::numbers::pi / 180.0);
  }
}

TEST(CarmenLog, CodesForNoReturnBecomeNaN) {
  for (const std::string code : {"81.83", "81.91", "50.0", "51.3", "32.77", "0", "nan", "inf"}) {
    const auto events = parse_log("S 0 0 0 0 " + ranges(180, code), "b");
    EXPECT_TRUE(std::isnan(std::get<Scan>(events.back()).ranges_m[0])) << code;
  }
  const auto events = parse_log("S 0 0 0 0 " + ranges(180, "32.70"), "b");
  EXPECT_FLOAT_EQ(std::get<Scan>(events.back()).ranges_m[0], 32.7F);
}

TEST(CarmenLog, ABadLineIsNamedByFileAndLine) {
  const std::string good = "S 0 0 0 0 " + ranges(180) + "\n";
  EXPECT_EQ(error_of(good + "O 1 2\n"), "a.log:2: the line ends too early");
  EXPECT_EQ(error_of(good + "# c\nO 1 2 x 4\n"), "a.log:3: \"x\" is not a number");
  EXPECT_EQ(error_of(good + "O 1 2 nan 4\n"), "a.log:2: a pose or time is not finite");
  EXPECT_EQ(error_of("S 0 0 0 0 7 1 1 1 1 1 1 1\n"), "a.log:1: a scan has 180, 181, 360 or 361 beams");
  EXPECT_EQ(error_of(good + "\x7f"
                            "ELF\n"),
            "a.log:2: unknown record \"\x7f"
            "ELF\"");
  EXPECT_EQ(error_of(""), "a.log: holds no scan (FLASER or S line)");
}

/// The odometry at each scan.
std::vector<Odometry> at_scans(const std::vector<Event>& events) {
  std::vector<Odometry> all;
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (std::holds_alternative<Scan>(events[i])) all.push_back(std::get<Odometry>(events[i - 1]));
  }
  return all;
}

class CarmenLogData : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { TANDEM_NEEDS_DATA(GetParam()) }
};

TEST_P(CarmenLogData, TheCorrectedLogAndThePublishedRawOdometryAgree) {
  const std::string name = GetParam();
  const std::string folder = (test::data_folder() / name).string();
  const auto corrected = parse_log(read_log_file(folder + "/" + name + ".corrected.log.gz"), "A");
  const auto raw = parse_log(read_log_file(folder + "/" + name + ".odomscan.txt.gz"), "B");
  const auto a = at_scans(corrected);
  const auto b = at_scans(raw);
  ASSERT_EQ(a.size(), b.size());
  double worst_m = 0.0;  // of the motions from scan to scan, so that print precision does not add up
  for (std::size_t i = 1; i < a.size(); ++i) {
    const Pose2 motion_a = inverse(a[i - 1].odom_from_base) * a[i].odom_from_base;
    const Pose2 motion_b = inverse(b[i - 1].odom_from_base) * b[i].odom_from_base;
    worst_m = std::max(worst_m, (motion_a.position() - motion_b.position()).norm());
  }
  EXPECT_LT(worst_m, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Recorded, CarmenLogData, testing::Values("fr079", "intel"),
                         [](const auto& test) { return test.param; });

TEST(CarmenLogFile, AGzipFileCutShortIsRefused) {
  const std::string gzip{
      // of "O 0 0 0 0\n", without its last four bytes
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\xf3\x57\x30\x50\x30\x40\x42\x2e\x00\xa5\x7e\x39\x0b", 23};
  const test::TemporaryFolder folder;
  const auto file = folder / "torn.gz";
  write_file_atomically(file, gzip);
  EXPECT_THROW((void)read_log_file(file.string()), LogError);
}

}  // namespace
}  // namespace tandem::carmen
