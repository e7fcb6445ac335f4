#include "services/relay/relay_service.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "services/relay/relay_messages.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A host with its services' bus and its relay.
struct Host {
  SiteConfig site;
  bus::Bus services;
  bus::Bus relay_host;
  RelayService relay;

  Host(const std::string& name, const std::string& role, const std::string& robot, int host_domain, int link_domain)
      : site(make_site(name, role, robot, host_domain, link_domain)),
        services(bus::host_domain(site, "test")),
        relay_host(bus::host_domain(site, "relay")),
        relay(site, RelayConfig{}, relay_host) {}

  static SiteConfig make_site(const std::string& name, const std::string& role, const std::string& robot,
                              int host_domain, int link_domain) {
    SiteConfig site;
    site.host = name;
    site.role = role;
    site.robot = robot;
    site.host_domain = host_domain;
    site.link_domain = link_domain;
    return site;
  }
};

/// The link of robot1's team, for somebody on the Wi-Fi.
bus::DomainOptions link_of(const std::string& name, int link_domain) {
  return tandem::link_domain(Host::make_site(name, "laptop", "robot1", 0, link_domain), RelayConfig{}, "127.0.0.1");
}

msg::BaseStatus status_of(const std::string& robot) {
  msg::BaseStatus status;
  status.robot(robot);
  return status;
}

TEST(Relay, CarriesAStateToTheOtherHostAndTellsThatTheLinkIsUp) {
  const test::DomainLease domains{3};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[2]};
  Host laptop{"laptop1", "laptop", "robot1", domains[1], domains[2]};
  auto writer = robot.services.writer(topic::kBaseStatus);
  auto reader = laptop.services.latest(topic::kBaseStatus);
  auto link = laptop.services.latest(topic::kLinkStatus);
  EXPECT_TRUE(writer.write(status_of("robot1")));

  EXPECT_TRUE(bus::wait_until(laptop.services, seconds{20}, [&] {
    robot.relay.step();
    laptop.relay.step();
    const auto status = link.newest();
    return reader.newest() && status && status->message.up() && status->message.peer() == "robot1";
  }));
}

TEST(Relay, ItsOwnHealthReachesTheOtherHostAndNothingGoesInCircles) {
  const test::DomainLease domains{3};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[2]};
  Host laptop{"laptop1", "laptop", "robot1", domains[1], domains[2]};
  auto health = laptop.services.latest(topic::kServiceHealth);
  auto count = laptop.services.in_order(topic::kServiceHealth);
  std::set<std::string> hosts;
  EXPECT_TRUE(bus::wait_until(laptop.services, seconds{20}, [&] {
    robot.relay.step();
    laptop.relay.step();
    for (const auto& received : health.each()) hosts.insert(received.message.host());
    return hosts.size() == 2;
  }));
  // One sample a second of each host: an echo between the relays would make many more.
  EXPECT_LE(count.take().size(), 8U);
}

/// Steps the robot's relay until its heartbeats have come from two participants: it has joined the link anew.
bool joins_anew(Host& robot, bus::Bus& laptop, const std::function<void()>& each_step) {
  auto heard = laptop.in_order(topic::kLinkHeartbeat);
  std::set<bus::WriterId> participants;
  return bus::wait_until(laptop, seconds{30}, [&] {
    each_step();
    robot.relay.step();
    for (const auto& beat : heard.take()) {
      if (beat.message.host() == "robot1") participants.insert(beat.writer);
    }
    return participants.size() == 2;
  });
}

TEST(Relay, JoinsTheLinkAnewWhereTheOtherHostIsHeardButNotFound) {
  const test::DomainLease domains{2};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[1]};
  // Of this laptop nothing was discovered but its heartbeats.
  bus::Bus laptop{link_of("laptop1", domains[1])};
  auto beats = laptop.writer(topic::kLinkHeartbeat);
  LinkMonitor monitor{"laptop1", seconds{2}};
  EXPECT_TRUE(joins_anew(robot, laptop,
                         [&] { beats.write(to_message(monitor.next_heartbeat(laptop.clock().now()), "laptop")); }));
}

TEST(Relay, JoinsTheLinkAnewWhereTheOtherHostIsFoundButNotHeard) {
  const test::DomainLease domains{2};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[1]};
  bus::Bus laptop{link_of("laptop1", domains[1])};
  auto beats = laptop.writer(topic::kLinkHeartbeat);
  EXPECT_TRUE(joins_anew(robot, laptop, [] {}));
}

