#include "services/localization/core/localizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/services/localization/room.hpp"

namespace tandem {
namespace {

/// A robot that drives a circle of 1 m in the uneven room, 0.05 m a step, with odometry that slips.
class Drive {
 public:
  explicit Drive(const LocalizationConfig& config) : Drive(config, test::uneven_room()) {}
  Drive(const LocalizationConfig& config, const OccupancyGrid& known_map)
      : map_(test::uneven_room()), localizer_(known_map, config) {}

  std::optional<LocalizationResult> step(double wheels_factor = 1.0) {
    const Pose2 motion{0.05, 0.0, 0.05};
    map_from_base_ = map_from_base_ * motion;
    odom_from_base_ = odom_from_base_ * Pose2{wheels_factor * motion.x, 0.0, wheels_factor * motion.heading};
    return look();
  }
  /// Odometry and a scan where the robot is now.
  std::optional<LocalizationResult> look() {
    time_ += from_seconds(0.1);
    localizer_.add_odometry({time_, odom_from_base_, {}, epoch_});
    LaserScan scan = test::scan_from(map_, map_from_base_, time_);
    if (mirrored_) std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
    return localizer_.add_scan(scan);
  }
  [[nodiscard]] double error_m(const LocalizationResult& result) const {
    return (result.map_from_base.position() - map_from_base_.position()).norm();
  }

