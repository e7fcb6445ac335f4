#include "calibration/core/wheel_noise.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(WheelNoise, IsTwiceWhatTheResidualsShow) {
  // 1 m straight, off by 0.06745: a robust deviation of 0.1, twice that is said.
  const std::vector<PairResidual> residuals(10, {.way_m = 1.0, .turn_rad = 0.0, .after = {0.06745, -0.06745, 0.0}});
  const MotionNoise noise = wheel_noise(residuals);
  EXPECT_NEAR(noise.forward_per_m, 0.2, 1e-9);
  EXPECT_NEAR(noise.sideways_per_m, 0.2, 1e-9);
  EXPECT_NEAR(noise.turn_per_m, 0.02, 1e-9);                        // never less
  EXPECT_EQ(noise.turn_per_rad, kUncalibratedWheels.turn_per_rad);  // it never turned on the spot
}

}  // namespace
}  // namespace tandem
