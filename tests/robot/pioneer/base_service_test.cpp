#include "robot/pioneer/base_service.hpp"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <thread>

#include "services/common/clock.hpp"
#include "services/common/version.hpp"
#include "tests/robot/pioneer/core/fake_controller.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

/// A fake controller behind TCP on a free port, moved along by the test's own thread.
class TcpController {
 public:
  TcpController() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~TcpController() {
    if (connection_ >= 0) ::close(connection_);
    ::close(listener_);
  }
  [[nodiscard]] std::string device() const { return "tcp://127.0.0.1:" + std::to_string(port_); }
  void step(Time now) {
    if (connection_ < 0) connection_ = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK);
    if (connection_ < 0) return;
    std::array<std::uint8_t, 1024> bytes{};
    const ssize_t count = ::recv(connection_, bytes.data(), bytes.size(), 0);
    if (count > 0) controller.receive({bytes.begin(), bytes.begin() + count}, now);
    const pioneer::Bytes answer = controller.step(now);
    if (!answer.empty()) static_cast<void>(::send(connection_, answer.data(), answer.size(), MSG_NOSIGNAL));
  }

  pioneer::FakeController controller;

 private:
  int listener_ = -1;
  int connection_ = -1;
  std::uint16_t port_ = 0;
};

/// Runs `service` and the controller in turn until `condition` holds, at most 10 s.
template <typename Condition>
bool run_until(BaseService& service, TcpController& tcp, Clock& clock, Condition condition) {
  const Time latest = clock.now() + std::chrono::seconds{10};
  while (clock.now() < latest) {
    tcp.step(clock.now());
    service.step();
    if (condition()) return true;
  }
  return false;
}

/// A navigator and a laser in one, with everything far away.
class Driver {
 public:
  Driver(bus::Bus& bus, std::string robot, const Clock& clock)
      : robot_(std::move(robot)),
        clock_(clock),
        commands_(bus.writer(topic::kVelocityCommand)),
        scans_(bus.writer(topic::kScan)) {}

  void command() {
    msg::VelocityCommand command;
    command.robot(robot_);
    command.commander("navigator");
    command.sequence_number(++number_);
    command.forward_mps(0.2);
    commands_.write(command);
  }
  void command_and_scan() {
    command();
    msg::LaserScan scan;
    scan.robot(robot_);
    scan.sequence_number(number_);
    scan.stamp_ns(to_stamp_ns(clock_.now()));
    scan.angle_min_rad(-1.5);
    scan.angle_increment_rad(0.0166);
    scan.range_max_m(30.0);
    scan.ranges_m(std::vector<float>(181, 8.0F));
    scan.ranges_m()[90] = 7.0F + 0.01F * static_cast<float>(number_ % 10);
    scans_.write(scan);
  }

 private:
  std::string robot_;
  const Clock& clock_;
  std::uint64_t number_ = 0;
  bus::Writer<msg::VelocityCommand, msg::VelocityCommandPubSubType> commands_;
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_;
};

class BaseServiceTest : public testing::Test {
 protected:
  BaseServiceTest() {
    site_.host_domain = domain_[0];
    config_.device = tcp_.device();
    config_.gate.require_link = false;
    config_.gate.require_pose = false;
    config_.gate.healthy_s = 0.0;
    config_.gate.warning_s = 0.5;
    tcp_.controller.config.watchdog_ms = 500;
  }

  test::DomainLease domain_{1};
  SiteConfig site_;
  BaseConfig config_;
  TcpController tcp_;
  SteadyClock clock_;
};

