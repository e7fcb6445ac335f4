#include "services/cli/kidnapping.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

const Time kPutDown{from_seconds(100.0)};

EstimatedPose estimate(double since_s, double x, LocalizationStatus status) {
  return {{kPutDown + from_seconds(since_s), {x, 0.0, 0.0}}, Covariance3::Zero(), status};
}

/// The robot stands at x = 10.
const std::vector<TimedPose> kTruth{{kPutDown, {10.0, 0.0, 0.0}}, {kPutDown + from_seconds(60.0), {10.0, 0.0, 0.0}}};

TEST(Recovery, IsWhenThePoseIsOkAndRight) {
  const std::vector<EstimatedPose> poses{
      estimate(1.0, 3.0, LocalizationStatus::Ok), estimate(2.0, 3.0, LocalizationStatus::Uncertain),
      estimate(3.0, 10.4, LocalizationStatus::Uncertain), estimate(4.0, 10.4, LocalizationStatus::Ok)};
  const std::vector<double> way_m{0.5, 1.0, 1.5, 2.0};

  const Recovery recovery = recovery_of(poses, way_m, kPutDown, kTruth, 0.0);

  EXPECT_EQ(recovery.flagged_s, 2.0);
  EXPECT_EQ(recovery.recovered_s, 4.0);
  EXPECT_EQ(recovery.recovered_m, 2.0);
  EXPECT_EQ(recovery.ok_but_wrong, 1U);  // 7 m off, in the first second
}

TEST(Recovery, MayNeverCome) {
  const Recovery recovery =
      recovery_of(std::vector{estimate(1.0, 3.0, LocalizationStatus::Lost)}, std::vector{0.5}, kPutDown, kTruth, 0.0);

  EXPECT_EQ(recovery.flagged_s, 1.0);
  EXPECT_FALSE(recovery.recovered_s);
}

TEST(Recovery, WithoutTruthIsToBeOkAgain) {
  const std::vector<EstimatedPose> poses{estimate(1.0, 3.0, LocalizationStatus::Ok),
                                         estimate(2.0, 3.0, LocalizationStatus::Lost),
                                         estimate(3.0, 7.0, LocalizationStatus::Ok)};
  const Recovery recovery = recovery_of(poses, std::vector{0.5, 1.0, 1.5}, kPutDown, {}, 0.0);

  EXPECT_EQ(recovery.recovered_s, 3.0);
  EXPECT_EQ(recovery.recovered_m, 1.5);
}

}  // namespace
}  // namespace tandem::cli
