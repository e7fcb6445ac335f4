#include "services/map_builder/core/scan_registration.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem {
namespace {

/// The walls of a room 6 m x 4 m around the origin, a point each 0.05 m, seen from within.
Surface room() {
  Surface surface;
  for (int i = 0; i <= 120; ++i) {
    const double x = -3.0 + 0.05 * i;
    surface.push_back({{x, -2.0}, {0.0, 1.0}});
    surface.push_back({{x, 2.0}, {0.0, -1.0}});
  }
  for (int i = 0; i <= 80; ++i) {
    const double y = -2.0 + 0.05 * i;
    surface.push_back({{-3.0, y}, {1.0, 0.0}});
    surface.push_back({{3.0, y}, {-1.0, 0.0}});
  }
  return surface;
}

TEST(ScanRegistration, FindsBackWhereTheScanWasTaken) {
  const SurfaceIndex reference{room()};
  Rng rng{11};
  for (int i = 0; i < 50; ++i) {
    const Pose2 truth{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-3, 3)};
    const Surface scan = inverse(truth) * room();
    const Pose2 guess = truth * Pose2{rng.uniform(-0.15, 0.15), rng.uniform(-0.15, 0.15), rng.uniform(-0.06, 0.06)};
    const Registration found = registered(reference, scan, guess, {});
    EXPECT_LT((found.reference_from_scan.position() - truth.position()).norm(), 1e-3) << "sample " << i;
    EXPECT_LT(std::abs(turn_between(found.reference_from_scan.heading, truth.heading)), 1e-3) << "sample " << i;
    EXPECT_EQ(found.matched_share, 1.0);
    EXPECT_LT(found.spread_m, 1e-3);
  }
}

TEST(ScanRegistration, TurnsWithTheWorld) {
  const Surface scan = inverse(Pose2{0.3, -0.2, 0.1}) * room();
  const Pose2 world{4.0, -7.0, 2.0};
  const Registration here = registered(SurfaceIndex{room()}, scan, {0.25, -0.1, 0.12}, {});
  const Registration there = registered(SurfaceIndex{world * room()}, scan, world * Pose2{0.25, -0.1, 0.12}, {});
  const Pose2 apart = inverse(world * here.reference_from_scan) * there.reference_from_scan;
  EXPECT_LT(apart.position().norm(), 1e-9);
  EXPECT_LT(std::abs(apart.heading), 1e-9);
  // In the corners two points are equally near, and either may be taken.
  EXPECT_LT((here.information - there.information).norm(), 0.05 * here.information.norm());
}

TEST(ScanRegistration, KnowsNothingAlongABlankWall) {
  Surface wall;
  for (int i = 0; i <= 100; ++i) wall.push_back({{-2.5 + 0.05 * i, 2.0}, {0.0, -1.0}});
  const Registration found = registered(SurfaceIndex{wall}, wall, {0.3, 0.0, 0.0}, {});
  EXPECT_NEAR(found.reference_from_scan.x, 0.3, 1e-6);  // as it was guessed
  EXPECT_NEAR(found.reference_from_scan.y, 0.0, 1e-6);
  EXPECT_LT(found.information(0, 0), 1e-6 * found.information(1, 1));
}

TEST(ScanRegistration, KeepsTheTwoSidesOfAWallApart) {
  Surface near_side;
  Surface far_side;
  for (int i = 0; i <= 100; ++i) {
    near_side.push_back({{2.0, -2.5 + 0.05 * i}, {-1.0, 0.0}});
    far_side.push_back({{2.1, -2.5 + 0.05 * i}, {1.0, 0.0}});
  }
  const Registration found = registered(SurfaceIndex{near_side}, far_side, {}, {});
  EXPECT_NEAR(found.reference_from_scan.x, 0.0, 1e-9);  // not drawn over by the 0.1 m between them
}

TEST(ScanRegistration, IsHeldByAStrongPrior) {
  const Surface scan = inverse(Pose2{0.1, 0.0, 0.0}) * room();
  RegistrationOptions options;
  options.prior = 1e9 * Eigen::Matrix3d::Identity();
  EXPECT_NEAR(registered(SurfaceIndex{room()}, scan, {}, options).reference_from_scan.x, 0.0, 1e-3);
}

TEST(ScanRegistration, MakesNothingOfNothing) {
  const Registration found = registered(SurfaceIndex{Surface{}}, {}, {1.0, 2.0, 0.5}, {});
  EXPECT_EQ(found.reference_from_scan, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_EQ(found.matched_share, 0.0);
  EXPECT_TRUE(found.information.isZero());
}

/// The information is the second derivative of half the weighted square distances: checked on one step from far off.
TEST(ScanRegistration, HasTheInformationThatDifferencesHave) {
  // One point on one wall: its distance is x + 0.5 - 2 = 0 at the pose 0, and grows as the motion says.
  const SurfaceIndex wall{{{{2.0, 0.5}, {-1.0, 0.0}}}};
  const Surface scan{{{2.0, 0.5}, {-1.0, 0.0}}};
  RegistrationOptions options;
  options.point_weight = 1.0;
  options.deviation_m = 1.0;
  const Eigen::Matrix3d information = registered(wall, scan, {}, options).information;
  const auto distance = [&](const Eigen::Vector3d& motion) {
    const Eigen::Vector2d there = Pose2{motion.x(), motion.y(), motion.z()} * scan[0].point;
    return -(there.x() - 2.0);
  };
  constexpr double kStep = 1e-6;
  Eigen::Vector3d slope;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
    slope[k] = (distance(step) - distance(-step)) / (2.0 * kStep);
  }
  EXPECT_LT((information - slope * slope.transpose()).norm(), 1e-6);
}

}  // namespace
}  // namespace tandem
