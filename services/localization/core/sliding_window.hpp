#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/localization/core/motion_model.hpp"
#include "services/localization/core/pose_refinement.hpp"
#include "services/localization/core/scan_information.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// How the window weighs scans and wheels.
struct WindowOptions {
  std::size_t scans = 3;             ///< poses that are still moved
  std::size_t older_beams = 60;      ///< of each scan but the newest
  double loss_m = 0.1;               ///< Beams further from a wall than this count less and less (Cauchy).
  double beam_weight = 0.5;          ///< Neighbouring beams err together: each counts as this much of one.
  double map_deviation_m = 0.00125;  ///< How wrong a map is whatever the scans say, to be added to the covariance.
};

/// The last poses of the robot, found together: each scan on the map, the wheels between them, and a prior that holds
/// all that was known before (Ceres, Levenberg-Marquardt; the oldest pose is marginalised out by a Schur complement).
class SlidingWindow {
 public:
  /// `field` must outlive the window.
  SlidingWindow(const DistanceField& field, const WindowOptions& options) : field_(field), options_(options) {}

  /// Forgets the past: the next pose is held by the filter alone.
  void restart() { frames_.clear(); }

  /// The newest pose, near the filter's, at which the scan and all others in the window fit best.
  ///
  /// `motion` is what the wheels say since the pose before, `deviation` how wrong that may be. The window begins with
  /// what the filter knows; a pose of the filter far from what the window expects makes it begin anew.
  [[nodiscard]] RefinedPose add(const RefinedPose& filtered, std::span<const Eigen::Vector2d> endpoints_in_base,
                                const Pose2& motion, const MotionDeviation& deviation);

 private:
  struct Frame {
    Eigen::Vector3d pose;  ///< x, y, heading in the map
    std::vector<Eigen::Vector2d> endpoints_in_base;
    std::vector<Eigen::Vector2d> normals_in_base;
    Pose2 motion;                      ///< from the frame before
    Eigen::Matrix3d root_information;  ///< of that motion
  };

  void solve();
  void measure();
  [[nodiscard]] Eigen::MatrixXd information() const;
  void drop_oldest();

  const DistanceField& field_;
  WindowOptions options_;
  std::deque<Frame> frames_;                               ///< oldest first
  Pose2 prior_;                                            ///< of the oldest
  Eigen::Matrix3d prior_information_;                      ///< of the oldest
  std::vector<ScanInformation> measurements_;              ///< of each frame, where it is now
  Eigen::Vector2d free_in_map_ = Eigen::Vector2d::Zero();  ///< of which the newest scan told nothing
  double deviation_m_ = 0.05;                              ///< of a beam, as scans turned out lately
};

}  // namespace tandem
