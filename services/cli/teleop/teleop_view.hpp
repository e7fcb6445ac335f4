#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/cli/teleop/operator_keys.hpp"
#include "services/common/pose2.hpp"

namespace tandem::cli {

/// What an operator is shown.
struct TeleopView {
  /// What the base says of itself.
  struct Base {
    bool connected = false;
    bool motors_enabled = false;
    double battery_v = 0.0;
    double speed_limit_mps = 0.0;
    std::vector<std::string> stopped_by;  ///< in words
    bool latched = false;
    double resume_in_s = 0.0;
    std::string model;
  };
  TeleopSpeeds speeds;
  Twist2 wanted;
  std::optional<Base> base;        ///< none while its service is silent
  std::optional<Twist2> measured;  ///< by its wheels, while that is fresh
  std::string gamepad;             ///< its name, or that it is gone; empty without one
  std::string resume_answer;       ///< why the last resume was refused
};

/// The screen, line by line.
[[nodiscard]] std::vector<std::string> lines_of(const TeleopView& view);

}  // namespace tandem::cli
