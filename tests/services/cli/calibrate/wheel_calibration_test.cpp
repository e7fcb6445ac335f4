#include "services/cli/calibrate/wheel_calibration.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "bench/calibration/simulated_recording.hpp"
#include "robot/laser/core/laser_config.hpp"
#include "robot/pioneer/base_config.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "services/common/file_io.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/recorder/carmen_import.hpp"
#include "services/recorder/recording_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

const auto kGoOn = [](double, const char*) { return true; };

carmen::Event carmen_event(const std::variant<OdometrySample, LaserScan>& event) {
  if (const auto* odometry = std::get_if<OdometrySample>(&event)) {
    return carmen::Odometry{to_seconds(odometry->time.time_since_epoch()), odometry->odom_from_base,
                            odometry->velocity};
  }
  const auto& scan = std::get<LaserScan>(event);
  return carmen::Scan{.time_s = to_seconds(scan.time.time_since_epoch()),
                      .angle_min_rad = scan.angle_min_rad,
                      .angle_increment_rad = scan.angle_increment_rad,
                      .ranges_m = scan.ranges_m,
                      .range_min_m = scan.range_min_m,
                      .range_max_m = scan.range_max_m,
                      .base_from_laser = scan.base_from_laser};
}

void write(const bench::SimulatedRecording& recording, const std::filesystem::path& file) {
  std::vector<carmen::Event> events;
  for (const auto& event : recording.events) events.push_back(carmen_event(event));
  recorder::write_recording(file, [&](mcap::Writer& writer) { recorder::write_carmen(events, "robot1", writer); });
}

TEST(WheelCalibration, MakesOfARecordingTheFilesThatTheServicesRead) {
  const test::TemporaryFolder folder;
  const auto recording = bench::simulated_recording(3, {});
  write(recording, folder / "drive.mcap");
  std::filesystem::create_directories(folder / "config");
  // The simulated robot counts with half a track of 0.2 m, and drove with wheels corrected by 2 % already.
  std::ofstream{folder / "config" / "base.toml"} << "# ours\nsonar = false\nhalf_track_per_m = 5.0\n"
                                                    "left_wheel_scale = 1.02\nright_wheel_scale = 1.02\n";
  const auto result = run_wheel_calibration({.recording = (folder / "drive.mcap").string(),
                                             .output = (folder / "out").string(),
                                             .config = (folder / "config").string()},
                                            kGoOn);
  EXPECT_TRUE(result.missing.empty());
  const std::string base_toml = read_file(folder / "out" / "base.toml");
  EXPECT_NE(base_toml.find("# ours\nsonar = false"), std::string::npos);
  const auto base = load_config<BaseConfig>(folder / "out" / "base.toml");
  EXPECT_NEAR(base.wheels.left_wheel_scale, 1.02 * recording.wheels.left_wheel_scale, 0.003);
  EXPECT_NEAR(base.wheels.track_scale, recording.wheels.track_scale, 0.003);
  const auto laser = load_config<LaserConfig>(folder / "out" / "laser.toml");
  EXPECT_NEAR(laser.mount_x_m, recording.base_from_laser.x, 0.003);
  EXPECT_NEAR(laser.clock_offset_s, recording.laser_clock_s, 0.005);
  EXPECT_LT(load_config<LocalizationConfig>(folder / "out" / "localization.toml").wheels.forward_per_m,
            kUncalibratedWheels.forward_per_m);
  const std::string page = read_file(folder / "out" / "report.html");
  EXPECT_NE(page.find("Everything was found"), std::string::npos);
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("src="), std::string::npos);  // needs no other file
}

TEST(WheelCalibration, WritesNoConfigurationFromADriveThatLacksMotion) {
  const test::TemporaryFolder folder;
  write(bench::simulated_recording(4, {.duration_s = 120.0, .drives = false}), folder / "drive.mcap");
  const auto result = run_wheel_calibration(
      {.recording = (folder / "drive.mcap").string(), .output = (folder / "out").string()}, kGoOn);
  ASSERT_EQ(result.missing.size(), 1u);
  EXPECT_NE(text_of(result).find("drive straight at least 5 m"), std::string::npos);
  EXPECT_NE(json_of(result).find("\"ok\": false"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "base.toml"));
  EXPECT_NE(read_file(folder / "out" / "report.html").find("does not calibrate"), std::string::npos);
}

TEST(WheelCalibration, LeavesTheWheelsAloneWhereOnlyTheLaserIsAskedFor) {
  const test::TemporaryFolder folder;
  write(bench::simulated_recording(3, {}), folder / "drive.mcap");
  const auto result = run_wheel_calibration(
      {.recording = (folder / "drive.mcap").string(), .output = (folder / "out").string(), .hold_wheels = true}, kGoOn);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "laser.toml"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "base.toml"));
  EXPECT_FALSE(result.model_is_known);
}

}  // namespace
}  // namespace tandem::cli
