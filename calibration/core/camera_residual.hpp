#pragma once

#include <ceres/rotation.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace tandem {

/// A corner of the board, in the board's plane [m], and where the picture shows it [px].
struct SeenCorner {
  Eigen::Vector2d point_in_board;
  Eigen::Vector2d pixel;
};

/// Where a lens (focal, principal right and down from the middle, radial) shows a slope, and how exactly.
struct Picture {
  Eigen::Vector2d middle_px;
  double deviation_px = 1.0;

  template <typename Scalar>
  bool off(const Scalar* lens, const Scalar& right, const Scalar& down, const Eigen::Vector2d& pixel,
           Scalar* residuals) const {
    const Scalar scale = lens[0] * (1.0 + lens[3] * (right * right + down * down));
    residuals[0] = (middle_px.x() + lens[1] + scale * right - pixel.x()) / deviation_px;
    residuals[1] = (middle_px.y() + lens[2] + scale * down - pixel.y()) / deviation_px;
    return true;
  }
};

/// One corner of a board that lies on the ground:
///
///   r = (p(c) - pixel) / deviation
/// with the corner c in the base by the board's place (x, y, heading), and the picture p of it by the lens (focal,
/// principal right and down from the middle, radial) and the mount (x, y, z, pitch, yaw, roll), as CameraModel has
/// them.
class CornerResidual {
 public:
  CornerResidual(const SeenCorner& corner, const Picture& picture) : corner_(corner), picture_(picture) {}

  template <typename Scalar>
  bool operator()(const Scalar* lens, const Scalar* mount, const Scalar* board, Scalar* residuals) const {
    using std::cos;
    using std::sin;
    using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
    const double x = corner_.point_in_board.x();
    const double y = corner_.point_in_board.y();
    const Scalar cb = cos(board[2]);
    const Scalar sb = sin(board[2]);
    const Vector3 from_lens{board[0] + cb * x - sb * y - mount[0], board[1] + sb * x + cb * y - mount[1], -mount[2]};
    const Scalar cp = cos(mount[3]), sp = sin(mount[3]);
    const Scalar cy = cos(mount[4]), sy = sin(mount[4]);
    const Vector3 level{sy, -cy, Scalar(0.0)};
    const Vector3 down{-sp * cy, -sp * sy, -cp};
    const Vector3 axis{cp * cy, cp * sy, -sp};
    const Scalar depth = from_lens.dot(axis);
    const Scalar across = from_lens.dot(level) / depth;
    const Scalar below = from_lens.dot(down) / depth;
    const Scalar cr = cos(mount[5]), sr = sin(mount[5]);
    const Scalar right = cr * across + sr * below;
    const Scalar lower = cr * below - sr * across;
    return picture_.off(lens, right, lower, corner_.pixel, residuals);
  }

 private:
  SeenCorner corner_;
  Picture picture_;
};

/// One corner of a board that somebody holds before the camera, anyhow: as CornerResidual, with the board's place in
/// the camera (right, down, ahead) as angle-axis and translation.
class HeldCornerResidual {
 public:
  HeldCornerResidual(const SeenCorner& corner, const Picture& picture) : corner_(corner), picture_(picture) {}

  template <typename Scalar>
  bool operator()(const Scalar* lens, const Scalar* camera_from_board, Scalar* residuals) const {
    const std::array<Scalar, 3> corner{Scalar(corner_.point_in_board.x()), Scalar(corner_.point_in_board.y()),
                                       Scalar(0.0)};
    std::array<Scalar, 3> seen;
    ceres::AngleAxisRotatePoint(camera_from_board, corner.data(), seen.data());
    for (std::size_t i = 0; i < 3; ++i) seen[i] += camera_from_board[3 + i];
    return picture_.off(lens, Scalar(seen[0] / seen[2]), Scalar(seen[1] / seen[2]), corner_.pixel, residuals);
  }

 private:
  SeenCorner corner_;
  Picture picture_;
};

/// Where a board was laid, by the tape measure: r = (board - measured) / deviation, for x, y and heading.
class PlacementResidual {
 public:
  PlacementResidual(const Eigen::Vector3d& measured, const Eigen::Vector3d& deviation)
      : measured_(measured), deviation_(deviation) {}

  template <typename Scalar>
  bool operator()(const Scalar* board, Scalar* residuals) const {
    for (int i = 0; i < 3; ++i) residuals[i] = (board[i] - measured_(i)) / deviation_(i);
    return true;
  }

 private:
  Eigen::Vector3d measured_;
  Eigen::Vector3d deviation_;
};

}  // namespace tandem
