#include "services/localization/core/surface_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

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

TEST(SurfaceNormals, LeaveOutAPointInFrontOfTheLine) {
  Points line;
  for (int i = 0; i < 11; ++i) line.emplace_back(2.0, 0.05 * i);
  line[6].x() = 1.9;

  EXPECT_NEAR(std::abs(surface_normals(line)[5].x()), 1.0, 1e-6);
}

TEST(SurfaceNormals, StandAcrossAWallThatIsGrazed) {
  // Beams 1 degree apart that meet a wall 1 m to the left, 9 to 14 m ahead: 1.5 m and more from point to point.
  Points wall;
  for (const double degrees : {6.0, 5.5, 5.0, 4.5, 4.0}) {
    wall.emplace_back(1.0 / std::tan(degrees * std::numbers::pi / 180.0), 1.0);
  }

  EXPECT_NEAR(std::abs(surface_normals(wall)[2].y()), 1.0, 1e-6);
}

TEST(SurfaceNormals, AreZeroBetweenTwoThingsOneBehindTheOther) {
  // Three points on one, three on the other, all nearly along one beam.
  const Points edge{{3.0, 0.3}, {3.0, 0.31}, {3.0, 0.32}, {9.0, 0.9}, {9.0, 0.92}, {9.0, 0.94}};

  EXPECT_EQ(surface_normals(edge)[2], Eigen::Vector2d::Zero());
}

}  // namespace
}  // namespace tandem