  OccupancyGrid map_;
  Localizer localizer_;
  Pose2 map_from_base_{2.5, 1.2, 0.0};
  Pose2 odom_from_base_{};
  Time time_{};
  int epoch_ = 0;
  bool mirrored_ = false;
};

LocalizationConfig started() {
  LocalizationConfig config;
  config.start = {2.5, 1.2, 0.0};
  return config;
}

TEST(Localizer, FollowsARobotWhoseWheelsSlip) {
  Drive drive{started()};
  for (int i = 0; i < 120; ++i) {
    const auto result = drive.step(1.1);
    ASSERT_TRUE(result);
    ASSERT_LT(drive.error_m(*result), 0.1) << "step " << i;
    EXPECT_EQ(result->status, LocalizationStatus::Ok);
    EXPECT_GT(result->agreement, 0.9);
  }
}

TEST(Localizer, GivesTheSamePosesForTheSameInputs) {
  Drive one{started()};
  Drive other{started()};
  for (int i = 0; i < 30; ++i) {
    const auto a = one.step();
    const auto b = other.step();
    ASSERT_EQ(a->map_from_base, b->map_from_base);
    ASSERT_EQ(a->covariance, b->covariance);
  }
}

TEST(Localizer, TurnsWithTheWorld) {
  const Pose2 turn{4.0, -7.0, 1.0};
  Drive straight{started()};
  LocalizationConfig config;
  const Pose2 start = turn * Pose2{2.5, 1.2, 0.0};
  config.start = {start.x, start.y, start.heading};
  OccupancyGrid map{straight.map_.width(), straight.map_.height(), straight.map_.resolution_m(), turn};
  std::copy(straight.map_.cells().begin(), straight.map_.cells().end(), map.cells().begin());
  Localizer turned{map, config};
  for (int i = 0; i < 40; ++i) {
    const auto a = straight.step(1.1);
    turned.add_odometry({straight.time_, straight.odom_from_base_, {}, 0});
    const auto b = turned.add_scan(test::scan_from(straight.map_, straight.map_from_base_, straight.time_));
    const Pose2 expected = turn * a->map_from_base;
    ASSERT_LT((b->map_from_base.position() - expected.position()).norm(), 0.01) << "step " << i;
    ASSERT_LT(std::abs(turn_between(b->map_from_base.heading, expected.heading)), 0.005) << "step " << i;
  }
}

TEST(Localizer, SaysNothingBeforeItKnowsWhereItStarted) {
  Drive drive{LocalizationConfig{}};

  EXPECT_FALSE(drive.step().has_value());
  EXPECT_FALSE(drive.localizer_.is_started());
}

TEST(Localizer, StartsFromAHint) {
  Drive drive{LocalizationConfig{}};
  (void)drive.look();

  drive.localizer_.add_hint({drive.time_, {2.8, 1.0, 0.1}, true, 0.3});

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 10; ++i) result = drive.step();
  ASSERT_TRUE(result);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, StartsFromAHintWithoutHeading) {
  Drive drive{LocalizationConfig{}};
  (void)drive.look();

  drive.localizer_.add_hint({drive.time_, {2.5, 1.2, 2.0}, false, 0.2});

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 20; ++i) result = drive.step();
  ASSERT_TRUE(result);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, CatchesWheelsThatMissedAJump) {
  Drive drive{started()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  drive.map_from_base_ = drive.map_from_base_ * Pose2{0.7, 0.2, 0.1};  // the odometry says nothing of it

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 5; ++i) result = drive.step();
  ASSERT_TRUE(result);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, GoesOnAcrossAResetOfTheOdometry) {
  Drive drive{started()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  drive.odom_from_base_ = {100.0, 50.0, 2.0};
  drive.epoch_ = 1;

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 10; ++i) result = drive.step();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->odometry_epoch, 1);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, SaysThatItIsLostWhenScansDoNotFit) {
  Drive drive{started()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  LocalizationResult result;
  for (int i = 0; i < 25; ++i) {  // 2.5 s in a place that is nowhere on the map
    drive.time_ += from_seconds(0.1);
    drive.localizer_.add_odometry({drive.time_, drive.odom_from_base_, {}, 0});
    LaserScan scan = test::scan_from(drive.map_, drive.map_from_base_, drive.time_);
    for (std::size_t k = 0; k < scan.ranges_m.size(); ++k) scan.ranges_m[k] = k % 2 == 0 ? 0.5F : 9.0F;
    result = drive.localizer_.add_scan(scan).value();
  }
  EXPECT_EQ(result.status, LocalizationStatus::Lost);
}

TEST(Localizer, FindsItselfAnywhereAndSaysWhenItIsSure) {
  LocalizationConfig config;
  config.start_globally = true;
  Drive drive{config};

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 5 && !result; ++i) result = drive.step();  // the search takes more than one scan
  ASSERT_TRUE(result);
  EXPECT_EQ(result->status, LocalizationStatus::Uncertain);
  for (int i = 0; i < 40; ++i) {
    result = drive.step();
    ASSERT_TRUE(result);
    const bool ok = result->status == LocalizationStatus::Ok;
    ASSERT_TRUE(!ok || drive.error_m(*result) < 0.3) << "step " << i;
  }
  EXPECT_EQ(result->status, LocalizationStatus::Ok);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, FindsItselfAgainAfterItWasCarriedAway) {
  Drive drive{started()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  drive.map_from_base_ = {2.0, 2.6, 2.8};  // the wheels stood still

  EXPECT_NE(drive.step()->status, LocalizationStatus::Ok);
  std::optional<LocalizationResult> result;
  for (int i = 0; i < 126; ++i) result = drive.step();  // once round the circle
  EXPECT_EQ(result->status, LocalizationStatus::Ok);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, UsesOddScansAloneWhereAsked) {
  LocalizationConfig config = started();
  config.scans = "odd";
  Drive drive{config};

  EXPECT_FALSE(drive.step().has_value());
  EXPECT_TRUE(drive.step().has_value());
  EXPECT_FALSE(drive.step().has_value());
}

TEST(Localizer, LeavesOutAScanWithoutOdometryOrReturns) {
  Drive drive{started()};
  (void)drive.step();

  EXPECT_FALSE(
      drive.localizer_.add_scan(test::scan_from(drive.map_, drive.map_from_base_, drive.time_ + from_seconds(0.5))));
  LaserScan blind = test::scan_from(drive.map_, drive.map_from_base_, drive.time_);
  blind.ranges_m.assign(blind.ranges_m.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(drive.localizer_.add_scan(blind));
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::ScanWithoutOdometry), 1U);
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::ScanWithTooFewReturns), 1U);
}

