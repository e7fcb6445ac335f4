#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <cmath>

#include "services/common/angle.hpp"
#include "services/common/pose2.hpp"

namespace tandem {

/// A measured motion between two poses a and b of the base in the map, by the wheels or by laying scans together:
///
///   r = S (R(a)^T (p_b - p_a) - p_z,  b - a - z)
/// with the motion z = (p_z, z) seen from a, and S^T S its information: forward, sideways, turn.
class RelativePoseResidual final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  RelativePoseResidual(const Pose2& before_from_after, const Eigen::Matrix3d& root_information)
      : before_from_after_(before_from_after), root_information_(root_information) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Map<const Eigen::Vector3d> a{parameters[0]};
    const Eigen::Map<const Eigen::Vector3d> b{parameters[1]};
    const double c = std::cos(a.z());
    const double s = std::sin(a.z());
    const Eigen::Vector2d way = b.head<2>() - a.head<2>();
    const Eigen::Vector2d seen{c * way.x() + s * way.y(), -s * way.x() + c * way.y()};
    Eigen::Map<Eigen::Vector3d> residual{residuals};
    residual << seen - before_from_after_.position(), wrap_to_pi(b.z() - a.z() - before_from_after_.heading);
    residual = root_information_ * residual.eval();
    if (jacobians == nullptr) return true;
    using Jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    if (jacobians[0] != nullptr) {
      Eigen::Map<Jacobian> by_a{jacobians[0]};
      by_a << -c, -s, seen.y(), s, -c, -seen.x(), 0.0, 0.0, -1.0;
      by_a = root_information_ * by_a.eval();
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Jacobian> by_b{jacobians[1]};
      by_b << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
      by_b = root_information_ * by_b.eval();
    }
    return true;
  }

 private:
  Pose2 before_from_after_;
  Eigen::Matrix3d root_information_;
};

/// What all that has left the window said of its oldest pose: r = S (pose - mean), S^T S the information, the turn
/// taken the short way.
class MarginalResidual final : public ceres::SizedCostFunction<3, 3> {
 public:
  MarginalResidual(const Pose2& mean, const Eigen::Matrix3d& root_information)
      : mean_(mean), root_information_(root_information) {}

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Vector3d away{parameters[0][0] - mean_.x, parameters[0][1] - mean_.y,
                               turn_between(mean_.heading, parameters[0][2])};
    Eigen::Map<Eigen::Vector3d>{residuals} = root_information_ * away;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{jacobians[0]} = root_information_;
    }
    return true;
  }

 private:
  Pose2 mean_;
  Eigen::Matrix3d root_information_;
};

}  // namespace tandem
