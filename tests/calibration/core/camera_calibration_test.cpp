#include "calibration/core/camera_calibration.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cstdio>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr PlacementDeviation kPlacement{};
constexpr double kPixel = 0.2;

/// The corners of a board of 8 x 5, 4 cm apart.
std::vector<Eigen::Vector2d> board() {
  std::vector<Eigen::Vector2d> corners;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 8; ++column) corners.emplace_back(0.04 * (column - 3.5), 0.04 * (row - 2));
  }
  return corners;
}

/// The board with its corners in the base as `base_from_board` has it; empty unless the picture shows all of it.
BoardView view_of(const CameraModel& camera, const Eigen::Isometry3d& base_from_board, Rng& rng) {
  BoardView view;
  for (const Eigen::Vector2d& corner : board()) {
    const auto pixel = pixel_of(camera, base_from_board * Eigen::Vector3d{corner.x(), corner.y(), 0.0});
    if (!pixel || !is_in_picture(camera, *pixel)) return {};
    view.corners.push_back({corner, *pixel + Eigen::Vector2d{rng.normal(0.0, kPixel), rng.normal(0.0, kPixel)}});
  }
  return view;
}

/// Ten places on the ground, laid as exactly as a tape measure allows, and thirty boards held before the camera.
std::vector<BoardView> views_of(const CameraModel& camera, Rng& rng) {
  std::vector<BoardView> views;
  while (views.size() < 10) {
    const Pose2 place{rng.uniform(0.7, 2.0), rng.uniform(-0.5, 0.5), rng.uniform(-3.0, 3.0)};
    Eigen::Isometry3d base_from_board = Eigen::Isometry3d::Identity();
    base_from_board.translate(Eigen::Vector3d{place.x, place.y, 0.0});
    base_from_board.rotate(Eigen::AngleAxisd{place.heading, Eigen::Vector3d::UnitZ()});
    BoardView view = view_of(camera, base_from_board, rng);
    view.base_from_board =
        Pose2{place.x + rng.normal(0.0, kPlacement.position_m), place.y + rng.normal(0.0, kPlacement.position_m),
              place.heading + rng.normal(0.0, kPlacement.heading_rad)};
    if (!view.corners.empty()) views.push_back(view);
  }
  while (views.size() < 40) {
    const Eigen::Vector2d pixel{rng.uniform(100.0, 540.0), rng.uniform(80.0, 400.0)};
    const Eigen::Vector3d ray = ray_in_base(camera, pixel).normalized();
    Eigen::Isometry3d base_from_board = Eigen::Isometry3d::Identity();
    base_from_board.translate(camera.position_in_base + rng.uniform(0.35, 0.7) * ray);
    base_from_board.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), -ray));
    base_from_board.rotate(Eigen::AngleAxisd{rng.uniform(-0.7, 0.7), Eigen::Vector3d::UnitX()});
    base_from_board.rotate(Eigen::AngleAxisd{rng.uniform(-0.7, 0.7), Eigen::Vector3d::UnitY()});
    BoardView view = view_of(camera, base_from_board, rng);
    if (!view.corners.empty()) views.push_back(view);
  }
  return views;
}

CameraModel chance_camera(Rng& rng) {
  return {.width_px = 640,
          .height_px = 480,
          .focal_px = rng.uniform(500.0, 600.0),
          .position_in_base = {rng.uniform(0.1, 0.3), rng.uniform(-0.1, 0.1), rng.uniform(0.5, 0.8)},
          .pitch_rad = from_degrees(rng.uniform(20.0, 35.0)),
          .yaw_rad = from_degrees(rng.uniform(-5.0, 5.0)),
          .roll_rad = from_degrees(rng.uniform(-2.0, 2.0)),
          .principal_offset_px = {rng.uniform(-8.0, 8.0), rng.uniform(-8.0, 8.0)},
          .radial = rng.uniform(-0.15, 0.0)};
}

CameraModel guess() {
  return {.width_px = 640,
          .height_px = 480,
          .focal_px = 550.0,
          .position_in_base = {0.2, 0.0, 0.65},
          .pitch_rad = from_degrees(27.0)};
}

Eigen::Matrix<double, kCameraParameters, 1> off(const CameraModel& found, const CameraModel& truth) {
  Eigen::Matrix<double, kCameraParameters, 1> result;
  result << found.focal_px - truth.focal_px, found.principal_offset_px - truth.principal_offset_px,
      found.radial - truth.radial, found.position_in_base - truth.position_in_base, found.pitch_rad - truth.pitch_rad,
      found.yaw_rad - truth.yaw_rad, found.roll_rad - truth.roll_rad;
  return result;
}

TEST(CameraCalibration, FindsLensAndMountOfAHundredCamerasAndSaysHowWell) {
  double nees = 0.0;
  double worst_m = 0.0;
  double worst_deg = 0.0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Rng rng{seed};
    const CameraModel truth = chance_camera(rng);
    const auto found = calibrated_camera(views_of(truth, rng), guess(), kPlacement);
    const auto error = off(found.model, truth);
    worst_m = std::max(worst_m, error.segment<3>(4).norm());
    worst_deg = std::max(worst_deg, to_degrees(error.tail<3>().cwiseAbs().maxCoeff()));
    nees += error.dot(found.covariance.inverse() * error) / kCameraParameters / 100.0;
  }
  std::printf("worst of 100: mount %.1f mm, %.3f deg; NEES %.3f\n", 1e3 * worst_m, worst_deg, nees);
  EXPECT_LT(worst_m, 0.01);
  EXPECT_LT(worst_deg, 0.2);
  EXPECT_GT(nees, 0.8);
  EXPECT_LT(nees, 1.25);
}

TEST(CameraCalibration, MeasuresHowWellCornersAreFound) {
  Rng rng{5};
  const CameraModel truth = chance_camera(rng);
  EXPECT_NEAR(calibrated_camera(views_of(truth, rng), guess(), kPlacement).pixel_px, kPixel, 0.02);
}

TEST(CameraCalibration, SaysWhatIsMissing) {
  Rng rng{5};
  auto views = views_of(chance_camera(rng), rng);
  EXPECT_TRUE(missing_views(views, nullptr).empty());
  const std::vector<BoardView> laid_alone{views.begin(), views.begin() + 10};
  ASSERT_EQ(missing_views(laid_alone, nullptr).size(), 1u);
  EXPECT_NE(missing_views(laid_alone, nullptr)[0].find("hold the board"), std::string::npos);
  for (BoardView& view : views) {
    if (view.base_from_board) view.base_from_board = Pose2{1.0, 0.0, 0.0};
  }
  ASSERT_EQ(missing_views(views, nullptr).size(), 1u);
  EXPECT_NE(missing_views(views, nullptr)[0].find("near and far"), std::string::npos);
}

}  // namespace
}  // namespace tandem
