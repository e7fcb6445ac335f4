#include "calibration/core/board_pose.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace tandem {

std::array<double, 6> camera_from_board(std::span<const SeenCorner> corners, const Eigen::Vector2d& middle_px,
                                        double focal_px) {
  // The homography from the board's plane to slopes, by the direct linear transform.
  Eigen::MatrixXd equations(2 * static_cast<Eigen::Index>(corners.size()), 9);
  Eigen::Index row = 0;
  for (const SeenCorner& corner : corners) {
    const Eigen::Vector2d slope = (corner.pixel - middle_px) / focal_px;
    const Eigen::RowVector3d point{corner.point_in_board.x(), corner.point_in_board.y(), 1.0};
    const Eigen::RowVector3d none = Eigen::RowVector3d::Zero();
    equations.row(row++) << point, none, -slope.x() * point;
    equations.row(row++) << none, point, -slope.y() * point;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> solved{equations, Eigen::ComputeFullV};
  const Eigen::VectorXd values = solved.matrixV().col(8);
  Eigen::Matrix3d homography;
  homography << values.head<3>().transpose(), values.segment<3>(3).transpose(), values.tail<3>().transpose();
  // Its columns are two axes of the board and its place, all by one factor; the board is before the camera.
  homography /= (homography(2, 2) < 0.0 ? -1.0 : 1.0) * homography.col(0).norm();
  Eigen::Matrix3d axes;
  axes << homography.col(0), homography.col(1), homography.col(0).cross(homography.col(1));
  const Eigen::JacobiSVD<Eigen::Matrix3d> nearest{axes, Eigen::ComputeFullU | Eigen::ComputeFullV};
  const Eigen::AngleAxisd turn{Eigen::Matrix3d{nearest.matrixU() * nearest.matrixV().transpose()}};
  const Eigen::Vector3d angle_axis = turn.angle() * turn.axis();
  const Eigen::Vector3d place = homography.col(2);
  return {angle_axis.x(), angle_axis.y(), angle_axis.z(), place.x(), place.y(), place.z()};
}

}  // namespace tandem
