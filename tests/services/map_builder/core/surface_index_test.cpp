#include "services/map_builder/core/surface_index.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem {
namespace {

TEST(SurfaceIndex, FindsThePointThatATrialOfAllFinds) {
  Rng rng{4};
  Surface surface;
  for (int i = 0; i < 300; ++i) surface.push_back({{rng.uniform(-5, 5), rng.uniform(-5, 5)}, {1.0, 0.0}});
  const SurfaceIndex index{surface};
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d point{rng.uniform(-6, 6), rng.uniform(-6, 6)};
    double least = 1e9;
    for (const SurfacePoint& p : surface) least = std::min(least, (p.point - point).norm());
    const SurfacePoint* const found = index.nearest(point, 0.5);
    ASSERT_EQ(found != nullptr, least < 0.5) << "sample " << i;
    if (found != nullptr) {
      EXPECT_NEAR((found->point - point).norm(), least, 1e-12);
    }
  }
}

TEST(SurfaceIndex, FindsNothingInNothing) {
  EXPECT_EQ(SurfaceIndex{Surface{}}.nearest({0.0, 0.0}, 100.0), nullptr);
}

TEST(SurfaceIndex, KeepsItsPointsWhenMoved) {
  SurfaceIndex one{{{{1.0, 0.0}, {1.0, 0.0}}}};
  const SurfaceIndex other{std::move(one)};
  ASSERT_NE(other.nearest({1.1, 0.0}, 0.5), nullptr);
  EXPECT_EQ(other.surface().size(), 1U);
}

}  // namespace
}  // namespace tandem
