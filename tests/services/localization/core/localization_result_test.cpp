#include "services/localization/core/localization_result.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Cluster group(double x, double weight) {
  return {.map_from_base = {x, 0.0, 0.0}, .weight = weight};
}

TEST(LocalizationResult, KeepsTheOtherGroupsWhileTheFirstLeavesDoubt) {
  const auto others = other_groups({group(0.0, 0.6), group(5.0, 0.3), group(9.0, 0.1)});

  ASSERT_EQ(others.size(), 2U);
  EXPECT_EQ(others[0].map_from_base.x, 5.0);
  EXPECT_EQ(others[1].weight, 0.1);
  EXPECT_TRUE(other_groups({group(0.0, 0.95), group(5.0, 0.05)}).empty());
  EXPECT_TRUE(other_groups({}).empty());
}

TEST(LocalizationResult, LeavesOutThePlaceWhereTheRobotIs) {
  const Finding finding{.places = {{{0.1, 0.0, 0.0}, 0.7}, {{4.0, 0.0, 0.0}, 0.3}}};

  const auto others = other_places(finding, {0.0, 0.0, 0.1});

  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0].map_from_base.x, 4.0);
}

TEST(LocalizationResult, GivesItsPoseTheWeightThatTheOthersLeave) {
  const OdometrySample odometry{Time{from_seconds(2.0)}, {}, {}, 3};
  const PoseFit fit{{{1.0, 2.0, 0.5}}, 0.8};

  const LocalizationResult result = result_of(odometry, fit, LocalizationStatus::Ok, {{{7.0, 0.0, 0.0}, 0.75}});

  EXPECT_EQ(result.time, odometry.time);
  EXPECT_EQ(result.odometry_epoch, 3);
  EXPECT_EQ(result.agreement, 0.8);
  ASSERT_EQ(result.hypotheses.size(), 2U);
  EXPECT_EQ(result.hypotheses[0].map_from_base.x, 7.0);  // heaviest first
  EXPECT_EQ(result.hypotheses[1].weight, 0.25);          // 1 - 0.75
}

TEST(LocalizationResult, IsNeverOkWhileThereAreOtherPlaces) {
  const auto status_with = [](LocalizationStatus status, const std::vector<PoseHypothesis>& others) {
    return result_of({}, {}, status, others).status;
  };
  const std::vector<PoseHypothesis> one{{{7.0, 0.0, 0.0}, 0.2}};

  EXPECT_EQ(status_with(LocalizationStatus::Ok, {}), LocalizationStatus::Ok);
  EXPECT_EQ(status_with(LocalizationStatus::Ok, one), LocalizationStatus::Uncertain);
  EXPECT_EQ(status_with(LocalizationStatus::Lost, one), LocalizationStatus::Lost);
}

}  // namespace
}  // namespace tandem
