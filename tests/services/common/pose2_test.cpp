#include "services/common/pose2.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;

TEST(Pose2, ComposesSoThatInnerNamesCancel) {
  const Pose2 map_from_base{1.0, 2.0, kQuarterTurn};
  const Pose2 base_from_laser{0.5, 0.0, 0.0};

  const Pose2 map_from_laser = map_from_base * base_from_laser;

  EXPECT_NEAR(map_from_laser.x, 1.0, 1e-12);  // half a metre ahead is half a metre up
  EXPECT_NEAR(map_from_laser.y, 2.5, 1e-12);
  EXPECT_NEAR(map_from_laser.heading, kQuarterTurn, 1e-12);
}

TEST(Pose2, InverseUndoesAnyPose) {
  Rng rng{7};
  for (int i = 0; i < 1000; ++i) {
    const Pose2 pose{rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-4, 4)};
    const Pose2 identity = pose * inverse(pose);
    EXPECT_NEAR(identity.x, 0.0, 1e-12);
    EXPECT_NEAR(identity.y, 0.0, 1e-12);
    EXPECT_NEAR(identity.heading, 0.0, 1e-12);
  }
}

TEST(Pose2, InterpolatesAcrossTheCutOfTheCircleTheShortWay) {
  const Pose2 middle = interpolate({0.0, 0.0, 3.0}, {2.0, 0.0, -3.0}, 0.5);

  EXPECT_DOUBLE_EQ(middle.x, 1.0);
  EXPECT_NEAR(std::abs(middle.heading), std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace tandem
