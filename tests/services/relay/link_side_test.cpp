#include "services/relay/link_side.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "services/relay/relay_service.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

using std::chrono::seconds;

SiteConfig site_of(const std::string& host, const std::string& role, int host_domain, int link_domain) {
  SiteConfig site;
  site.host = host;
  site.role = role;
  site.host_domain = host_domain;
  site.link_domain = link_domain;
  return site;
}

/// A robot's host with one topic that the link brings: the session.
struct RobotHost {
  explicit RobotHost(const test::DomainLease& domains)
      : site(site_of("robot1", "robot", domains[0], domains[1])),
        services(bus::host_domain(site, "test")),
        relay(bus::host_domain(site, "relay")) {
    inward.push_back({info_of(topic::kSession), relay.raw_writer(info_of(topic::kSession)), {}});
  }
  void join() {
    link.reset();  // as the relay does: never two at a time
    link = std::make_unique<LinkSide>(link_domain(site, RelayConfig{}, "127.0.0.1"), HostRole::Robot, RelayConfig{},
                                      relay, inward, [] { return std::optional<Duration>{}; });
  }

  SiteConfig site;
  bus::Bus services;
  bus::Bus relay;
  std::vector<InwardTopic> inward;
  std::unique_ptr<LinkSide> link;
};

// Joined anew while the other host is out of reach, nobody would be left who could see its writers lost.
TEST(LinkSide, WhatItBroughtIsMarkedWhenItEndsAndWholeAgainOverTheNext) {
  const test::DomainLease domains{2};
  RobotHost robot{domains};
  auto reader = robot.services.latest(topic::kSession);
  const auto becomes = [&](bool writer_alive) {
    return bus::wait_until(robot.services, seconds{20}, [&] {
      const auto newest = reader.newest();
      return newest && newest->writer_alive == writer_alive && newest->message.code() == "P07";
    });
  };
  bus::Bus laptop{link_domain(site_of("laptop1", "laptop", 0, domains[1]), RelayConfig{}, "127.0.0.1")};
  auto session = laptop.writer(topic::kSession);
  msg::SessionState state;
  state.robot("robot1");
  state.code("P07");
  session.write(state);

  robot.join();
  ASSERT_TRUE(becomes(true));
  robot.link.reset();
  EXPECT_TRUE(becomes(false));
  robot.join();
  EXPECT_TRUE(becomes(true));
}

}  // namespace
}  // namespace tandem
