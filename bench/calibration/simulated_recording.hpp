#pragma once

#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "calibration/core/joint_calibration.hpp"
#include "services/map_builder/core/drive_log.hpp"

namespace tandem::bench {

/// How a robot drives that is to be calibrated, and how it measures.
struct RecordingOptions {
  double duration_s = 360.0;
  double wheel_noise_m = 0.003;     ///< of each wheel [m / sqrt(m)]
  double range_deviation_m = 0.01;  ///< of a beam's range
  bool drives = true;               ///< false: it only turns on the spot
  bool turns_left = true;           ///< false: it turns to the right only
  bool turns_right = true;          ///< false: it turns to the left only
  double slip_share = 0.02;         ///< of the legs: there the wheels report 0.3 m less than it drove
};

/// A drive in a furnished room, with all that calibration is to find out.
struct SimulatedRecording {
  WheelCorrection wheels;                                         ///< true
  Pose2 base_from_laser;                                          ///< true
  double laser_clock_s = 0.0;                                     ///< true
  CalibrationStart start{};                                       ///< what the recording says
  std::vector<std::variant<OdometrySample, LaserScan>> events{};  ///< what was recorded
  Drive drive{};                                                  ///< the same
  std::vector<std::pair<Time, Pose2>> world_from_laser{};         ///< true, by the scans' stamps
};

/// Equal seed, equal recording. Scans are cast against straight walls, at 10 Hz like the odometry; radii and track are
/// off by up to 5 %, the laser by up to 3 cm and 2 degrees, its clock by up to 50 ms.
[[nodiscard]] SimulatedRecording simulated_recording(std::uint64_t seed, const RecordingOptions& options);

/// How far an estimate is from the truth.
struct CalibrationErrors {
  double wheels_share = 0.0;  ///< the largest of both radii and the track, relative
  double laser_m = 0.0;
  double laser_deg = 0.0;
  double clock_s = 0.0;
  double nees = 0.0;  ///< over its expectation, 7: 1 is honest
};
[[nodiscard]] CalibrationErrors errors_of(const JointCalibration& estimate, const SimulatedRecording& truth);

}  // namespace tandem::bench