TEST_F(BaseServiceTest, NoRobotAnsweringIsReportedAndNeverReady) {
  bus::Bus bus{bus::host_domain(site_, "test")};
  auto statuses = bus.latest(topic::kBaseStatus);
  auto healths = bus.latest(topic::kServiceHealth);
  config_.device = "tcp://127.0.0.1:1";
  bus::Bus base_bus{bus::host_domain(site_, "base")};
  BaseService service{config_, {}, site_, base_bus, clock_, clock_};

  ASSERT_TRUE(run_until(service, tcp_, clock_, [&] { return statuses.newest() && healths.newest(); }));
  EXPECT_FALSE(statuses.newest()->message.connected());
  EXPECT_EQ(healths.newest()->message.state(), msg::HEALTH_STARTING);
  EXPECT_NE(healths.newest()->message.reason().find("no answer from tcp://127.0.0.1:1"), std::string::npos);
}

TEST_F(BaseServiceTest, DrivesOnCommandStopsOnRequestAndSwitchesTheMotorsOffAtTheEnd) {
  bus::Bus bus{bus::host_domain(site_, "test")};
  auto statuses = bus.latest(topic::kBaseStatus);
  auto odometry = bus.latest(topic::kOdometry);
  Driver driver{bus, site_.robot, clock_};
  bus::EventSender stops{bus, topic::kStopRequest};
  bus::Bus base_bus{bus::host_domain(site_, "base")};
  std::optional<BaseService> service{std::in_place, config_, MapZones{}, site_, base_bus, clock_, clock_};
  ASSERT_TRUE(run_until(*service, tcp_, clock_, [&] { return odometry.newest().has_value(); }));
  EXPECT_FALSE(tcp_.controller.motors);

  ASSERT_TRUE(run_until(*service, tcp_, clock_, [&] {
    driver.command_and_scan();
    return tcp_.controller.actual_mmps == 200;
  }));

  msg::StopRequest stop;
  stop.id("stop1");
  stop.who("operator");
  stop.latched(true);
  stops.send(stop);
  ASSERT_TRUE(run_until(*service, tcp_, clock_, [&] {
    driver.command_and_scan();
    return tcp_.controller.actual_mmps == 0 && statuses.newest()->message.latched();
  }));
  EXPECT_EQ(statuses.newest()->message.stop_reasons().front(), msg::STOP_REQUESTED);
  EXPECT_TRUE(tcp_.controller.motors);

  {
    const std::jthread wheels{[&](const std::stop_token& stopping) {
      while (!stopping.stop_requested()) {
        tcp_.step(clock_.now());
        clock_.wait_until(clock_.now() + std::chrono::milliseconds{10}, nullptr);
      }
    }};
    service.reset();
  }
  tcp_.step(clock_.now());
  EXPECT_FALSE(tcp_.controller.motors);
  EXPECT_FALSE(tcp_.controller.open);
}

TEST_F(BaseServiceTest, StandsUntilTheHostHasTheMapWhoseZonesItMinds) {
  bus::Bus bus{bus::host_domain(site_, "test")};
  auto statuses = bus.latest(topic::kBaseStatus);
  auto maps = bus.writer(topic::kMap);
  auto poses = bus.writer(topic::kRobotPose);
  Driver driver{bus, site_.robot, clock_};
  bus::Bus base_bus{bus::host_domain(site_, "base")};
  const MapZones zones{{{"far", {{900.0, 0.0}, {901.0, 0.0}, {901.0, 1.0}}, AreaRule::KeepOut, 0.0}}, "abc"};
  BaseService service{config_, zones, site_, base_bus, clock_, clock_};
  const auto drive = [&] {
    driver.command_and_scan();
    msg::RobotPose pose;
    pose.robot(site_.robot);
    pose.stamp_ns(to_stamp_ns(clock_.now()));
    poses.write(pose);
  };
  const auto stands_for = [&](msg::StopReason reason) {
    return run_until(service, tcp_, clock_, [&] {
      drive();
      if (!statuses.newest() || !statuses.newest()->message.connected()) return false;
      const auto reasons = statuses.newest()->message.stop_reasons();
      return reasons == std::vector<msg::StopReason>{reason};
    });
  };
  ASSERT_TRUE(stands_for(msg::STOP_LOST_POSE));
  msg::OccupancyGrid map;
  map.map_id("lab");
  map.sha256("other");
  maps.write(map);
  const Time until = clock_.now() + std::chrono::seconds{1};
  ASSERT_TRUE(run_until(service, tcp_, clock_, [&] {
    drive();
    return clock_.now() > until;
  }));
  EXPECT_EQ(tcp_.controller.actual_mmps, 0);

  map.sha256("abc");
  maps.write(map);
  EXPECT_TRUE(run_until(service, tcp_, clock_, [&] {
    drive();
    return tcp_.controller.actual_mmps == 200;
  }));
}