TEST(Localizer, LeavesOutAScanThatComesTooLate) {
  Drive drive{started()};
  (void)drive.step();
  const LaserScan late = test::scan_from(drive.map_, drive.map_from_base_, drive.time_);
  const auto before = drive.step();

  EXPECT_FALSE(drive.localizer_.add_scan(late));
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::ScanOutOfOrder), 1U);
  EXPECT_LT((drive.look()->map_from_base.position() - before->map_from_base.position()).norm(), 0.01);
}

TEST(Localizer, GivesNoPoseForALaserThatIsStuck) {
  Drive drive{started()};
  (void)drive.step();
  LaserScan stuck = test::scan_from(drive.map_, drive.map_from_base_, drive.time_);
  std::optional<LocalizationResult> result;
  for (int i = 0; i < 12; ++i) {  // 0.6 m
    drive.time_ += from_seconds(0.1);
    drive.odom_from_base_ = drive.odom_from_base_ * Pose2{0.05, 0.0, 0.0};
    drive.localizer_.add_odometry({drive.time_, drive.odom_from_base_, {}, 0});
    stuck.time = drive.time_;
    result = drive.localizer_.add_scan(stuck);
  }
  EXPECT_FALSE(result);
  EXPECT_GT(drive.localizer_.faults().count(InputFault::ScanStuck), 0U);
}

TEST(Localizer, TakesAJumpOfTheOdometryAsNoMotion) {
  Drive drive{started()};
  for (int i = 0; i < 10; ++i) (void)drive.step();

  drive.odom_from_base_ = {-30.0, 12.0, 1.0};  // without a new epoch

  const auto result = drive.step();
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::OdometryJump), 1U);
  EXPECT_LT(drive.error_m(*result), 0.15);
}

TEST(Localizer, IsNotSureOfAMirroredLaser) {
  Drive drive{started()};
  int ok = 0;
  for (int i = 0; i < 60; ++i) {
    const Pose2 motion{0.05, 0.0, 0.05};
    drive.map_from_base_ = drive.map_from_base_ * motion;
    drive.odom_from_base_ = drive.odom_from_base_ * motion;
    drive.time_ += from_seconds(0.1);
    drive.localizer_.add_odometry({drive.time_, drive.odom_from_base_, {}, 0});
    LaserScan scan = test::scan_from(drive.map_, drive.map_from_base_, drive.time_);
    std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
    const auto result = drive.localizer_.add_scan(scan);
    const bool wrong = result && drive.error_m(*result) > 0.5;
    if (wrong && result->status == LocalizationStatus::Ok) ++ok;
  }
  EXPECT_EQ(ok, 0);
}

TEST(Localizer, RestsWithTheRobot) {
  Drive drive{started()};
  (void)drive.step();
  const auto first = drive.look();
  const auto last = drive.look();

  EXPECT_EQ(first->map_from_base, last->map_from_base);
  EXPECT_LT(first->time, last->time);
}

TEST(Localizer, NamesAMirroredLaserAndIsNeverOkWithIt) {
  Drive drive{started()};
  drive.mirrored_ = true;
  for (int i = 0; i < 250; ++i) {
    const auto result = drive.step();
    ASSERT_TRUE(!result || i < 5 || result->status != LocalizationStatus::Ok || drive.error_m(*result) < 0.5)
        << "step " << i;
  }
  EXPECT_EQ(drive.localizer_.setup_fault(), InputFault::LaserMirrored);
  EXPECT_GT(drive.localizer_.faults().count(InputFault::LaserMirrored), 0U);
}

TEST(Localizer, NamesAMapOfTwiceTheScale) {
  const OccupancyGrid room = test::uneven_room();
  OccupancyGrid map{room.width(), room.height(), 2.0 * room.resolution_m(), room.map_from_grid()};
  std::copy(room.cells().begin(), room.cells().end(), map.cells().begin());
  LocalizationConfig config;
  config.start = {5.0, 2.4, 0.0};
  Drive drive{config, map};
  for (int i = 0; i < 400 && !drive.localizer_.setup_fault(); ++i) (void)drive.step();
  EXPECT_EQ(drive.localizer_.setup_fault(), InputFault::MapScaleWrong);
  EXPECT_NEAR(drive.localizer_.map_scale(), 2.0, 0.1);
}

