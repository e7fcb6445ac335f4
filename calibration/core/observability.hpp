#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/core/joint_calibration.hpp"

namespace tandem {

/// What a recording holds of the motions by which a robot is calibrated, as the scans say.
struct DrivenMotion {
  std::size_t pairs = 0;
  double straight_m = 0.0;  ///< driven with hardly a turn
  double left_rad = 0.0;    ///< turned to the left, all in all
  double right_rad = 0.0;
};
[[nodiscard]] DrivenMotion driven_motion(std::span<const MotionPair> pairs);

/// How well one number is known.
struct ParameterKnowledge {
  std::string name;
  std::string unit;
  double value = 0.0;
  double deviation = 0.0;  ///< standard deviation
  double limit = 0.0;      ///< A larger deviation makes the number useless.
  bool held = false;       ///< It was not looked for.

  [[nodiscard]] bool is_known() const { return held || deviation < limit; }  // not, if it is no number
};

/// Every number that was looked for, in the order of CalibrationParameter; m, degrees, ms and shares.
[[nodiscard]] std::vector<ParameterKnowledge> knowledge_of(const JointCalibration& calibration, bool hold_wheels);

/// What the recording lacks, each as a sentence that tells what to drive; empty if it calibrates the robot. Without
/// numbers, `known` is empty, only the motion is judged.
[[nodiscard]] std::vector<std::string> missing_motion(const DrivenMotion& motion,
                                                      std::span<const ParameterKnowledge> known, bool hold_wheels);

}  // namespace tandem
