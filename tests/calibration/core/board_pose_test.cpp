#include "calibration/core/board_pose.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr double kFocal_px = 500.0;
const Eigen::Vector2d kMiddle_px{320.0, 240.0};

/// The corners of a board 0.3 m wide and 0.2 m high at `camera_from_board`, as a lens without bend shows them.
std::vector<SeenCorner> seen(const Eigen::Isometry3d& camera_from_board) {
  std::vector<SeenCorner> corners;
  for (const double x : {-0.15, 0.0, 0.15}) {
    for (const double y : {-0.1, 0.1}) {
      const Eigen::Vector3d point = camera_from_board * Eigen::Vector3d{x, y, 0.0};
      corners.push_back({{x, y}, kMiddle_px + kFocal_px * point.head<2>() / point.z()});
    }
  }
  return corners;
}

Eigen::Isometry3d isometry_of(const std::array<double, 6>& pose) {
  const Eigen::Vector3d turn{pose[0], pose[1], pose[2]};
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translate(Eigen::Vector3d{pose[3], pose[4], pose[5]});
  if (turn.norm() > 0.0) result.rotate(Eigen::AngleAxisd{turn.norm(), turn.normalized()});
  return result;
}

TEST(BoardPose, OfABoardStraightBeforeTheCameraIsItsDistance) {
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  truth.translate(Eigen::Vector3d{0.0, 0.0, 2.0});
  const auto pose = camera_from_board(seen(truth), kMiddle_px, kFocal_px);
  EXPECT_NEAR(pose[5], 2.0, 1e-9);
  for (const std::size_t zero : {0, 1, 2, 3, 4}) EXPECT_NEAR(pose[zero], 0.0, 1e-9) << zero;
}

TEST(BoardPose, IsFoundAnywhereBeforeTheCamera) {
  constexpr std::uint64_t kSeed = 3;
  Rng rng{kSeed};
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << kSeed << " board " << i);
    Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
    truth.translate(Eigen::Vector3d{rng.uniform(-0.5, 0.5), rng.uniform(-0.4, 0.4), rng.uniform(0.5, 3.0)});
    truth.rotate(Eigen::AngleAxisd{rng.uniform(-3.0, 3.0), Eigen::Vector3d::UnitZ()});
    truth.rotate(Eigen::AngleAxisd{rng.uniform(-1.0, 1.0), Eigen::Vector3d::UnitX()});
    truth.rotate(Eigen::AngleAxisd{rng.uniform(-0.5, 0.5), Eigen::Vector3d::UnitY()});
    const auto found = isometry_of(camera_from_board(seen(truth), kMiddle_px, kFocal_px));
    EXPECT_LT((found.matrix() - truth.matrix()).norm(), 1e-6);
  }
}

TEST(BoardPose, FourCornersAreEnough) {
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  truth.translate(Eigen::Vector3d{0.1, -0.2, 1.0});
  auto corners = seen(truth);
  corners.erase(corners.begin() + 2, corners.begin() + 4);  // the two in the middle
  const auto pose = camera_from_board(corners, kMiddle_px, kFocal_px);
  EXPECT_NEAR(pose[3], 0.1, 1e-9);
  EXPECT_NEAR(pose[4], -0.2, 1e-9);
  EXPECT_NEAR(pose[5], 1.0, 1e-9);
}

}  // namespace
}  // namespace tandem
