#include "services/cli/calibrate/calibrated_files.hpp"

#include <cstdio>

#include "services/cli/calibrate/wheel_calibration.hpp"
#include "services/cli/up/config_text.hpp"
#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

std::string text_in(const std::filesystem::path& folder, const char* name) {
  return folder.empty() || !std::filesystem::exists(folder / name) ? "" : read_file(folder / name);
}

std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6f", value);
  return digits;
}

std::string calibrated_base(const RobotFiles& files, const WheelCorrection& wheels) {
  std::string toml = with_value(files.base_toml, "left_wheel_scale", number(wheels.left_wheel_scale));
  toml = with_value(toml, "right_wheel_scale", number(wheels.right_wheel_scale));
  return with_value(toml, "track_scale", number(wheels.track_scale));
}

std::string calibrated_laser(const RobotFiles& files, const JointCalibration& found) {
  std::string toml = with_value(files.laser_toml, "mount_x_m", number(found.base_from_laser.x));
  toml = with_value(toml, "mount_y_m", number(found.base_from_laser.y));
  toml = with_value(toml, "mount_heading_rad", number(found.base_from_laser.heading));
  return with_value(toml, "clock_offset_s", number(found.laser_clock_s));
}

std::string calibrated_localization(const RobotFiles& files, const MotionNoise& noise) {
  std::string toml = with_value(files.localization_toml, "forward_per_m", number(noise.forward_per_m));
  toml = with_value(toml, "sideways_per_m", number(noise.sideways_per_m));
  toml = with_value(toml, "turn_per_rad", number(noise.turn_per_rad));
  return with_value(toml, "turn_per_m", number(noise.turn_per_m));
}

}  // namespace

RobotFiles read_robot_files(const std::filesystem::path& folder) {
  RobotFiles files{.base_toml = text_in(folder, "base.toml"),
                   .laser_toml = text_in(folder, "laser.toml"),
                   .localization_toml = text_in(folder, "localization.toml"),
                   .base = {},
                   .laser = {}};
  files.base = parse_config<BaseConfig>(files.base_toml, (folder / "base.toml").string());
  files.laser = parse_config<LaserConfig>(files.laser_toml, (folder / "laser.toml").string());
  return files;
}

std::vector<std::string> write_robot_files(const std::filesystem::path& folder, const RobotFiles& files,
                                           const WheelCalibrationResult& result) {
  std::vector<std::string> written;
  const auto write = [&](const char* name, const std::string& toml) {
    write_file_atomically(folder / name, toml);
    written.push_back((folder / name).string());
  };
  if (!result.hold_wheels) {
    write("base.toml", calibrated_base(files, result.calibration.wheels));
    write("localization.toml", calibrated_localization(files, result.noise));
  }
  write("laser.toml", calibrated_laser(files, result.calibration));
  return written;
}

}  // namespace tandem::cli
