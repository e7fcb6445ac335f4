#include "services/localization/core/pose_prediction.hpp"

#include <cmath>

namespace tandem {

std::optional<LocalizationResult> predicted(const OdometryResult& last, const OdometrySample& now,
                                            const MotionNoise& noise, Duration longest) {
  const Duration ahead = now.time - last.odometry.time;
  if (now.epoch != last.odometry.epoch || ahead < Duration::zero() || ahead > longest) return std::nullopt;

  const Pose2 motion = inverse(last.odometry.odom_from_base) * now.odom_from_base;
  const Pose2& before = last.result.map_from_base;
  LocalizationResult result = last.result;
  result.time = now.time;
  result.map_from_base = before * motion;
  for (PoseHypothesis& hypothesis : result.hypotheses) hypothesis.map_from_base = hypothesis.map_from_base * motion;

  // A turn that was wrong before moves what came after sideways; the motion's own errors lie along the new heading.
  Eigen::Matrix3d carried = Eigen::Matrix3d::Identity();
  carried(0, 2) = -(result.map_from_base.y - before.y);
  carried(1, 2) = result.map_from_base.x - before.x;
  const double c = std::cos(result.map_from_base.heading);
  const double s = std::sin(result.map_from_base.heading);
  Eigen::Matrix3d map_from_robot = Eigen::Matrix3d::Identity();
  map_from_robot.topLeftCorner<2, 2>() << c, -s, s, c;
  const MotionDeviation deviation = deviation_of(motion, noise);
  const Eigen::Vector3d variances{deviation.forward_m * deviation.forward_m,
                                  deviation.sideways_m * deviation.sideways_m, deviation.turn_rad * deviation.turn_rad};
  result.covariance = carried * last.result.covariance * carried.transpose() +
                      map_from_robot * variances.asDiagonal() * map_from_robot.transpose();
  return result;
}

}  // namespace tandem