TEST(Localizer, GoesOnByOdometryBetweenScans) {
  Drive drive{started()};
  const auto at_scan = drive.step();
  ASSERT_TRUE(at_scan);

  drive.localizer_.add_odometry(
      {drive.time_ + from_seconds(0.05), drive.odom_from_base_ * Pose2{0.02, 0.0, 0.0}, {}, 0});

  const auto now = drive.localizer_.predicted_now();
  ASSERT_TRUE(now);
  EXPECT_EQ(now->time, at_scan->time + from_seconds(0.05));
  EXPECT_NEAR((inverse(at_scan->map_from_base) * now->map_from_base).x, 0.02, 1e-9);
  EXPECT_GE(now->covariance.trace(), at_scan->covariance.trace());
  EXPECT_EQ(drive.step()->time, drive.time_);  // and the next scan goes on as ever
}

TEST(Localizer, StartsWhereItWasIfTheScanAgrees) {
  Drive drive{LocalizationConfig{}};
  drive.localizer_.restore({{2.5, 1.2, 0.0}, {}, 0}, Memory::Fresh);
  EXPECT_EQ(drive.localizer_.memory_outcome(), MemoryOutcome::Awaited);

  const auto result = drive.look();

  ASSERT_TRUE(result);
  EXPECT_EQ(drive.localizer_.memory_outcome(), MemoryOutcome::Agreed);
  EXPECT_EQ(result->status, LocalizationStatus::Ok);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, GoesOnFromWhereItWasByTheWheels) {
  Drive drive{LocalizationConfig{}};
  drive.localizer_.restore({{2.5, 1.2, 0.0}, {}, 0}, Memory::Fresh);
  for (int i = 0; i < 12; ++i) {  // 0.6 m before the first scan
    drive.map_from_base_ = drive.map_from_base_ * Pose2{0.05, 0.0, 0.05};
    drive.odom_from_base_ = drive.odom_from_base_ * Pose2{0.05, 0.0, 0.05};
  }
  const auto result = drive.look();
  ASSERT_TRUE(result);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, DropsARememberedPoseWithWhichTheScanDoesNotAgree) {
  Drive drive{LocalizationConfig{}};
  drive.localizer_.restore({{4.8, 3.0, 2.0}, {}, 0}, Memory::Fresh);

  EXPECT_FALSE(drive.look());

  EXPECT_EQ(drive.localizer_.memory_outcome(), MemoryOutcome::Refused);
  EXPECT_FALSE(drive.localizer_.is_started());
}

TEST(Localizer, IsUncertainOfAnOldMemoryUntilTheWholeMapWasSearched) {
  Drive drive{LocalizationConfig{}};
  drive.localizer_.restore({{2.5, 1.2, 0.0}, {}, 0}, Memory::Old);

  EXPECT_EQ(drive.look()->status, LocalizationStatus::Uncertain);
  std::optional<LocalizationResult> result;
  for (int i = 0; i < 60; ++i) result = drive.step();
  EXPECT_EQ(result->status, LocalizationStatus::Ok);
  EXPECT_LT(drive.error_m(*result), 0.1);
}

TEST(Localizer, GoesOnWhenTheClockWasSetBack) {
  Drive drive{started()};
  for (int i = 0; i < 300; ++i) (void)drive.step();
  drive.time_ -= from_seconds(20.0);

  std::optional<LocalizationResult> result;
  for (int i = 0; i < 10; ++i) result = drive.step();

  ASSERT_TRUE(result);
  EXPECT_EQ(result->time, drive.time_);
  EXPECT_LT(drive.error_m(*result), 0.1);
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::TimeWentBack), 1U);
}

TEST(Localizer, PutsALateOdometrySampleInItsPlace) {
  Drive drive{started()};
  (void)drive.step();
  drive.localizer_.add_odometry({drive.time_ - from_seconds(0.05), drive.odom_from_base_, {}, 0});
  EXPECT_TRUE(drive.step());
  EXPECT_EQ(drive.localizer_.faults().count(InputFault::OdometryOutOfOrder), 1U);
}

}  // namespace
}  // namespace tandem
