#include "services/localization/core/place_finder.hpp"

#include <gtest/gtest.h>

#include "services/localization/core/beams.hpp"
#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// A robot that drives a circle and asks after each step where it may be.
class Drive {
 public:
  explicit Drive(OccupancyGrid map)
      : map_(std::move(map)), field_(map_, DistanceField{map_, 2.0}, {}), finder_(map_, field_, {}) {}

  const Finding& step(const Pose2& motion = {0.2, 0.0, 0.15}) {
    time_ += from_seconds(0.5);
    truth_ = truth_ * motion;
    odom_ = odom_ * motion;
    finder_.add({time_, odom_, {}, epoch_}, selected_endpoints(test::scan_from(map_, truth_, time_), 90, 25.0, {}));
    return finder_.find();
  }

  OccupancyGrid map_;
  LikelihoodField field_;
  PlaceFinder finder_;
  Time time_{};
  int epoch_ = 0;
  Pose2 truth_{2.5, 1.2, 0.0};
  Pose2 odom_{7.0, 7.0, 2.0};
};

OccupancyGrid plain_room() {
  return test::ascii_map({"##########", "#........#", "#........#", "#........#", "#........#", "##########"}, 0.5);
}

TEST(PlaceFinder, IsCertainOnlyAfterSomeWay) {
  Drive drive{test::uneven_room()};

  EXPECT_FALSE(drive.step().certain);
  bool certain = false;
  for (int i = 0; i < 10 && !certain; ++i) certain = drive.step().certain;
  ASSERT_TRUE(certain);
  EXPECT_TRUE(PlaceFinder::is_same(drive.finder_.last_finding().places.front().map_from_base, drive.truth_));
}

TEST(PlaceFinder, NeverChoosesBetweenTwoPlacesThatLookAlike) {
  Drive drive{plain_room()};
  drive.truth_ = {1.5, 1.0, 0.3};
  for (int i = 0; i < 15; ++i) {
    const Finding& finding = drive.step();
    ASSERT_GE(finding.places.size(), 2U);
    EXPECT_FALSE(finding.certain) << "step " << i;
  }
}

TEST(PlaceFinder, GivesWeightsThatAddUpToOne) {
  Drive drive{plain_room()};
  drive.truth_ = {1.5, 1.0, 0.3};
  double sum = 0.0;
  for (const PoseHypothesis& place : drive.step().places) sum += place.weight;

  EXPECT_NEAR(sum, 1.0, 1e-9);
}

TEST(PlaceFinder, ScoresThePlaceItFoundAsItFoundIt) {
  Drive drive{test::uneven_room()};
  const Finding& finding = drive.step();

  EXPECT_NEAR(drive.finder_.score_at(finding.places.front().map_from_base), finding.score, 0.05);
  EXPECT_LT(drive.finder_.score_at({3.0, 2.0, 2.5}), finding.score - 0.1);
}

TEST(PlaceFinder, BeginsAnewWhenTheRobotWasCarried) {
  Drive drive{test::uneven_room()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  drive.finder_.forget();
  drive.truth_ = {2.0, 2.5, -1.0};

  EXPECT_FALSE(drive.step().certain);
  bool certain = false;
  for (int i = 0; i < 10 && !certain; ++i) certain = drive.step().certain;
  ASSERT_TRUE(certain);
  EXPECT_TRUE(PlaceFinder::is_same(drive.finder_.last_finding().places.front().map_from_base, drive.truth_));
}

}  // namespace
}  // namespace tandem
