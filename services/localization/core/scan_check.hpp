#pragma once

#include <optional>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/input_faults.hpp"
#include "services/localization/core/laser_scan.hpp"

namespace tandem {

/// Finds what is wrong with scans in themselves, whatever the map says.
class ScanCheck {
 public:
  /// Why `scan`, taken with the wheels at `odom_from_base`, must not be used; none if it may.
  ///
  /// - its number of beams, its angles or the laser's place differ from the scans before; ten such in a row are the new
  ///   rule, for somebody may have changed the laser
  /// - all that returned did so from the very same range
  /// - its ranges are, to the last bit, those of a scan taken elsewhere
  [[nodiscard]] std::optional<InputFault> fault_of(const LaserScan& scan, const Pose2& odom_from_base);

 private:
  struct Geometry {
    std::size_t beams = 0;
    double angle_min_rad = 0.0;
    double angle_increment_rad = 0.0;
    Pose2 base_from_laser;
    friend bool operator==(const Geometry&, const Geometry&) = default;
  };

  [[nodiscard]] bool is_of_another_laser(const LaserScan& scan);
  [[nodiscard]] bool is_stuck(const LaserScan& scan, const Pose2& odom_from_base);

  std::optional<Geometry> geometry_;
  Geometry other_;                    ///< of the last scan that differed, ...
  int others_ = 0;                    ///< ... and how many like it came in a row
  std::vector<float> seen_ranges_m_;  ///< of the last scan that differed from the one before ...
  Pose2 seen_at_;                     ///< ... and where the wheels were then
};

}  // namespace tandem
