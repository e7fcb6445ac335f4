#include "services/localization/core/panorama.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace tandem {
namespace {

using Points = std::vector<Eigen::Vector2d>;

OdometrySample at(double x, double heading = 0.0, int epoch = 0) {
  return {Time{}, {x, 0.0, heading}, {}, epoch};
}

bool holds(const Points& points, const Eigen::Vector2d& wanted) {
  return std::any_of(points.begin(), points.end(), [&](const auto& point) { return (point - wanted).norm() < 1e-9; });
}

TEST(Panorama, HoldsWhatWasSeenFromWhereTheRobotIsNow) {
  Panorama panorama{{.way_m = 5.0}};
  panorama.add(at(0.0), Points{{3.0, 1.0}});
  panorama.add(at(1.0, std::numbers::pi / 2.0), Points{{0.0, 2.0}});

  const Points points = panorama.endpoints_in_base(0.1);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_TRUE(holds(points, {0.0, 2.0}));
  EXPECT_TRUE(holds(points, {1.0, -2.0}));  // 2 m ahead and 1 m to the left of (1, 0), seen turned to the left
  EXPECT_DOUBLE_EQ(panorama.way_m(), 1.0);
}

TEST(Panorama, KeepsOnePointOfASquare) {
  Panorama panorama{{.way_m = 5.0}};
  panorama.add(at(0.0), Points{{1.0, 1.0}, {1.01, 1.0}, {2.0, 1.0}});

  EXPECT_EQ(panorama.endpoints_in_base(0.2).size(), 2U);
}

TEST(Panorama, ForgetsWhatLiesFarBack) {
  Panorama panorama{{.way_m = 2.0}};
  panorama.add(at(0.0), Points{{9.0, 0.0}});
  panorama.add(at(1.0), Points{{1.0, 0.0}});
  panorama.add(at(2.5), Points{{2.0, 0.0}});

  const Points points = panorama.endpoints_in_base(0.1);
  EXPECT_EQ(points.size(), 2U);
  EXPECT_FALSE(holds(points, {6.5, 0.0}));
}

TEST(Panorama, DoesNotPileUpScansOfARobotThatStands) {
  Panorama panorama{{.way_m = 2.0}};
  for (int i = 0; i < 100; ++i) panorama.add(at(0.0), Points{{1.0 + 0.05 * i, 0.0}});

  EXPECT_LE(panorama.endpoints_in_base(0.01).size(), 2U);
}

TEST(Panorama, ForgetsAllAcrossABreakOfTheOdometry) {
  Panorama panorama{{.way_m = 2.0}};
  panorama.add(at(0.0), Points{{1.0, 0.0}});
  panorama.add(at(0.5, 0.0, 1), Points{{2.0, 0.0}});

  EXPECT_EQ(panorama.endpoints_in_base(0.1).size(), 1U);
}

}  // namespace
}  // namespace tandem
