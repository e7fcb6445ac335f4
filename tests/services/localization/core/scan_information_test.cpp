#include "services/localization/core/scan_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(SurfaceNormals, StandAcrossALine) {
  Points line;
  for (int i = 0; i < 20; ++i) line.emplace_back(2.0, 0.05 * i);

  for (const Eigen::Vector2d& normal : surface_normals(line)) EXPECT_NEAR(std::abs(normal.x()), 1.0, 1e-6);
}

TEST(SurfaceNormals, AreZeroWhereThereIsNoLine) {
  EXPECT_EQ(surface_normals(Points{{2.0, 0.0}, {2.0, 3.0}})[0], Eigen::Vector2d::Zero());
}

TEST(ScanInformation, KnowsNothingAlongABlankCorridor) {
  OccupancyGrid corridor{200, 20, 0.1, {}, CellState::Free};
  for (int column = 0; column < 200; ++column) {
    corridor.set({column, 0}, CellState::Occupied);
    corridor.set({column, 19}, CellState::Occupied);
  }
  const DistanceField field{corridor, 2.0};
  const Pose2 truth{10.0, 1.0, 0.0};
  const auto endpoints = selected_endpoints(test::scan_from(corridor, truth, Time{}), 180, 5.0, {});
  const ScanInformation told = scan_information(field, endpoints, surface_normals(endpoints), truth, 0.1);

  EXPECT_NEAR(told.information(0, 0), 0.0, 1e-6 * told.information(1, 1));
  EXPECT_GT(told.information(1, 1), 1.0 / (0.02 * 0.02));
}

TEST(ScanInformation, TurnsWithTheWorld) {
  const OccupancyGrid straight = test::uneven_room();
  const Pose2 turn{3.0, -1.0, 0.7};
  OccupancyGrid turned{straight.width(), straight.height(), straight.resolution_m(), turn};
  std::copy(straight.cells().begin(), straight.cells().end(), turned.cells().begin());
  const Pose2 truth{2.5, 1.2, 0.4};
  const auto endpoints = selected_endpoints(test::scan_from(straight, truth, Time{}), 180, 25.0, {});
  const auto normals = surface_normals(endpoints);

  const Eigen::Matrix3d a = scan_information(DistanceField{straight, 2.0}, endpoints, normals, truth, 0.1).information;
  const Eigen::Matrix3d b =
      scan_information(DistanceField{turned, 2.0}, endpoints, normals, turn * truth, 0.1).information;

  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation.topLeftCorner<2, 2>() << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
  EXPECT_LT((rotation * a * rotation.transpose() - b).norm(), 1e-6 * b.norm());
}

}  // namespace
}  // namespace tandem
