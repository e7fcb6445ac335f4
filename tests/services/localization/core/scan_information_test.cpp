#include "services/localization/core/scan_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "services/common/random.hpp"
#include "services/localization/core/beams.hpp"
#include "services/localization/core/surface_normals.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

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

TEST(ScanInformation, TellsOfOneDirectionThatItIsFreeThoughNoiseTurnsIt) {
  OccupancyGrid corridor{200, 20, 0.1, {}, CellState::Free};
  for (int column = 0; column < 200; ++column) {
    corridor.set({column, 0}, CellState::Occupied);
    corridor.set({column, 19}, CellState::Occupied);
  }
  const DistanceField field{corridor, 2.0};
  const Pose2 truth{10.0, 1.0, 0.0};
  auto endpoints = selected_endpoints(test::scan_from(corridor, truth, Time{}), 180, 5.0, {});
  Rng rng{1};
  for (Eigen::Vector2d& endpoint : endpoints) endpoint.y() += rng.normal(0.0, 0.02);
  const Eigen::Vector2d before{std::cos(0.05), std::sin(0.05)};
  const auto normals = surface_normals(endpoints);

  EXPECT_NEAR(std::abs(scan_information(field, endpoints, normals, truth, 0.1).free_in_map.x()), 1.0, 1e-3);
  EXPECT_EQ(scan_information(field, endpoints, normals, truth, 0.1, before).free_in_map, before);
  // Far from it: another corridor.
  const Eigen::Vector2d elsewhere{0.0, 1.0};
  EXPECT_NEAR(std::abs(scan_information(field, endpoints, normals, truth, 0.1, elsewhere).free_in_map.x()), 1.0, 1e-3);
}

TEST(ScanInformation, TellsLessWhereThingsThatAreNotOnTheMapPull) {
  const OccupancyGrid map = test::uneven_room();
  const DistanceField field{map, 2.0};
  const Pose2 truth{2.5, 1.2, 0.4};
  auto endpoints = selected_endpoints(test::scan_from(map, truth, Time{}), 180, 25.0, {});
  const auto normals = surface_normals(endpoints);
  const double alone = scan_information(field, endpoints, normals, truth, 0.1).information.determinant();
  for (std::size_t i = 0; i < endpoints.size(); i += 10) endpoints[i] *= 0.5;

  EXPECT_LT(scan_information(field, endpoints, normals, truth, 0.1).information.determinant(), 0.5 * alone);
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
