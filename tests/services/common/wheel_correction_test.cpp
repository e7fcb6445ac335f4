#include "services/common/wheel_correction.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "services/common/random.hpp"

namespace tandem {
namespace {

TEST(WheelCorrection, LeavesRightWheelsAlone) {
  Rng rng{1};
  for (int i = 0; i < 1000; ++i) {
    const Pose2 motion{rng.uniform(-1.0, 1.0), rng.uniform(-0.1, 0.1), rng.uniform(-3.0, 3.0)};
    const Pose2 same = corrected(motion, 0.2, {});
    EXPECT_NEAR(same.x, motion.x, 1e-9);
    EXPECT_NEAR(same.y, motion.y, 1e-9);
    EXPECT_NEAR(same.heading, motion.heading, 1e-9);
  }
}

TEST(WheelCorrection, MakesAnArcOfAHalfTurn) {
  const Arc<double> end = chord_of(Arc<double>{std::numbers::pi, 0.0, std::numbers::pi});  // half a circle of radius 1
  EXPECT_NEAR(end.forward_m, 0.0, 1e-12);
  EXPECT_NEAR(end.left_m, 2.0, 1e-12);
}

TEST(WheelCorrection, TurnsLessOnAWiderTrack) {
  EXPECT_NEAR(corrected(Pose2{0.0, 0.0, 1.0}, 0.2, {.track_scale = 1.25}).heading, 0.8, 1e-12);
}

TEST(WheelCorrection, BendsTheWayOfUnequalWheels) {
  // The left wheel goes 1.1 m where it says 1 m; 0.4 m of track: it turns to the right by 0.1 / 0.4.
  const Arc<double> arc = corrected<double>({1.0, 0.0, 0.0}, 0.2, 1.1, 1.0, 1.0);
  EXPECT_NEAR(arc.forward_m, 1.05, 1e-12);
  EXPECT_NEAR(arc.turn_rad, -0.25, 1e-12);
}

}  // namespace
}  // namespace tandem
