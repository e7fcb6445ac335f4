#include "calibration/core/observability.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace tandem {
namespace {

constexpr std::size_t kLeastPairs = 20;
constexpr double kStraightRad = 0.15;  ///< A pair that turned more was not straight.
constexpr double kLeastStraightM = 5.0;
constexpr double kLeastTurnRad = 2.0 * std::numbers::pi;

std::string sentence(const char* format, double has) {
  char text[200];
  std::snprintf(text, sizeof text, format, has);
  return text;
}

/// What helps a parameter that is not known well enough.
std::string advice_for(CalibrationParameter parameter) {
  switch (parameter) {
    case CalibrationParameter::LeftWheel:
    case CalibrationParameter::RightWheel:
    case CalibrationParameter::LaserHeading:
      return "drive straight for longer, at least 5 m at a time and past things that stand out";
    case CalibrationParameter::Track:
    case CalibrationParameter::LaserX:
    case CalibrationParameter::LaserY:
      return "turn more on the spot, both ways, where the laser sees walls all around";
    case CalibrationParameter::LaserClock:
      return "start and stop turning more often: only changes of speed tell the clocks apart";
  }
  return {};
}

void add_once(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

}  // namespace

DrivenMotion driven_motion(std::span<const MotionPair> pairs) {
  DrivenMotion motion{.pairs = pairs.size()};
  for (const MotionPair& pair : pairs) {
    const double turn = pair.motion.heading;
    if (std::abs(turn) < kStraightRad) motion.straight_m += pair.motion.position().norm();
    (turn > 0.0 ? motion.left_rad : motion.right_rad) += std::abs(turn);
  }
  return motion;
}

std::vector<ParameterKnowledge> knowledge_of(const JointCalibration& c, bool hold_wheels) {
  const auto at = [&](CalibrationParameter parameter) { return c.deviation(parameter); };
  using enum CalibrationParameter;
  return {{"left wheel", "", c.wheels.left_wheel_scale, at(LeftWheel), 0.01, hold_wheels},
          {"right wheel", "", c.wheels.right_wheel_scale, at(RightWheel), 0.01, hold_wheels},
          {"track", "", c.wheels.track_scale, at(Track), 0.02, hold_wheels},
          {"laser x", "m", c.base_from_laser.x, at(LaserX), 0.03, false},
          {"laser y", "m", c.base_from_laser.y, at(LaserY), 0.03, false},
          {"laser heading", "deg", to_degrees(c.base_from_laser.heading), to_degrees(at(LaserHeading)), 1.0, false},
          {"laser clock", "ms", 1e3 * c.laser_clock_s, 1e3 * at(LaserClock), 50.0, false}};
}

std::vector<std::string> missing_motion(const DrivenMotion& motion, std::span<const ParameterKnowledge> known,
                                        bool hold_wheels) {
  std::vector<std::string> missing;
  if (motion.pairs < kLeastPairs) {
    missing.push_back("drive longer: only " + std::to_string(motion.pairs) +
                      " pairs of scans could be laid onto each other, 20 are needed");
  }
  if (motion.straight_m < kLeastStraightM) {
    missing.push_back(sentence("drive straight at least 5 m: it drove %.1f m straight", motion.straight_m));
  }
  const double turns = 1.0 / kLeastTurnRad;
  if (hold_wheels) {
    if (motion.left_rad + motion.right_rad < kLeastTurnRad) {
      missing.push_back(
          sentence("turn once round at least: it turned %.2f times", turns * (motion.left_rad + motion.right_rad)));
    }
  } else {
    if (motion.left_rad < kLeastTurnRad) {
      missing.push_back(
          sentence("turn both ways: to the left it turned %.2f times, once is needed", turns * motion.left_rad));
    }
    if (motion.right_rad < kLeastTurnRad) {
      missing.push_back(
          sentence("turn both ways: to the right it turned %.2f times, once is needed", turns * motion.right_rad));
    }
  }
  for (std::size_t i = 0; i < known.size() && missing.empty(); ++i) {
    if (known[i].is_known()) continue;
    for (std::size_t j = i; j < known.size(); ++j) {
      if (!known[j].is_known()) add_once(missing, advice_for(static_cast<CalibrationParameter>(j)));
    }
  }
  return missing;
}

}  // namespace tandem
