#pragma once

#include <optional>

#include "services/simulator/core/phone_user.hpp"

namespace tandem::simulator {

/// How often a person presses *My pose*, and how exactly they point.
struct MyPoseHabit {
  double shortest_s = 6.0;       ///< From one press to the next: evenly from this
  double longest_s = 10.0;       ///< to this,
  double forgotten_share = 0.0;  ///< but this share of the presses comes later,
  double latest_s = 10.0;        ///< evenly from longest_s to this.
  double error_m = 0.3;          ///< Root mean square of its distance from the truth.
};

/// The habit of the volunteers (paper, table 1): 6.4 presses a minute, 73 % of them within 10 s of the last.
///
/// 0.73 * (5 + 10) / 2 + 0.27 * (10 + 18.9) / 2 = 9.4 s from one press to the next.
[[nodiscard]] inline MyPoseHabit habit_of_volunteers() {
  return {.shortest_s = 5.0, .longest_s = 10.0, .forgotten_share = 0.27, .latest_s = 18.9};
}

/// Presses *My pose* by habit, the first time at once.
class MyPoseButton {
 public:
  explicit MyPoseButton(const MyPoseHabit& habit) : habit_(habit) {}

  /// The message, if it is pressed now.
  [[nodiscard]] std::optional<PhoneMessage> pressed(const PhoneUserInput& input, Rng& rng);

 private:
  MyPoseHabit habit_;
  std::optional<Time> next_;
};

}  // namespace tandem::simulator
