#pragma once

#include "services/common/pose2.hpp"
#include "services/navigator/core/navigator_config.hpp"
#include "services/navigator/core/path.hpp"

namespace tandem::navigator {

/// What the path asks for, before any obstacle has a say.
struct Aim {
  double way_m = 0.0;                       ///< Of the path that is behind.
  double remaining_m = 0.0;                 ///< Of the path that is ahead.
  double cross_track_m = 0.0;               ///< Distance from the path.
  Eigen::Vector2d point_in_base{0.0, 0.0};  ///< The point on the path aimed at.
  double bearing_rad = 0.0;                 ///< Of that point.
  double curvature = 0.0;                   ///< Of the arc through that point that begins ahead [1/m].
  bool turn_in_place = false;               ///< The bearing is too large for an arc.
  bool arrived = false;                     ///< Within the goal's tolerance.
};

/// Follows one path at a time by pure pursuit: aims at a point of the path some way ahead (Coulter, "Implementation of
/// the pure pursuit path tracking algorithm", CMU-RI-TR-92-01), turning in place where that point lies far aside.
class PathFollower {
 public:
  explicit PathFollower(const NavigatorConfig& config) : config_(config) {}

  /// Begins `path` at the place nearest to `position_in_map`; where it comes by twice, at the earlier one.
  void begin(Path path, const Eigen::Vector2d& position_in_map);
  [[nodiscard]] const Path& path() const { return path_; }

  /// Where to aim from `map_from_base`, at `speed_mps`. Keeps how much of the path is done: it never goes back.
  [[nodiscard]] Aim aim(const Pose2& map_from_base, double speed_mps);

 private:
  NavigatorConfig config_;
  Path path_;
  double way_m_ = 0.0;
  bool turning_ = false;
};

}  // namespace tandem::navigator
