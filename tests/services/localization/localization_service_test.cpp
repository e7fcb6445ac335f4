#include "services/localization/localization_service.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "services/common/file_io.hpp"
#include "services/localization/localization_messages.hpp"
#include "services/mapping/map_messages.hpp"
#include "tests/services/localization/room.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

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

/// The service, in real time, and what the other services of its host send it.
class Host {
 public:
  explicit Host(const LocalizationConfig& config) : site_(site(domain_[0])), service_(config, site_, bus_, clock_) {}

  static SiteConfig site(int domain) {
    SiteConfig site;
    site.robot = "robot7";
    site.host_domain = domain;
    return site;
  }
  bool step_until(const std::function<bool()>& condition) {
    return bus::wait_until(other_, from_seconds(20.0), [&] {
      service_.step();
      for (auto& received : poses_.take()) arrived_.push_back(received.message);
      if (const auto health = health_.take_new()) reason_ = health->message.reason();
      return condition();
    });
  }
  bool connect() {
    const bool connected = step_until([&] {
      return poses_.matched_writers() == 1 && odometry_.raw().matched_readers() == 1 &&
             scans_.raw().matched_readers() == 1 && health_.matched_writers() == 1;
    });
    maps_.write(to_message(room_, "room"));
    return connected && step_until([&] { return reason_.find("waiting for the map") == std::string::npos; });
  }
  void send_odometry(Time time, const Pose2& odom_from_base = {}) {
    msg::Odometry sample;
    sample.robot("robot7");
    sample.stamp_ns(to_stamp_ns(time));
    sample.odom_from_base().x(odom_from_base.x);
    odometry_.write(sample);
  }
  void send_scan(Time time, const Pose2& truth) { scans_.write(message_of(test::scan_from(room_, truth, time))); }
  /// The pose of this stamp, once it has come.
  std::optional<msg::RobotPose> pose_at(Time time) {
    const auto is_it = [&](const msg::RobotPose& pose) { return pose.stamp_ns() == to_stamp_ns(time); };
    const auto found = [&] { return std::find_if(arrived_.begin(), arrived_.end(), is_it); };
    if (!step_until([&] { return found() != arrived_.end(); })) return std::nullopt;
    return *found();
  }

  const test::DomainLease domain_{1};
  SiteConfig site_;
  bus::Bus bus_{bus::host_domain(site_, "localization", bus::Pace::RealTime)};
  bus::Bus other_{bus::host_domain(site_, "others", bus::Pace::RealTime)};
  SteadyClock clock_;
  OccupancyGrid room_ = test::uneven_room();
  bus::Writer<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_{other_.writer(topic::kMap)};
  bus::Writer<msg::Odometry, msg::OdometryPubSubType> odometry_{other_.writer(topic::kOdometry)};
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_{other_.writer(topic::kScan)};
  bus::InOrder<msg::RobotPose, msg::RobotPosePubSubType> poses_{other_.in_order(topic::kRobotPose)};
  bus::Latest<msg::ServiceHealth, msg::ServiceHealthPubSubType> health_{other_.latest(topic::kServiceHealth)};
  std::vector<msg::RobotPose> arrived_;
  std::string reason_ = "waiting for the map";
  LocalizationService service_;
};

LocalizationConfig started_at(const Pose2& pose) {
  LocalizationConfig config;
  config.start = {pose.x, pose.y, pose.heading};
  return config;
}

TEST(LocalizationService, SendsAPoseForEachOdometrySampleInTheOrderOfTheirStamps) {
  const Pose2 truth{2.5, 1.2, 0.3};
  Host host{started_at(truth)};
  ASSERT_TRUE(host.connect());
  const Time now = host.clock_.now();
  const auto at = [&](int ms) { return now + std::chrono::milliseconds{ms}; };

  host.send_odometry(at(0));
  host.send_scan(at(0), truth);
  ASSERT_TRUE(host.pose_at(at(0)));
  host.send_odometry(at(100), {0.1, 0.0, 0.0});
  const auto ahead = host.pose_at(at(100));
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(ahead->map_from_base().x(), truth.x + 0.1 * std::cos(truth.heading), 0.05);

  host.send_scan(at(50), truth * Pose2{0.05, 0.0, 0.0});  // the laser takes its time
  host.send_odometry(at(200), {0.2, 0.0, 0.0});
  ASSERT_TRUE(host.pose_at(at(200)));
  host.send_odometry(at(900), {0.2, 0.0, 0.0});  // the laser is silent: nothing goes on without it
  host.send_scan(at(900), truth * Pose2{0.2, 0.0, 0.0});
  ASSERT_TRUE(host.pose_at(at(900)));
  for (std::size_t i = 1; i < host.arrived_.size(); ++i) {
    EXPECT_LE(host.arrived_[i - 1].stamp_ns(), host.arrived_[i].stamp_ns());
  }
  EXPECT_TRUE(host.step_until([&] { return host.reason_.find("after their stamp") != std::string::npos; }))
      << host.reason_;
}

TEST(LocalizationService, StartsAgainWhereItWas) {
  const Pose2 truth{2.5, 1.2, 0.3};
  const test::TemporaryFolder folder;
  const std::string file = (folder / "last_pose.json").string();
  LocalizationConfig config = started_at(truth);
  config.last_pose_file = file;
  {
    Host host{config};
    ASSERT_TRUE(host.connect());
    const Time now = host.clock_.now();
    host.send_odometry(now);
    host.send_scan(now, truth);
    ASSERT_TRUE(host.pose_at(now));
    ASSERT_TRUE(host.step_until([&] { return std::filesystem::exists(file); }));
  }
  config.start.clear();
  {
    Host host{config};
    ASSERT_TRUE(host.connect());
    const Time now = host.clock_.now();
    host.send_odometry(now);
    host.send_scan(now, truth);
    const auto pose = host.pose_at(now);
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->map_from_base().x(), truth.x, 0.1);
    EXPECT_EQ(pose->status(), msg::LOCALIZATION_OK);
  }
  {
    Host carried_away{config};
    ASSERT_TRUE(carried_away.connect());
    const Time now = carried_away.clock_.now();
    carried_away.send_odometry(now);
    carried_away.send_scan(now, {2.0, 2.6, 2.8});
    EXPECT_TRUE(carried_away.step_until(
        [&] { return carried_away.reason_.find("waiting for a start pose") != std::string::npos; }));
    EXPECT_TRUE(carried_away.arrived_.empty());
  }
  write_file_atomically(file, "{\"format\": ");
  Host corrupt{config};
  ASSERT_TRUE(corrupt.connect());
  EXPECT_EQ(corrupt.reason_, "waiting for a start pose: place the robot on the phone's map");
}

TEST(LocalizationService, NamesBadInputInItsHealth) {
  const Pose2 truth{2.5, 1.2, 0.3};
  Host host{started_at(truth)};
  ASSERT_TRUE(host.connect());
  const Time now = host.clock_.now();
  host.send_odometry(now);
  msg::LaserScan wrong = message_of(test::scan_from(host.room_, truth, now));
  wrong.angle_min_rad(std::numeric_limits<double>::infinity());
  host.scans_.write(wrong);
  EXPECT_TRUE(host.step_until([&] { return host.reason_.find("scan_not_finite 1") != std::string::npos; }))
      << host.reason_;

  wrong.angle_min_rad(std::nan(""));  // dropped by the reader, before it is a scan
  host.scans_.write(wrong);
  EXPECT_TRUE(host.step_until([&] { return host.reason_.find("malformed samples on scan") != std::string::npos; }))
      << host.reason_;
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
