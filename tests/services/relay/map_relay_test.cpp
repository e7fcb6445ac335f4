#include "services/relay/map_relay.hpp"

#include <gtest/gtest.h>

#include "services/mapping/map_messages.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

bus::DomainOptions domain_of(int domain, bus::DomainOptions::Kind kind) {
  bus::DomainOptions options;
  options.kind = kind;
  options.domain = domain;
  options.participant = "test";
  return options;
}

/// A host with its services' bus and the part of its relay that is about maps.
struct Host {
  bus::Bus services;
  bus::Bus link;
  MapRelay relay;

  Host(const std::string& name, int host_domain, int link_domain)
      : services(domain_of(host_domain, bus::DomainOptions::Kind::Host)),
        link(domain_of(link_domain, bus::DomainOptions::Kind::Link)),
        relay(name, milliseconds{200}, services) {
    relay.join(link);
  }
};

TEST(MapRelay, BringsTheMapToAHostThatHasNone) {
  const test::DomainLease domains{3};
  Host laptop{"laptop1", domains[0], domains[2]};
  Host robot{"robot1", domains[1], domains[2]};
  const auto map = to_message(test::ascii_map({"###", "#.#", "###"}), "room");
  auto server = laptop.services.writer(topic::kMap);
  auto reader = robot.services.latest(topic::kMap);
  server.write(map);

  ASSERT_TRUE(bus::wait_until(robot.services, seconds{20}, [&] {
    laptop.relay.step();
    robot.relay.step();
    return reader.newest().has_value();
  }));
  EXPECT_EQ(reader.newest()->message, map);
}

TEST(MapRelay, SendsNothingToAHostThatHasOne) {
  const test::DomainLease domains{3};
  Host laptop{"laptop1", domains[0], domains[2]};
  Host robot{"robot1", domains[1], domains[2]};
  bus::Bus observer{domain_of(domains[2], bus::DomainOptions::Kind::Link)};
  auto holdings = observer.latest(topic::kMapHolding);
  auto sent = observer.in_order(topic::kCompressedMap);
  const auto map = to_message(test::ascii_map({"###", "#.#", "###"}), "room");
  auto laptop_server = laptop.services.writer(topic::kMap);
  auto robot_server = robot.services.writer(topic::kMap);
  laptop_server.write(map);
  robot_server.write(map);

  ASSERT_TRUE(bus::wait_until(observer, seconds{20}, [&] {
    laptop.relay.step();
    robot.relay.step();
    const auto all = holdings.each();
    return all.size() == 2 && all[0].message.sha256() == map.sha256() && all[1].message.sha256() == map.sha256();
  }));
  for (int i = 0; i < 5; ++i) {
    laptop.relay.step();
    robot.relay.step();
  }
  EXPECT_TRUE(sent.take().empty());
}

TEST(MapRelay, HostsWithDifferentMapsAreNamedOnBoth) {
  const test::DomainLease domains{3};
  Host laptop{"laptop1", domains[0], domains[2]};
  Host robot{"robot1", domains[1], domains[2]};
  const auto map_of_laptop = to_message(test::ascii_map({"###", "#.#", "###"}), "room");
  const auto map_of_robot = to_message(test::ascii_map({"###", "...", "###"}), "room");
  auto laptop_server = laptop.services.writer(topic::kMap);
  auto robot_server = robot.services.writer(topic::kMap);
  laptop_server.write(map_of_laptop);
  robot_server.write(map_of_robot);
  const auto steps_until = [&](const auto& condition) {
    return bus::wait_until(robot.services, seconds{20}, [&] {
      laptop.relay.step();
      robot.relay.step();
      return condition();
    });
  };
  EXPECT_TRUE(steps_until([&] { return !laptop.relay.trouble().empty() && !robot.relay.trouble().empty(); }));
  EXPECT_EQ(robot.relay.trouble(), "the map of this host (sha256 " + map_of_robot.sha256().substr(0, 8) +
                                       ") is not that of laptop1 (" + map_of_laptop.sha256().substr(0, 8) +
                                       "): give both the same map file");

  robot_server.write(map_of_laptop);
  EXPECT_TRUE(steps_until([&] { return laptop.relay.trouble().empty() && robot.relay.trouble().empty(); }));
}

TEST(MapRelay, AMapServerThatComesLateHasTheSay) {
  const test::DomainLease domains{3};
  Host laptop{"laptop1", domains[0], domains[2]};
  Host robot{"robot1", domains[1], domains[2]};
  auto laptop_server = laptop.services.writer(topic::kMap);
  laptop_server.write(to_message(test::ascii_map({"###", "#.#", "###"}), "room"));
  auto reader = robot.services.latest(topic::kMap);
  const auto steps_until = [&](const auto& condition) {
    return bus::wait_until(robot.services, seconds{20}, [&] {
      laptop.relay.step();
      robot.relay.step();
      return condition();
    });
  };
  ASSERT_TRUE(steps_until([&] { return reader.newest().has_value(); }));

  auto robot_server = robot.services.writer(topic::kMap);
  robot_server.write(to_message(test::ascii_map({"..."}), "hall"));
  EXPECT_TRUE(steps_until([&] {
    const auto all = reader.each();
    return all.size() == 1 && all[0].message.map_id() == "hall";
  }));
}

}  // namespace
}  // namespace tandem
