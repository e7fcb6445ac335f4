#include "services/cli/calibrate/camera_run.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "robot/camera/core/camera_config.hpp"
#include "services/common/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

constexpr double kSquareM = 0.04;
constexpr int kFiner = 2;  ///< Rays per pixel, each way.

CameraModel true_camera() {
  return {.width_px = 480,
          .height_px = 360,
          .focal_px = 420.0,
          .position_in_base = {0.22, 0.03, 0.62},
          .pitch_rad = from_degrees(28.0),
          .yaw_rad = from_degrees(2.0),
          .roll_rad = from_degrees(-1.0),
          .principal_offset_px = {4.0, -3.0},
          .radial = -0.08};
}

/// 9 x 6 squares on white paper with a rim of a square, on grey ground.
double shade_of(const Eigen::Vector2d& point_in_board) {
  const double column = point_in_board.x() / kSquareM + 4.5;
  const double row = point_in_board.y() / kSquareM + 3.0;
  if (column < -1.0 || column > 10.0 || row < -1.0 || row > 7.0) return 120.0;
  if (column < 0.0 || column > 9.0 || row < 0.0 || row > 6.0) return 240.0;
  return (static_cast<int>(column) + static_cast<int>(row)) % 2 == 0 ? 20.0 : 240.0;
}

cv::Mat picture_of(const CameraModel& camera, const Eigen::Isometry3d& base_from_board) {
  const Eigen::Isometry3d board_from_base = base_from_board.inverse();
  const Eigen::Vector3d lens = board_from_base * camera.position_in_base;
  cv::Mat picture(camera.height_px, camera.width_px, CV_8UC1);
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      double sum = 0.0;
      for (int i = 0; i < kFiner * kFiner; ++i) {
        const Eigen::Vector2d pixel{u + (i % kFiner + 0.5) / kFiner - 0.5, v + (i / kFiner + 0.5) / kFiner - 0.5};
        const Eigen::Vector3d ray = board_from_base.linear() * ray_in_base(camera, pixel);
        const double length = -lens.z() / ray.z();
        sum += length > 0.0 ? shade_of((lens + length * ray).head<2>()) : 200.0;
      }
      picture.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(std::lround(sum / (kFiner * kFiner)));
    }
  }
  return picture;
}

Eigen::Isometry3d laid_at(const Pose2& place) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d{place.x, place.y, 0.0});
  pose.rotate(Eigen::AngleAxisd{place.heading, Eigen::Vector3d::UnitZ()});
  return pose;
}

Eigen::Isometry3d held(const CameraModel& camera, Rng& rng) {
  const Eigen::Vector2d pixel{rng.uniform(160.0, 320.0), rng.uniform(120.0, 240.0)};
  const Eigen::Vector3d ray = ray_in_base(camera, pixel).normalized();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(camera.position_in_base + rng.uniform(0.55, 0.8) * ray);
  pose.rotate(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), -ray));
  pose.rotate(Eigen::AngleAxisd{rng.uniform(-0.6, 0.6), Eigen::Vector3d::UnitX()});
  pose.rotate(Eigen::AngleAxisd{rng.uniform(-0.6, 0.6), Eigen::Vector3d::UnitY()});
  return pose;
}

TEST(CameraRun, MakesOfPicturesTheFileThatTheCameraReads) {
  const test::TemporaryFolder folder;
  const CameraModel truth = true_camera();
  Rng rng{4};
  std::ofstream ground{folder / "ground.txt"};
  ground << "# picture x y heading\n";
  const std::vector<Pose2> places{{0.8, 0.0, 0.0},  {0.9, 0.1, 1.0},  {1.0, -0.15, -0.5}, {1.1, 0.1, 2.0},
                                  {1.2, -0.2, 3.0}, {0.95, 0.2, 0.3}, {1.25, 0.2, -2.0}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string name = "laid" + std::to_string(i) + ".png";
    cv::imwrite((folder / name).string(), picture_of(truth, laid_at(places[i])));
    ground << name << " " << places[i].x << " " << places[i].y << " " << to_degrees(places[i].heading) << "\n";
  }
  ground.close();
  for (int i = 0; i < 14; ++i) {
    cv::imwrite((folder / ("held" + std::to_string(i) + ".png")).string(), picture_of(truth, held(truth, rng)));
  }
  const CameraCalibrationResult result = run_camera_calibration({.pictures = folder.path().string(),
                                                                 .ground = (folder / "ground.txt").string(),
                                                                 .output = (folder / "out").string()});
  ASSERT_TRUE(result.good) << result.text;
  const auto found = load_config<CameraConfig>(folder / "out" / "camera.toml").model();
  EXPECT_LT((found.position_in_base - truth.position_in_base).norm(), 0.01) << result.text;
  EXPECT_NEAR(to_degrees(found.pitch_rad), to_degrees(truth.pitch_rad), 0.2);
  EXPECT_NEAR(to_degrees(found.yaw_rad), to_degrees(truth.yaw_rad), 0.2);
  EXPECT_NEAR(found.focal_px, truth.focal_px, 4.0);
}

TEST(CameraRun, SaysWhatPicturesAreMissing) {
  const test::TemporaryFolder folder;
  cv::imwrite((folder / "one.png").string(), picture_of(true_camera(), laid_at({0.9, 0.0, 0.0})));
  std::ofstream{folder / "ground.txt"} << "one.png 0.9 0.0 0\n";
  const CameraCalibrationResult result = run_camera_calibration({.pictures = folder.path().string(),
                                                                 .ground = (folder / "ground.txt").string(),
                                                                 .output = (folder / "out").string()});
  EXPECT_FALSE(result.good);
  EXPECT_NE(result.text.find("lay the board on the ground at 3 places at least: it was found at 1"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "camera.toml"));
}

}  // namespace
}  // namespace tandem::cli
