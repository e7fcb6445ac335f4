#include "services/common/angle.hpp"

#include <gtest/gtest.h>

#include "services/common/random.hpp"

namespace tandem {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Angle, WrapsIntoTheHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(wrap_to_pi(0.0), 0.0);
  EXPECT_DOUBLE_EQ(wrap_to_pi(kPi), -kPi);  // +pi is outside, -pi inside
  EXPECT_DOUBLE_EQ(wrap_to_pi(-kPi), -kPi);
  EXPECT_NEAR(wrap_to_pi(1.5 * kPi), -0.5 * kPi, 1e-12);
  EXPECT_NEAR(wrap_to_pi(-2.25 * kPi), -0.25 * kPi, 1e-12);
}

TEST(Angle, WrappingChangesOnlyWholeTurnsAndLandsInside) {
  Rng rng{11};
  for (int i = 0; i < 10'000; ++i) {
    const double angle = rng.uniform(-1000.0, 1000.0);
    const double wrapped = wrap_to_pi(angle);
    ASSERT_GE(wrapped, -kPi) << angle;
    ASSERT_LT(wrapped, kPi) << angle;
    const double turns = (angle - wrapped) / (2.0 * kPi);
    ASSERT_NEAR(turns, std::round(turns), 1e-9) << angle;
  }
}

TEST(Angle, TurnsTheShortWayAcrossTheCut) {
  EXPECT_NEAR(turn_between(from_degrees(170), from_degrees(-170)), from_degrees(20), 1e-12);
  EXPECT_NEAR(turn_between(from_degrees(-170), from_degrees(170)), from_degrees(-20), 1e-12);
}

TEST(Angle, DegreesAndRadiansUndoEachOther) {
  EXPECT_DOUBLE_EQ(from_degrees(180.0), kPi);
  EXPECT_DOUBLE_EQ(to_degrees(kPi / 2.0), 90.0);
}

}  // namespace
}  // namespace tandem
