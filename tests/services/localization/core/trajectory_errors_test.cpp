#include "services/localization/core/trajectory_errors.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

Time at(double seconds) {
  return Time{from_seconds(seconds)};
}

EstimatedPose estimate(double seconds, Pose2 pose, LocalizationStatus status = LocalizationStatus::Ok) {
  return {{at(seconds), pose}, Covariance3::Identity(), status};
}

const std::vector<TimedPose> kStandingStill{{at(0.0), {}}, {at(10.0), {}}};

TEST(TrajectoryErrors, AreThoseOfARightTriangle) {
  const std::vector<EstimatedPose> poses{estimate(1.0, {3.0, 4.0, 0.0}), estimate(2.0, {0.0, 0.0, 0.0})};

  const TrajectoryErrors errors = errors_of(poses, kStandingStill, 0.0, {});

  EXPECT_EQ(errors.compared, 2U);
  EXPECT_DOUBLE_EQ(errors.rmse_m, std::sqrt(25.0 / 2.0));
  EXPECT_DOUBLE_EQ(errors.max_m, 5.0);
  EXPECT_DOUBLE_EQ(errors.lost_share, 0.5);
  EXPECT_DOUBLE_EQ(errors.status_wrong_share, 0.5);  // 5 m off and sure of it
  EXPECT_DOUBLE_EQ(errors.nees, 25.0 / 3.0 / 2.0);
}

TEST(TrajectoryErrors, LeaveExcludedWindowsOutOfTheKeptOne) {
  const std::vector<EstimatedPose> poses{estimate(1.0, {3.0, 4.0, 0.0}), estimate(2.0, {0.5, 0.0, 0.0})};

  EXPECT_DOUBLE_EQ(errors_of(poses, kStandingStill, 0.0, {{0.5, 1.0}}).rmse_kept_m, 0.5);
}

TEST(TrajectoryErrors, TakeTurnsTheShortWay) {
  const std::vector<TimedPose> truth{{at(0.0), {0.0, 0.0, 3.1}}, {at(1.0), {0.0, 0.0, 3.1}}};
  const std::vector<EstimatedPose> poses{estimate(0.5, {0.0, 0.0, -3.1})};

  EXPECT_NEAR(errors_of(poses, truth, 0.0, {}).rmse_deg, to_degrees(2.0 * (std::numbers::pi - 3.1)), 1e-9);
}

TEST(TrajectoryErrors, CountNothingWhereTheReferenceIsSilent) {
  const std::vector<EstimatedPose> poses{estimate(11.0, {3.0, 4.0, 0.0})};

  EXPECT_EQ(errors_of(poses, kStandingStill, 0.0, {}).compared, 0U);
  EXPECT_EQ(errors_of(poses, kStandingStill, -2.0, {}).compared, 1U);
}

TEST(RelationErrors, AreZeroWhateverFrameTheEstimatesAreIn) {
  const Pose2 other{5.0, -1.0, 2.0};
  const std::vector<TimedPose> poses{{at(1.0), other * Pose2{0.0, 0.0, 0.0}}, {at(2.0), other * Pose2{1.0, 0.0, 0.5}}};
  const auto relations = parse_relations("101 102 1 0 0 0 0 0.5\n", "r");

  const RelationErrors errors = relation_errors_of(poses, relations, 100.0);

  EXPECT_EQ(errors.compared, 1U);
  EXPECT_NEAR(errors.mean_m, 0.0, 1e-12);
}

TEST(RelationErrors, AreDistances) {
  const std::vector<TimedPose> poses{{at(1.0), {}}, {at(2.0), {1.3, 0.4, 0.0}}};

  EXPECT_NEAR(relation_errors_of(poses, parse_relations("1 2 1 0 0 0 0 0\n", "r"), 0.0).mean_m, 0.5, 1e-12);
}

TEST(RelationErrors, CountTheTurnToo) {
  const std::vector<TimedPose> way{{Time{}, {}}, {Time{from_seconds(1.0)}, {1.0, 0.0, 0.1}}};
  const std::vector<Relation> relations{{Time{}, Time{from_seconds(1.0)}, {1.0, 0.0, 0.0}},
                                        {Time{}, Time{from_seconds(1.0)}, {1.0, 0.0, 0.3}}};
  const RelationErrors errors = relation_errors_of(way, relations, 0.0);
  EXPECT_NEAR(errors.mean_deg, to_degrees(0.15), 1e-9);  // 0.1 and 0.2 rad off
  EXPECT_NEAR(errors.deviation_deg, to_degrees(0.05), 1e-9);
}

TEST(FormErrors, DoNotCareWhereTheMapBegins) {
  const std::vector<TimedPose> truth{
      {Time{}, {}}, {Time{from_seconds(1.0)}, {4.0, 0.0, 0.0}}, {Time{from_seconds(2.0)}, {4.0, 3.0, 0.0}}};
  const Pose2 map_from_truth{7.0, -2.0, 1.0};
  std::vector<TimedPose> estimate = truth;
  for (TimedPose& pose : estimate) pose.map_from_base = map_from_truth * pose.map_from_base;
  const FormErrors errors = form_errors_of(estimate, truth, 0.0);
  EXPECT_EQ(errors.compared, 3U);
  EXPECT_NEAR(errors.max_m, 0.0, 1e-9);
  EXPECT_NEAR(turn_between(errors.truth_from_map.heading, -1.0), 0.0, 1e-9);
}

TEST(FormErrors, AreHowFarTheFormIsOff) {
  const std::vector<TimedPose> truth{{Time{}, {-1.0, 0.0, 0.0}}, {Time{from_seconds(1.0)}, {1.0, 0.0, 0.0}}};
  const std::vector<TimedPose> estimate{{Time{}, {-1.5, 0.0, 0.0}}, {Time{from_seconds(1.0)}, {1.5, 0.0, 0.0}}};
  EXPECT_NEAR(form_errors_of(estimate, truth, 0.0).rmse_m, 0.5, 1e-9);
  EXPECT_EQ(form_errors_of({}, truth, 0.0).compared, 0U);
}

}  // namespace
}  // namespace tandem
