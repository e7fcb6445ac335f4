#include "services/localization/localization_service.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "services/localization/localization_messages.hpp"
#include "services/mapping/map_messages.hpp"
#include "tests/services/localization/room.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

msg::LaserScan message_of(const LaserScan& scan) {
  msg::LaserScan message;
  message.robot("robot7");
  message.stamp_ns(to_stamp_ns(scan.time));
  message.angle_min_rad(scan.angle_min_rad);
  message.angle_increment_rad(scan.angle_increment_rad);
  message.range_min_m(scan.range_min_m);
  message.range_max_m(scan.range_max_m);
  message.ranges_m(scan.ranges_m);
  return message;
}

TEST(LocalizationMessages, CarryAnOdometrySample) {
  msg::Odometry message;
  message.stamp_ns(1'500);
  message.epoch(3);
  message.odom_from_base().x(1.0);
  message.odom_from_base().heading(0.5);
  message.velocity().forward_mps(0.25);

  const auto sample = from_message(message);
  ASSERT_TRUE(sample);
  EXPECT_EQ(sample->time, from_stamp_ns(1'500));
  EXPECT_EQ(sample->epoch, 3);
  EXPECT_EQ(sample->odom_from_base, (Pose2{1.0, 0.0, 0.5}));
  EXPECT_EQ(sample->velocity, (Twist2{0.25, 0.0, 0.0}));
}

TEST(LocalizationMessages, RefuseNumbersThatAreNone) {
  msg::Odometry odometry;
  odometry.odom_from_base().x(std::nan(""));
  EXPECT_FALSE(from_message(odometry));

  msg::PoseHint hint;
  hint.standard_deviation_m(-1.0);
  EXPECT_FALSE(from_message(hint));

  msg::LaserScan scan;
  scan.angle_increment_rad(std::numeric_limits<double>::infinity());
  EXPECT_FALSE(from_message(scan));
}

TEST(LocalizationMessages, CarryAResult) {
  LocalizationResult result{.time = from_stamp_ns(77),
                            .odometry_epoch = 2,
                            .map_from_base = {1.0, 2.0, 3.0},
                            .agreement = 0.75,
                            .status = LocalizationStatus::Uncertain,
                            .hypotheses = {{{1.0, 2.0, 3.0}, 0.6}, {{4.0, 5.0, 0.0}, 0.4}}};
  result.covariance(0, 1) = 0.5;

  const msg::RobotPose message = to_message(result, "robot7");
  EXPECT_EQ(message.robot(), "robot7");
  EXPECT_EQ(message.stamp_ns(), 77);
  EXPECT_EQ(message.odometry_epoch(), 2U);
  EXPECT_EQ(message.map_from_base().heading(), 3.0);
  EXPECT_EQ(message.covariance()[1], 0.5);
  EXPECT_EQ(message.agreement(), 0.75);
  EXPECT_EQ(message.status(), msg::LOCALIZATION_UNCERTAIN);
  ASSERT_EQ(message.hypotheses().size(), 2U);
  EXPECT_EQ(message.hypotheses()[1].weight(), 0.4);
}

TEST(LocalizationMessages, SayThatNoPoseIsKnown) {
  EXPECT_EQ(no_pose(Time{}, "robot7").status(), msg::LOCALIZATION_LOST);
  EXPECT_TRUE(no_pose(Time{}, "robot7").hypotheses().empty());
}

TEST(LocalizationService, StartsFromAHintAndFollowsScans) {
  const test::DomainLease domain{1};
  SiteConfig site;
  site.robot = "robot7";
  site.host_domain = domain[0];
  bus::Bus bus{bus::host_domain(site, "localization", bus::Pace::Lockstep)};
  bus::Bus other{bus::host_domain(site, "others", bus::Pace::Lockstep)};
  auto maps = other.writer(topic::kMap);
  auto odometry = other.writer(topic::kOdometry);
  auto scans = other.writer(topic::kScan);
  bus::EventSender hints{other, topic::kPoseHint};
  auto poses = other.in_order(topic::kRobotPose);
  const SteadyClock clock;
  LocalizationService service{LocalizationConfig{}, site, bus, clock};
  const auto step_until = [&](const auto& condition) {
    return bus::wait_until(other, from_seconds(20.0), [&] {
      service.step();
      hints.step();
      return condition();
    });
  };
  ASSERT_TRUE(step_until([&] {
    return poses.matched_writers() == 1 && odometry.raw().matched_readers() == 1 && scans.raw().matched_readers() == 1;
  }));

  const OccupancyGrid room = test::uneven_room();
  const Pose2 truth{2.5, 1.2, 0.3};
  maps.write(to_message(room, "room"));
  const auto pose_at = [&](double seconds) {
    const Time time{from_seconds(seconds)};
    msg::Odometry sample;
    sample.robot("robot7");
    sample.stamp_ns(to_stamp_ns(time));
    odometry.write(sample);
    scans.write(message_of(test::scan_from(room, truth, time)));
    std::vector<bus::Received<msg::RobotPose>> received;
    EXPECT_TRUE(step_until([&] { return !(received = poses.take()).empty(); }));
    return received.empty() ? msg::RobotPose{} : received.back().message;
  };
  EXPECT_TRUE(pose_at(1.0).hypotheses().empty());  // nobody said yet where it is

  msg::PoseHint hint;
  hint.robot("robot7");
  hint.id("hint-1");
  hint.stamp_ns(to_stamp_ns(Time{from_seconds(1.0)}));
  hint.map_from_base().x(2.6);
  hint.map_from_base().y(1.1);
  hint.map_from_base().heading(0.3);
  hint.heading_known(true);
  hint.standard_deviation_m(0.2);
  hints.send(hint);
  ASSERT_TRUE(step_until([&] { return hints.outcome("hint-1").state == bus::EventOutcome::State::Applied; }));

  const msg::RobotPose pose = pose_at(1.1);
  EXPECT_NEAR(pose.map_from_base().x(), truth.x, 0.1);
  EXPECT_NEAR(pose.map_from_base().y(), truth.y, 0.1);
  EXPECT_EQ(pose.status(), msg::LOCALIZATION_OK);
  EXPECT_EQ(pose.stamp_ns(), 1'100'000'000);
}

}  // namespace
}  // namespace tandem
