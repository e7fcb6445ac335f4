#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <deque>
#include <optional>
#include <span>

#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// How much longer lengths are on the map than a scan measured them.
struct ScaleMeasurement {
  double log_scale = 0.0;    ///< natural logarithm of the ratio
  double information = 0.0;  ///< inverse variance of it; 0 where the scan tells nothing
};

/// What beams that end at `endpoints_in_base` [m] tell about the map's scale, taken near `map_from_base`.
///
/// Gauss-Newton on the robust squared distances to the nearest wall, with five unknowns: the pose, the scale s, and an
/// offset b of all ranges, as a wall on the map is thicker or thinner than it is: a beam of range r ends at s r + b.
/// A wrong scale shows where walls lie on opposite sides, and far ones miss more than near ones.
[[nodiscard]] ScaleMeasurement scale_measurement(const DistanceField& field,
                                                 std::span<const Eigen::Vector2d> endpoints_in_base,
                                                 const Pose2& map_from_base, const Eigen::Vector2d& laser_in_base);

/// When a scale that scans measured on the way is believed to be wrong.
struct MapScaleOptions {
  double way_m = 20.0;     ///< What was measured longer ago is forgotten.
  double least_m = 12.0;   ///< Over less way nothing is said.
  double named = 0.018;    ///< A mean further from 0, by twice its own deviation, is wrong [log scale] ...
  double cleared = 0.012;  ///< ... until one is nearer than this, by as much.
};

/// The same for a map in cells of `resolution_m`: lengths are told no better than to a share of a cell, and these
/// values are those for 5 cm.
[[nodiscard]] inline MapScaleOptions map_scale_options(double resolution_m) {
  MapScaleOptions options;
  const double coarser = std::max(1.0, resolution_m / 0.05);
  options.named *= coarser;
  options.cleared *= coarser;
  return options;
}

/// Watches the scale over the last metres.
class MapScaleWatch {
 public:
  explicit MapScaleWatch(const MapScaleOptions& options = {}) : options_(options) {}

  static constexpr double kSpacingM = 0.25;  ///< A scan after less way says what the one before said.
  /// Is the next measurement wanted, `way_m` along the way?
  [[nodiscard]] bool is_due(double way_m) const;
  void add(const ScaleMeasurement& measurement, double way_m);

  /// How many times too long lengths on the map are, where that is beyond doubt.
  [[nodiscard]] std::optional<double> wrong_scale() const { return wrong_scale_; }

 private:
  struct Entry {
    double way_m = 0.0;
    ScaleMeasurement measurement;
  };

  void judge();

  MapScaleOptions options_;
  std::deque<Entry> entries_;  ///< oldest first
  std::optional<double> wrong_scale_;
};

}  // namespace tandem
