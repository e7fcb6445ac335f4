#include "calibration/core/joint_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/calibration/simulated_recording.hpp"
#include "calibration/core/observability.hpp"

namespace tandem {
namespace {

std::vector<MotionPair> pairs_of(const bench::SimulatedRecording& recording) {
  return motion_pairs(recording.drive, {}, [](double) { return true; });
}

// A hundred seeds: `./run bench calibration`.
TEST(JointCalibration, FindsWheelsLaserAndClock) {
  double nees = 0.0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const auto recording = bench::simulated_recording(seed, {});
    const auto errors =
        bench::errors_of(calibrated(recording.drive.odometry, pairs_of(recording), recording.start), recording);
    EXPECT_LT(errors.wheels_share, 0.002) << "seed " << seed;
    EXPECT_LT(errors.laser_m, 0.003) << "seed " << seed;
    EXPECT_LT(errors.laser_deg, 0.1) << "seed " << seed;
    EXPECT_LT(errors.clock_s, 0.005) << "seed " << seed;
    nees += errors.nees / 6.0;
  }
  EXPECT_GT(nees, 0.4);
  EXPECT_LT(nees, 2.0);
}

TEST(JointCalibration, ForgivesSlippingWheels) {
  const auto recording = bench::simulated_recording(11, {.slip_share = 0.5});
  const auto found = calibrated(recording.drive.odometry, pairs_of(recording), recording.start);
  EXPECT_LT(bench::errors_of(found, recording).wheels_share, 0.004);
  EXPECT_GT(std::count_if(found.residuals.begin(), found.residuals.end(),
                          [](const PairResidual& one) { return one.weight < 0.1; }),
            4);
}

TEST(JointCalibration, MakesWheelsAndScansAgree) {
  const auto recording = bench::simulated_recording(5, {});
  const auto found = calibrated(recording.drive.odometry, pairs_of(recording), recording.start);
  double before = 0.0;
  double after = 0.0;
  for (const PairResidual& one : found.residuals) {
    before += one.weight * one.before.squaredNorm();
    after += one.weight * one.after.squaredNorm();
  }
  EXPECT_LT(after, 0.1 * before);
}

TEST(JointCalibration, HoldsWheelsThatAreRight) {
  const auto recording = bench::simulated_recording(3, {});
  CalibrationStart start = recording.start;
  start.hold_wheels = true;
  const auto found = calibrated(recording.drive.odometry, pairs_of(recording), start);
  EXPECT_EQ(found.wheels, WheelCorrection{});
  EXPECT_EQ(found.deviation(CalibrationParameter::Track), 0.0);
  EXPECT_GT(found.deviation(CalibrationParameter::LaserX), 0.0);
}

TEST(JointCalibration, IsRefusedWhereTheRobotOnlyTurned) {
  const auto recording = bench::simulated_recording(4, {.duration_s = 120.0, .drives = false});
  const auto missing = missing_motion(driven_motion(pairs_of(recording)), {}, false);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_NE(missing[0].find("drive straight at least 5 m"), std::string::npos);
}

TEST(JointCalibration, IsRefusedWhereItTurnedOneWay) {
  const auto recording = bench::simulated_recording(4, {.duration_s = 120.0, .drives = false, .turns_right = false});
  const auto missing = missing_motion(driven_motion(pairs_of(recording)), {}, false);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_NE(missing[1].find("turn both ways: to the right"), std::string::npos);
}

}  // namespace
}  // namespace tandem
