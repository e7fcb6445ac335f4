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
    finder_.seek();
    while (finder_.is_searching()) finder_.advance(100'000);
    return finder_.finding();
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
  EXPECT_TRUE(PlaceFinder::is_same(drive.finder_.finding().places.front().map_from_base, drive.truth_));
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
  EXPECT_TRUE(PlaceFinder::is_same(drive.finder_.finding().places.front().map_from_base, drive.truth_));
}

TEST(PlaceFinder, CarriesWhatItFoundToWhereTheRobotHasDriven) {
  Drive drive{test::uneven_room()};
  (void)drive.step();
  drive.finder_.seek();
  const Pose2 before = drive.finder_.finding().places.front().map_from_base;

  drive.finder_.add({drive.time_, drive.odom_ * Pose2{0.3, 0.0, 0.0}, {}, 0}, {});  // too short a way to search again

  const Pose2 after = drive.finder_.finding().places.front().map_from_base;
  EXPECT_NEAR((inverse(before) * after).x, 0.3, 1e-9);
}

TEST(PlaceFinder, FindsTheSameHoweverItsWorkIsDivided) {
  Drive at_once{test::uneven_room()};
  Drive in_pieces{test::uneven_room()};
  const Finding& expected = at_once.step();

  const LaserScan scan = test::scan_from(in_pieces.map_, at_once.truth_, at_once.time_);
  in_pieces.finder_.add({at_once.time_, at_once.odom_, {}, 0}, selected_endpoints(scan, 90, 25.0, {}));
  in_pieces.finder_.seek();
  int pieces = 0;
  for (; in_pieces.finder_.is_searching(); ++pieces) {
    EXPECT_TRUE(in_pieces.finder_.finding().places.empty());
    in_pieces.finder_.advance(100);
  }
  EXPECT_GT(pieces, 3);
  ASSERT_EQ(in_pieces.finder_.finding().places.size(), expected.places.size());
  for (std::size_t i = 0; i < expected.places.size(); ++i) {
    EXPECT_EQ(in_pieces.finder_.finding().places[i].map_from_base, expected.places[i].map_from_base);
    EXPECT_EQ(in_pieces.finder_.finding().places[i].weight, expected.places[i].weight);
  }
}

TEST(PlaceFinder, ForgetsWhatNobodyAsksForAnyMore) {
  Drive drive{test::uneven_room()};
  ASSERT_FALSE(drive.step().places.empty());
  const std::vector<Eigen::Vector2d> endpoints{{1.0, 0.0}};

  drive.finder_.add({drive.time_, drive.odom_, {}, 0}, endpoints);  // asked for at the scan before: kept
  EXPECT_FALSE(drive.finder_.finding().places.empty());
  drive.finder_.add({drive.time_, drive.odom_, {}, 0}, endpoints);
  EXPECT_TRUE(drive.finder_.finding().places.empty());
}

}  // namespace
}  // namespace tandem
