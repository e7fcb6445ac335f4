#include "robot/laser/laser_service.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/laser/laser_messages.hpp"
#include "tests/robot/laser/fake_tcp_sensor.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

SiteConfig site_in(int domain) {
  SiteConfig site;
  site.robot = "robot7";
  site.host_domain = domain;
  return site;
}

TEST(LaserMessages, CarryAReadingThereAndBack) {
  const LaserReading reading{.first_beam = from_stamp_ns(1'234),
                             .angle_min_rad = -1.0,
                             .angle_increment_rad = 0.5,
                             .scan_period_s = 0.025,
                             .beam_interval_s = 0.001,
                             .range_min_m = 0.02,
                             .range_max_m = 30.0,
                             .ranges_m = {1.0f, std::numeric_limits<float>::quiet_NaN(), 3.0f},
                             .intensities = {7.0f, 8.0f, 9.0f}};

  const msg::LaserScan message = to_message(reading, "robot7", {0.16, 0.0, 0.1}, 42);
  EXPECT_EQ(message.robot(), "robot7");
  EXPECT_EQ(message.sequence_number(), 42u);
  EXPECT_EQ(message.base_from_laser().x(), 0.16);
  EXPECT_EQ(message.base_from_laser().heading(), 0.1);

  const LaserReading back = from_message(message);
  EXPECT_EQ(back.first_beam, reading.first_beam);
  EXPECT_EQ(back.angle_min_rad, reading.angle_min_rad);
  EXPECT_EQ(back.angle_increment_rad, reading.angle_increment_rad);
  EXPECT_EQ(back.scan_period_s, reading.scan_period_s);
  EXPECT_EQ(back.beam_interval_s, reading.beam_interval_s);
  EXPECT_EQ(back.range_min_m, reading.range_min_m);
  EXPECT_EQ(back.range_max_m, reading.range_max_m);
  EXPECT_EQ(back.ranges_m[0], 1.0f);
  EXPECT_TRUE(std::isnan(back.ranges_m[1]));
  EXPECT_EQ(back.intensities, reading.intensities);
}

TEST(LaserService, PublishesScansInOrderAndHowTheLaserIs) {
  const test::DomainLease domain{1};
  const SiteConfig site = site_in(domain[0]);
  FakeTcpSensor server;
  bus::Bus bus{bus::host_domain(site, "laser")};
  bus::Bus other{bus::host_domain(site, "listener")};
  auto scans = other.in_order(topic::kScan);
  auto health = other.latest(topic::kServiceHealth);
  SteadyClock clock;
  LaserService service{LaserConfig{.device = server.device(), .mount_x_m = 0.16}, site, bus, clock, clock};

  std::vector<msg::LaserScan> received;
  const auto step_until = [&](const auto& condition) {
    return bus::wait_until(other, from_seconds(20.0), [&] {
      server.step();
      service.step();
      for (auto& scan : scans.take()) received.push_back(std::move(scan.message));
      return condition();
    });
  };
  ASSERT_TRUE(step_until([&] { return received.size() >= 3; }));
  for (std::size_t i = 1; i < received.size(); ++i) {
    EXPECT_GT(received[i].sequence_number(), received[i - 1].sequence_number());
  }
  EXPECT_EQ(received[0].robot(), "robot7");
  EXPECT_EQ(received[0].ranges_m().size(), 361u);
  EXPECT_EQ(received[0].base_from_laser().x(), 0.16);
  EXPECT_TRUE(step_until([&] { return health.newest() && health.newest()->message.state() == msg::HEALTH_OK; }));

  server.unplug();
  EXPECT_TRUE(step_until([&] { return health.newest()->message.state() == msg::HEALTH_FAILED; }));
  EXPECT_NE(health.newest()->message.reason().find(server.device()), std::string::npos);
}

}  // namespace
}  // namespace tandem
