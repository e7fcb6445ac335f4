#include "services/localization/core/motion_model.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(MotionModel, DeviationsGrowWithTheMotion) {
  const MotionNoise noise{.forward_per_m = 0.1, .sideways_per_m = 0.05, .turn_per_rad = 0.2};

  const MotionDeviation ahead = deviation_of({2.0, 0.0, 0.0}, noise);
  EXPECT_DOUBLE_EQ(ahead.forward_m, 0.2);
  EXPECT_DOUBLE_EQ(ahead.sideways_m, 0.1);
  EXPECT_DOUBLE_EQ(ahead.turn_rad, 0.0);
  EXPECT_DOUBLE_EQ(deviation_of({0.0, 0.0, -0.5}, noise).turn_rad, 0.1);
}

TEST(MotionModel, IndependentPartsAddAsSquares) {
  const MotionNoise noise{.forward_per_m = 0.3, .turn_per_m = 0.3, .drift_m = 0.4, .drift_rad = 0.4};
  const MotionDeviation deviation = deviation_of({0.6, 0.8, 0.0}, noise);  // 1 m

  EXPECT_DOUBLE_EQ(deviation.forward_m, 0.5);  // 3-4-5
  EXPECT_DOUBLE_EQ(deviation.turn_rad, 0.5);
}

TEST(MotionModel, TwiceTheNoiseIsTwiceTheDeviation) {
  const MotionNoise noise{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const Pose2 motion{1.0, 0.0, 0.7};
  const auto once = deviation_of(motion, noise);
  const auto twice = deviation_of(motion, noise.times(2.0));

  EXPECT_DOUBLE_EQ(twice.forward_m, 2.0 * once.forward_m);
  EXPECT_DOUBLE_EQ(twice.sideways_m, 2.0 * once.sideways_m);
  EXPECT_DOUBLE_EQ(twice.turn_rad, 2.0 * once.turn_rad);
}

TEST(MotionModel, SamplesScatterAroundTheMotionAsTheirDeviationSays) {
  Rng rng{17};
  constexpr int kSamples = 20'000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double x = sampled_motion({1.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, rng).x;
    sum += x;
    squares += (x - 1.0) * (x - 1.0);
  }
  EXPECT_NEAR(sum / kSamples, 1.0, 0.004);  // more than five standard errors
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.1, 0.003);
}

}  // namespace
}  // namespace tandem
