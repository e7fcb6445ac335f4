#include "services/cli/calibrate/wheel_calibration.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "calibration/core/wheel_noise.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "services/cli/calibrate/calibrated_files.hpp"
#include "services/cli/calibrate/calibration_page.hpp"
#include "services/cli/map/drive_recording.hpp"
#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

constexpr double kReadingShare = 0.3;
constexpr const char* kUnnamedModel = "p2at";

RecordedDrive recorded_drive(const std::string& file, const std::function<bool(double, const char*)>& keep_going) {
  mcap::Reader reader{mcap::file_source(file), file};
  RecordedDrive recorded =
      read_drive(reader, {}, [&](double share) { return keep_going(kReadingShare * share, "reading"); });
  if (recorded.drive.scans_seen == 0) throw std::runtime_error{file + ": it holds no scans"};
  if (recorded.odometry == 0) throw std::runtime_error{file + ": it holds no odometry"};
  return recorded;
}

/// What the recorded odometry counts with: the configured value, or the model's published one.
double half_track_m(const RobotFiles& files, const std::string& model) {
  double per_m = files.base.half_track_per_m;
  if (per_m <= 0.0) {
    const auto* known = pioneer::robot_parameters(model);
    if (known == nullptr) throw std::runtime_error{"unknown robot model \"" + model + "\": name one with --model"};
    per_m = known->half_track_per_m;
  }
  return files.base.wheels.track_scale / per_m;
}

WheelCorrection combined(const WheelCorrection& recorded, const WheelCorrection& found) {
  return {.left_wheel_scale = recorded.left_wheel_scale * found.left_wheel_scale,
          .right_wheel_scale = recorded.right_wheel_scale * found.right_wheel_scale,
          .track_scale = recorded.track_scale * found.track_scale};
}

}  // namespace

WheelCalibrationResult run_wheel_calibration(const WheelCalibrationOptions& options,
                                             const std::function<bool(double, const char*)>& keep_going) {
  const RobotFiles files = read_robot_files(options.config);
  const RecordedDrive recorded = recorded_drive(options.recording, keep_going);
  WheelCalibrationResult result;
  result.recording = options.recording;
  result.hold_wheels = options.hold_wheels;
  result.model = !options.model.empty() ? options.model : recorded.model;
  result.model_is_known = !result.model.empty();
  if (!result.model_is_known) result.model = kUnnamedModel;
  const auto pairs = motion_pairs(recorded.drive, {}, [&](double share) {
    return keep_going(kReadingShare + (0.95 - kReadingShare) * share, "laying scans onto each other");
  });
  result.motion = driven_motion(pairs);
  result.missing = missing_motion(result.motion, {}, options.hold_wheels);
  if (result.missing.empty()) {
    if (!keep_going(0.95, "solving")) return result;
    result.calibration = calibrated(recorded.drive.odometry, pairs,
                                    {.base_from_laser = recorded.base_from_laser,
                                     .half_track_m = half_track_m(files, result.model),
                                     .hold_wheels = options.hold_wheels});
    result.noise = wheel_noise(result.calibration.residuals);
    result.calibration.wheels = combined(files.base.wheels, result.calibration.wheels);
    result.calibration.laser_clock_s += files.laser.clock_offset_s;
    result.known = knowledge_of(result.calibration, options.hold_wheels);
    result.missing = missing_motion(result.motion, result.known, options.hold_wheels);
  }
  const std::filesystem::path folder{options.output};
  std::filesystem::create_directories(folder);
  if (result.missing.empty()) result.files = write_robot_files(folder, files, result);
  result.files.push_back((folder / "report.html").string());
  write_file_atomically(folder / "report.html", calibration_page(result));
  return result;
}

std::string text_of(const WheelCalibrationResult& result) {
  char line[200];
  std::string text;
  const auto add = [&](const char* format, auto... values) {
    std::snprintf(line, sizeof line, format, values...);
    text += line;
  };
  add("%s: %.0f m straight, %.1f turns to the left, %.1f to the right, %zu pairs of scans\n", result.recording.c_str(),
      result.motion.straight_m, result.motion.left_rad / (2.0 * std::numbers::pi),
      result.motion.right_rad / (2.0 * std::numbers::pi), result.motion.pairs);
  for (const ParameterKnowledge& one : result.known) {
    if (one.held) continue;
    add("%-14s %10.4f +- %.4f %s\n", one.name.c_str(), one.value, one.deviation, one.unit.c_str());
  }
  if (!result.known.empty() && !result.hold_wheels) {
    text += "The wheels are calibrated from the odometry's poses: a recording holds no counts of them.\n";
  }
  if (!result.model_is_known) {
    text += "Nobody named the robot's model: the track is that of a " + result.model + "; --model names another.\n";
  }
  if (!result.missing.empty()) text += "This recording does not calibrate the robot; record another:\n";
  for (const std::string& missing : result.missing) text += "  " + missing + "\n";
  for (const std::string& file : result.files) text += "written: " + file + "\n";
  return text;
}

std::string json_of(const WheelCalibrationResult& result) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
  for (const ParameterKnowledge& one : result.known) {
    parameters[one.name] = {{"value", one.value}, {"deviation", one.deviation}, {"unit", one.unit},
                            {"limit", one.limit}, {"held", one.held},           {"known", one.is_known()}};
  }
  const nlohmann::ordered_json json{{"recording", result.recording},
                                    {"ok", result.missing.empty()},
                                    {"model", result.model},
                                    {"pairs", result.motion.pairs},
                                    {"straight_m", result.motion.straight_m},
                                    {"left_rad", result.motion.left_rad},
                                    {"right_rad", result.motion.right_rad},
                                    {"parameters", parameters},
                                    {"missing", result.missing},
                                    {"files", result.files}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tandem::cli