TEST(Relay, AVelocityOnTheLinkNeverArrives) {
  const test::DomainLease domains{3};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[2]};
  // Somebody on the Wi-Fi, in the team's own partition.
  bus::Bus intruder{link_of("evil", domains[2])};
  auto velocity = intruder.writer(topic::kVelocityCommand);
  auto stop = intruder.writer(topic::kStopRequest);
  auto velocities = robot.services.in_order(topic::kVelocityCommand);
  auto stops = robot.services.in_order(topic::kStopRequest);
  msg::VelocityCommand command;
  command.robot("robot1");
  command.forward_mps(1.0);
  msg::StopRequest request;
  request.robot("robot1");

  // When the stop arrives, sent later on the same link, a velocity would have come long ago.
  std::size_t stops_seen = 0;
  EXPECT_TRUE(bus::wait_until(robot.services, seconds{20}, [&] {
    velocity.write(command);
    stop.write(request);
    stops_seen += stops.take().size();
    return stops_seen >= 5;
  }));
  EXPECT_EQ(velocity.raw().matched_readers(), 0);
  EXPECT_TRUE(velocities.take().empty());
}

TEST(Relay, TwoTeamsOnOneLinkDoNotMix) {
  const test::DomainLease domains{5};
  Host robot1{"robot1", "robot", "robot1", domains[0], domains[4]};
  Host laptop1{"laptop1", "laptop", "robot1", domains[1], domains[4]};
  Host robot2{"robot2", "robot", "robot2", domains[2], domains[4]};
  Host laptop2{"laptop2", "laptop", "robot2", domains[3], domains[4]};
  auto writer1 = robot1.services.writer(topic::kBaseStatus);
  auto writer2 = robot2.services.writer(topic::kBaseStatus);
  auto reader1 = laptop1.services.latest(topic::kBaseStatus);
  auto reader2 = laptop2.services.latest(topic::kBaseStatus);
  EXPECT_TRUE(writer1.write(status_of("robot1")));
  EXPECT_TRUE(writer2.write(status_of("robot2")));

  ASSERT_TRUE(bus::wait_until(laptop1.services, seconds{20}, [&] { return reader1.newest() && reader2.newest(); }));
  ASSERT_EQ(reader1.each().size(), 1U);
  ASSERT_EQ(reader2.each().size(), 1U);
  EXPECT_EQ(reader1.newest()->message.robot(), "robot1");
  EXPECT_EQ(reader2.newest()->message.robot(), "robot2");
}

TEST(Relay, ADisposedStateIsDisposedOnTheOtherHost) {
  const test::DomainLease domains{3};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[2]};
  Host laptop{"laptop1", "laptop", "robot1", domains[1], domains[2]};
  auto writer = robot.services.writer(topic::kBaseStatus);
  auto reader = laptop.services.latest(topic::kBaseStatus);
  EXPECT_TRUE(writer.write(status_of("robot1")));
  ASSERT_TRUE(bus::wait_until(laptop.services, seconds{20}, [&] { return reader.newest().has_value(); }));

  EXPECT_TRUE(writer.dispose(status_of("robot1")));
  EXPECT_TRUE(bus::wait_until(laptop.services, seconds{20}, [&] { return !reader.newest(); }));
}

TEST(Relay, DropsMalformedSamplesAtTheDoor) {
  const test::DomainLease domains{3};
  Host robot{"robot1", "robot", "robot1", domains[0], domains[2]};
  bus::Bus intruder{link_of("evil", domains[2])};
  auto raw = intruder.raw_writer(info_of(topic::kTeamPlan));
  auto good = intruder.writer(topic::kTeamPlan);
  auto plans = robot.services.in_order(topic::kTeamPlan);
  msg::TeamPlan plan;
  plan.robot("robot1");
  const std::vector<std::uint8_t> garbage{0x12, 0x34, 0, 0, 1, 2, 3, 4};

  std::size_t seen = 0;
  EXPECT_TRUE(bus::wait_until(robot.services, seconds{20}, [&] {
    raw->write(garbage, {9});
    good.write(plan);
    seen += plans.take().size();
    return seen >= 3;
  }));
  EXPECT_EQ(plans.undecodable(), 0U);
}

}  // namespace
}  // namespace tandem
