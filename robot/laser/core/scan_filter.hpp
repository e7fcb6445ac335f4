#pragma once

#include <string>
#include <vector>

#include "robot/laser/core/laser_config.hpp"
#include "robot/laser/core/laser_reading.hpp"

namespace tandem {

/// Takes away beams that ended at nothing real.
///
/// Veils: where a beam meets an edge and what is behind it, some lasers measure a range between the two. Such a point
/// has a neighbour before it and one behind it, both nearly along its beam. The nearer side of an edge stays.
///
/// Dirt: a spot on the window returns the same beams from next to nothing, scan after scan. Only a narrow spot is taken
/// away: what covers more of the window is left for the gate to stop at.
class ScanFilter {
 public:
  explicit ScanFilter(const LaserConfig& config)
      : veil_angle_rad_(config.veil_angle_rad), dirt_range_m_(config.dirt_range_m) {}

  /// Sets what is not real to NaN.
  void apply(LaserReading& reading);
  /// That the window is dirty, in words; empty when it is not.
  [[nodiscard]] std::string complaint() const;

 private:
  void take_veils_away(LaserReading& reading) const;
  void take_dirt_away(LaserReading& reading);

  double veil_angle_rad_;
  double dirt_range_m_;
  std::vector<int> near_in_a_row_;  ///< for each beam, scans with a range within dirt_range_m
  int dirty_beams_ = 0;
};

}  // namespace tandem
