#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/laser/core/laser_config.hpp"
#include "robot/pioneer/base_config.hpp"

namespace tandem::cli {

struct WheelCalibrationResult;

/// The files that the robot drove with, as text; empty where there are none.
struct RobotFiles {
  std::string base_toml;
  std::string laser_toml;
  std::string localization_toml;
  BaseConfig base;
  LaserConfig laser;
};

/// Reads base.toml, laser.toml and localization.toml of `folder`; an empty name gives the built-in values. Throws
/// ConfigError, FileError.
[[nodiscard]] RobotFiles read_robot_files(const std::filesystem::path& folder);

/// Writes the files with what was found, comments and all other lines as they were; gives their names. Where there were
/// none they hold what was found alone.
[[nodiscard]] std::vector<std::string> write_robot_files(const std::filesystem::path& folder, const RobotFiles& files,
                                                         const WheelCalibrationResult& result);

}  // namespace tandem::cli
