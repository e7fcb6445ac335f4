#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <cmath>

#include "services/common/angle.hpp"
#include "services/common/pose2.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem {

/// One beam against the map: the distance from where it ends to the nearest wall [m].
///
///   r(x, y, a) = D(p),  p = (x, y) + R(a) q
///   dr/d(x, y) = grad D(p),  dr/da = grad D(p) . R'(a) q
/// with the distance field D, the base's pose (x, y, a) in the map and the endpoint q in the base frame.
class ScanResidual final : public ceres::SizedCostFunction<1, 3> {
 public:
  /// `field` must outlive the residual.
  ScanResidual(const DistanceField& field, const Eigen::Vector2d& endpoint_in_base)
      : field_(field), endpoint_in_base_(endpoint_in_base) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const double c = std::cos(parameters[0][2]);
    const double s = std::sin(parameters[0][2]);
    const Eigen::Vector2d arm{c * endpoint_in_base_.x() - s * endpoint_in_base_.y(),
                              s * endpoint_in_base_.x() + c * endpoint_in_base_.y()};
    const auto [distance_m, gradient] = field_.smooth({parameters[0][0] + arm.x(), parameters[0][1] + arm.y()});
    residuals[0] = distance_m;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      jacobians[0][0] = gradient.x();
      jacobians[0][1] = gradient.y();
      jacobians[0][2] = gradient.y() * arm.x() - gradient.x() * arm.y();
    }
    return true;
  }

 private:
  const DistanceField& field_;
  Eigen::Vector2d endpoint_in_base_;
};

/// What was believed before the scan: r = W (pose - prior), with W = diag(1 / deviation), the turn taken the short way.
class PriorResidual final : public ceres::SizedCostFunction<3, 3> {
 public:
  PriorResidual(const Pose2& map_from_base, double weight_per_m, double weight_per_rad)
      : map_from_base_(map_from_base), weight_per_m_(weight_per_m), weight_per_rad_(weight_per_rad) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    residuals[0] = weight_per_m_ * (parameters[0][0] - map_from_base_.x);
    residuals[1] = weight_per_m_ * (parameters[0][1] - map_from_base_.y);
    residuals[2] = weight_per_rad_ * turn_between(map_from_base_.heading, parameters[0][2]);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> jacobian{jacobians[0]};
      jacobian = Eigen::Vector3d{weight_per_m_, weight_per_m_, weight_per_rad_}.asDiagonal();
    }
    return true;
  }

 private:
  Pose2 map_from_base_;
  double weight_per_m_;
  double weight_per_rad_;
};

}  // namespace tandem
