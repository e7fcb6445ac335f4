#pragma once

#include <optional>
#include <vector>

#include "robot/pioneer/core/extra_packets.hpp"

namespace tandem::pioneer {

/// Turns the readings of the gyro into a turn. What it reads at rest drifts with its temperature, and is measured anew
/// whenever the wheels stand.
///
/// 300 deg/s are 2.5 V of the 5 V that 1023 stands for, times a factor of the robot's parameter file (1.626).
class Gyro {
 public:
  /// Takes readings 25 ms apart; `standing` while the wheels do.
  void take(const std::vector<GyroReading>& readings, bool standing);
  /// The turn since the last call, counter-clockwise [rad]; none if no reading came, or none at rest before.
  [[nodiscard]] std::optional<double> take_turn();
  /// Forgets all, for another controller.
  void restart() { *this = {}; }

 private:
  std::optional<double> rest_;
  double sum_ = 0.0;
  int count_ = 0;  ///< readings in sum_, at rest
  std::optional<double> turn_rad_;
};

}  // namespace tandem::pioneer
