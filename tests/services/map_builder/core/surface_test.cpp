#include "services/map_builder/core/surface.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace tandem {
namespace {

/// A wall 2 m ahead, from right to left, a point each 0.1 m.
std::vector<Eigen::Vector2d> wall_ahead() {
  std::vector<Eigen::Vector2d> points;
  for (int i = -10; i <= 10; ++i) points.emplace_back(2.0, 0.1 * i);
  return points;
}

TEST(Surface, FacesTheLaser) {
  for (const SurfacePoint& p : surface_of(wall_ahead(), Eigen::Vector2d::Zero(), 100)) {
    EXPECT_NEAR(p.normal.x(), -1.0, 1e-9);
  }
  for (const SurfacePoint& p : surface_of(wall_ahead(), {5.0, 0.0}, 100)) EXPECT_NEAR(p.normal.x(), 1.0, 1e-9);
}

TEST(Surface, KeepsAtMostWhatIsAskedFor) {
  EXPECT_EQ(surface_of(wall_ahead(), Eigen::Vector2d::Zero(), 7).size(), 7U);
  EXPECT_TRUE(surface_of({}, Eigen::Vector2d::Zero(), 7).empty());
}

TEST(Surface, TurnsWithItsFrame) {
  const Surface surface{{{1.0, 0.0}, {-1.0, 0.0}}};
  const Surface turned = Pose2{0.0, 3.0, std::numbers::pi / 2.0} * surface;
  EXPECT_NEAR((turned[0].point - Eigen::Vector2d{0.0, 4.0}).norm(), 0.0, 1e-12);
  EXPECT_NEAR((turned[0].normal - Eigen::Vector2d{0.0, -1.0}).norm(), 0.0, 1e-12);
}

TEST(SurfaceUnion, KeepsTheFirstPointOfEachSquare) {
  SurfaceUnion all{0.1};
  all.add({}, {{{0.0, 0.0}, {1.0, 0.0}}, {{1.0, 0.0}, {1.0, 0.0}}});
  all.add({0.01, 0.0, 0.0}, {{{0.0, 0.0}, {0.0, 1.0}}, {{5.0, 0.0}, {0.0, 1.0}}});
  const Surface kept = all.take();
  ASSERT_EQ(kept.size(), 3U);
  EXPECT_EQ(kept[0].normal.x(), 1.0);  // the first came first
  EXPECT_NEAR(kept[2].point.x(), 5.01, 1e-12);
}

TEST(SurfaceUnion, HoldsAsManyAsComeAndStartsAnewWhenTaken) {
  SurfaceUnion all{0.5};
  Surface many;
  for (int i = 0; i < 5000; ++i) many.push_back({{1.0 * i, -2.0 * i}, {1.0, 0.0}});
  all.add({}, many);
  EXPECT_EQ(all.take().size(), 5000U);
  all.add({}, {many.front()});
  EXPECT_EQ(all.take().size(), 1U);
}

}  // namespace
}  // namespace tandem
