#include "calibration/core/camera_residual.hpp"

#include <ceres/autodiff_cost_function.h>
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "robot/camera/core/camera_model.hpp"

namespace tandem {
namespace {

const Picture kPicture{.middle_px = {319.5, 239.5}, .deviation_px = 1.0};

CameraModel camera() {
  return {.width_px = 640,
          .height_px = 480,
          .focal_px = 550.0,
          .position_in_base = {0.2, 0.05, 0.65},
          .pitch_rad = 0.5,
          .yaw_rad = 0.03,
          .roll_rad = -0.02,
          .principal_offset_px = {4.0, -3.0},
          .radial = -0.1};
}
std::vector<double> lens_of(const CameraModel& model) {
  return {model.focal_px, model.principal_offset_px.x(), model.principal_offset_px.y(), model.radial};
}
std::vector<double> mount_of(const CameraModel& model) {
  return {model.position_in_base.x(),
          model.position_in_base.y(),
          model.position_in_base.z(),
          model.pitch_rad,
          model.yaw_rad,
          model.roll_rad};
}

/// The value of `cost` at `blocks`; compares its derivatives with differences on the way.
template <typename Cost>
Eigen::VectorXd checked_value(const Cost& cost, std::vector<std::vector<double>> blocks) {
  const int rows = cost.num_residuals();
  const auto value_at = [&] {
    std::vector<const double*> at;
    for (const auto& block : blocks) at.push_back(block.data());
    Eigen::VectorXd value(rows);
    EXPECT_TRUE(cost.Evaluate(at.data(), value.data(), nullptr));
    return value;
  };
  std::vector<std::vector<double>> derivatives;
  for (const auto& block : blocks) derivatives.emplace_back(static_cast<std::size_t>(rows) * block.size());
  std::vector<double*> rows_of;
  for (auto& derivative : derivatives) rows_of.push_back(derivative.data());
  std::vector<const double*> at;
  for (const auto& block : blocks) at.push_back(block.data());
  Eigen::VectorXd value(rows);
  EXPECT_TRUE(cost.Evaluate(at.data(), value.data(), rows_of.data()));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t i = 0; i < blocks[b].size(); ++i) {
      constexpr double kStep = 1e-6;
      const double here = blocks[b][i];
      blocks[b][i] = here + kStep;
      const Eigen::VectorXd more = value_at();
      blocks[b][i] = here - kStep;
      const Eigen::VectorXd less = value_at();
      blocks[b][i] = here;
      for (int row = 0; row < rows; ++row) {
        const double derivative = derivatives[b][static_cast<std::size_t>(row) * blocks[b].size() + i];
        EXPECT_NEAR(derivative, (more(row) - less(row)) / (2.0 * kStep), 1e-3 + 1e-6 * std::abs(derivative))
            << "block " << b << " parameter " << i << " row " << row;
      }
    }
  }
  return value;
}

TEST(CornerResidual, IsWhatTheCameraModelSeesLessThePicture) {
  const CameraModel model = camera();
  const double quarter = std::numbers::pi / 2.0;
  // A board turned by a quarter: its (0.1, 0.05) lies at (-0.05, 0.1) from its middle.
  const auto pixel = pixel_of(model, {1.2 - 0.05, 0.1 + 0.1, 0.0});
  ASSERT_TRUE(pixel);
  const SeenCorner corner{{0.1, 0.05}, *pixel - Eigen::Vector2d{3.0, -4.0}};
  const ceres::AutoDiffCostFunction<CornerResidual, 2, 4, 6, 3> cost{new CornerResidual{corner, kPicture}};
  const Eigen::VectorXd off = checked_value(cost, {lens_of(model), mount_of(model), {1.2, 0.1, quarter}});
  EXPECT_NEAR(off(0), 3.0, 1e-9);
  EXPECT_NEAR(off(1), -4.0, 1e-9);
}

TEST(HeldCornerResidual, IsWhereTheLensShowsTheCornerLessThePicture) {
  // 2 m ahead, not turned: the corner 0.1 m to the right is at slope 0.05.
  const std::vector<double> lens{500.0, 10.0, 20.0, 0.0};
  const SeenCorner corner{{0.1, 0.0}, {319.5 + 10.0 + 25.0, 239.5 + 20.0}};
  const ceres::AutoDiffCostFunction<HeldCornerResidual, 2, 4, 6> cost{new HeldCornerResidual{corner, kPicture}};
  EXPECT_LT(checked_value(cost, {lens, {0.0, 0.0, 0.0, 0.0, 0.0, 2.0}}).norm(), 1e-9);
  static_cast<void>(checked_value(cost, {{500.0, 1.0, 2.0, -0.2}, {0.3, -0.2, 0.5, 0.1, -0.1, 1.0}}));
}

TEST(PlacementResidual, CountsInDeviations) {
  const ceres::AutoDiffCostFunction<PlacementResidual, 3, 3> cost{
      new PlacementResidual{{1.0, 0.0, 0.5}, {0.002, 0.002, 0.004}}};
  const Eigen::VectorXd off = checked_value(cost, {{1.002, -0.004, 0.512}});
  EXPECT_NEAR(off(0), 1.0, 1e-9);
  EXPECT_NEAR(off(1), -2.0, 1e-9);
  EXPECT_NEAR(off(2), 3.0, 1e-9);
}

}  // namespace
}  // namespace tandem
