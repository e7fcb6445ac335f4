#include "calibration/core/motion_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/calibration/simulated_recording.hpp"

namespace tandem {
namespace {

const auto kGoOn = [](double) { return true; };

TEST(MotionPairs, SayHowTheRecordedBaseMovedWhateverTheWheelsSay) {
  const auto recording = bench::simulated_recording(1, {.duration_s = 60.0});
  const auto pairs = motion_pairs(recording.drive, {}, kGoOn);
  ASSERT_GT(pairs.size(), 30u);
  const Pose2 laser_from_recorded = inverse(recording.start.base_from_laser);
  const auto true_at = [&](Time stamp) {
    const auto found = std::find_if(recording.world_from_laser.begin(), recording.world_from_laser.end(),
                                    [&](const auto& one) { return one.first == stamp; });
    return found->second * laser_from_recorded;
  };
  for (const MotionPair& pair : pairs) {
    const Pose2 off = inverse(inverse(true_at(pair.from)) * true_at(pair.to)) * pair.motion;
    EXPECT_LT(off.position().norm(), 0.015);
    EXPECT_LT(std::abs(off.heading), 0.005);
  }
}

TEST(MotionPairs, BeginWhereTheOneBeforeEnded) {
  const auto recording = bench::simulated_recording(2, {.duration_s = 30.0});
  const auto pairs = motion_pairs(recording.drive, {}, kGoOn);
  std::size_t chained = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i) chained += pairs[i].from == pairs[i - 1].to ? 1 : 0;
  EXPECT_GE(chained + 2, pairs.size() - 1);
}

TEST(MotionPairs, EndWhenTold) {
  const auto recording = bench::simulated_recording(2, {.duration_s = 30.0});
  EXPECT_TRUE(motion_pairs(recording.drive, {}, [](double) { return false; }).empty());
}

}  // namespace
}  // namespace tandem