/// The reason of the base's own health.
std::string reason_of_base(bus::InOrder<msg::ServiceHealth, msg::ServiceHealthPubSubType>& signs, std::string last) {
  for (const auto& sign : signs.take()) {
    if (sign.message.process_id() == static_cast<std::uint32_t>(getpid())) last = sign.message.reason();
  }
  return last;
}

TEST_F(BaseServiceTest, X5TwoWhoCommandAtOnceStopTheWheelsAndAreNamed) {
  bus::Bus bus{bus::host_domain(site_, "test")};
  auto signs = bus.in_order(topic::kServiceHealth);
  Driver driver{bus, site_.robot, clock_};
  bus::Bus other_bus{bus::host_domain(site_, "navigator")};
  Driver other{other_bus, site_.robot, clock_};
  bus::Bus base_bus{bus::host_domain(site_, "base")};
  BaseService service{config_, {}, site_, base_bus, clock_, clock_};
  ASSERT_TRUE(run_until(service, tcp_, clock_, [&] {
    driver.command_and_scan();
    return tcp_.controller.actual_mmps == 200;
  }));

  const Time began = clock_.now();
  std::string reason;
  EXPECT_TRUE(run_until(service, tcp_, clock_, [&] {
    driver.command_and_scan();
    other.command();
    reason = reason_of_base(signs, reason);
    return tcp_.controller.actual_mmps == 0 && reason == "X5: two programs command the robot at once";
  })) << reason;
  EXPECT_LE(to_seconds(clock_.now() - began), 2.0);

  // As long as both go on.
  const Time end = clock_.now() + std::chrono::seconds{1};
  bool moved = false;
  EXPECT_TRUE(run_until(service, tcp_, clock_, [&] {
    driver.command_and_scan();
    other.command();
    moved = moved || tcp_.controller.actual_mmps != 0;
    return clock_.now() > end;
  }));
  EXPECT_FALSE(moved);
}

TEST_F(BaseServiceTest, X6AnotherBaseOfThisRobotStopsTheWheelsUntilItIsGone) {
  bus::Bus bus{bus::host_domain(site_, "test")};
  auto signs = bus.in_order(topic::kServiceHealth);
  auto other = bus.writer(topic::kServiceHealth);
  Driver driver{bus, site_.robot, clock_};
  bus::Bus base_bus{bus::host_domain(site_, "base")};
  BaseService service{config_, {}, site_, base_bus, clock_, clock_};
  const auto drives = [&] {
    driver.command_and_scan();
    return tcp_.controller.actual_mmps == 200;
  };
  ASSERT_TRUE(run_until(service, tcp_, clock_, drives));

  msg::ServiceHealth sign;
  sign.host("robot1b");
  sign.robot(site_.robot);
  sign.service("base");
  sign.process_id(1);
  sign.contract_hash(contract_hash());
  const Time began = clock_.now();
  std::string reason;
  EXPECT_TRUE(run_until(service, tcp_, clock_, [&] {
    driver.command_and_scan();
    other.write(sign);
    reason = reason_of_base(signs, reason);
    return tcp_.controller.actual_mmps == 0 && reason.starts_with("X6: two base services for robot1");
  })) << reason;
  EXPECT_LE(to_seconds(clock_.now() - began), 2.0);

  EXPECT_TRUE(run_until(service, tcp_, clock_, drives));  // it has been silent for three seconds
}

}  // namespace
}  // namespace tandem
