#pragma once

#include <Eigen/Core>
#include <deque>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/odometry_history.hpp"

namespace tandem {

/// What the last scans saw together, held together by odometry: tells places apart that look alike in one scan.
class Panorama {
 public:
  /// How much is kept.
  struct Extent {
    double way_m = 4.0;        ///< Scans taken longer ago on the way are forgotten: odometry drifts.
    double spacing_m = 0.3;    ///< A scan that moved less ...
    double spacing_rad = 0.3;  ///< ... and turned less since the last one kept replaces it.
  };
  explicit Panorama(const Extent& extent) : extent_(extent) {}

  /// Takes a scan's `endpoints_in_base` [m] with the odometry at its time; another epoch forgets all before.
  void add(const OdometrySample& odometry, std::span<const Eigen::Vector2d> endpoints_in_base);
  void clear() { views_.clear(); }

  /// All that was seen, from the base at the last scan, at most one point in each square of `cell_m`.
  [[nodiscard]] std::vector<Eigen::Vector2d> endpoints_in_base(double cell_m) const;
  /// How far the robot drove while it saw this [m].
  [[nodiscard]] double way_m() const;

 private:
  struct View {
    Pose2 odom_from_base;
    double way_m = 0.0;  ///< driven up to here
    std::vector<Eigen::Vector2d> endpoints_in_base;
  };

  Extent extent_;
  int epoch_ = 0;
  std::deque<View> views_;  ///< oldest first; the last is the newest scan
};

}  // namespace tandem
