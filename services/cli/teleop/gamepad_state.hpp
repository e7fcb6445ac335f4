#pragma once

#include <linux/joystick.h>

#include <optional>
#include <string>

#include "services/cli/teleop/operator_keys.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::cli {

/// Which of a gamepad's axes and buttons do what, by the numbers of the kernel's joystick interface. The defaults are
/// those of the pads that most others imitate: the left stick drives while the left shoulder button is held.
struct GamepadLayout {
  int forward_axis = 1;
  int turn_axis = 0;
  int drive_button = 4;
  int resume_button = 7;
};

/// What a gamepad asks for: it drives as its stick says while the drive button is held.
///
/// A pad whose radio is lost may leave its last state standing, so that counts for kSilence after the last event
/// alone; a stick in a hand trembles and makes events all the time.
class GamepadState {
 public:
  static constexpr Duration kSilence = std::chrono::seconds{2};

  GamepadState(const GamepadLayout& layout, const TeleopSpeeds& speeds) : layout_(layout), speeds_(speeds) {}

  void take(const js_event& event, Time now);
  /// The velocity asked for now; none while the drive button is not held.
  [[nodiscard]] std::optional<Twist2> wanted(Time now) const;
  /// For how long the resume button was held [s], once it is let go.
  [[nodiscard]] std::optional<double> take_resume();

 private:
  GamepadLayout layout_;
  TeleopSpeeds speeds_;
  double forward_ = 0.0;  ///< [-1, 1]
  double turn_ = 0.0;     ///< [-1, 1], counter-clockwise
  bool driving_ = false;
  std::optional<Time> resume_since_;
  std::optional<double> resume_;
  Time heard_{};
};

}  // namespace tandem::cli
