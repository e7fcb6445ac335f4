#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem::safety {

/// A scan as it came, unchecked.
struct ScanView {
  std::uint64_t sequence_number = 0;
  Time stamp{};  ///< of the first beam
  Pose2 base_from_laser;
  double angle_min_rad = 0.0;
  double angle_increment_rad = 0.0;
  double range_min_m = 0.0;
  double range_max_m = 0.0;
  std::span<const float> ranges_m;  ///< NaN: no return or unusable
};

/// Judges the laser: does it still send, does it see, does the picture change when the robot moves?
class ScanMonitor {
 public:
  explicit ScanMonitor(const GateConfig& config);

  /// Takes a scan that arrived at `now`, with the odometry of that moment. Allocates nothing up to kMostBeams.
  void take(const ScanView& scan, const Pose2& odom_from_base, Time now);
  /// What is wrong with the laser at `now`.
  [[nodiscard]] Causes causes(Time now) const;
  /// Age of what is known of the surroundings [s]; infinite before the first scan.
  [[nodiscard]] double age_s(Time now) const;
  /// What the newest usable scan hit.
  [[nodiscard]] std::span<const Eigen::Vector2d> points_in_base() const { return points_in_base_; }

  static constexpr std::size_t kMostBeams = 8192;

 private:
  /// Share of unusable beams, and whether anything but one value was seen; fills points_in_base_.
  [[nodiscard]] bool is_usable(const ScanView& scan);
  void compare_with_last(const ScanView& scan, const Pose2& odom_from_base);

  const GateConfig& config_;
  std::vector<Eigen::Vector2d> points_in_base_;
  std::optional<Time> arrived_;
  Time stamp_{};
  std::optional<std::uint64_t> sequence_number_;
  bool bad_ = false;
  bool stuck_ = false;
  std::uint64_t fingerprint_ = 0;
  int repetitions_ = 0;
  Pose2 odom_at_first_of_same_;
};

}  // namespace tandem::safety
