// Rows X2 and X4 of docs/network.md, "Wrong peers": datagrams that are no RTPS, or RTPS gone wrong, sent to every port
// of a relay from another host of the link.
#include <gtest/gtest.h>

#include <set>

#include "tests/network/attacker.hpp"
#include "tests/network/forger.hpp"
#include "tests/network/two_hosts.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

constexpr std::size_t kOfEachKind = 1'000;
constexpr double kMostGrowth_MB = 50.0;

/// Robot, laptop, and a third host on the same Wi-Fi.
class HostileDatagrams : public ::testing::Test {
 protected:
  /// Sends a thousand of `make` to the robot's relay, and then sees that it works as before.
  void expect_harmless(const std::function<Datagram(const Seen&, Rng&)>& make) {
    TwoHosts hosts{{}, {}, {"intruder"}};
    const Sniffer sniffer{hosts.lab().host("robot")};
    ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
    const auto seen = sniffer.listen(100);
    ASSERT_GE(seen.size(), 20U);
    std::set<std::uint16_t> ports;
    for (const auto& one : seen) ports.insert(one.port);
    const double before_MB = hosts.robot().relay_memory_MB();

    const Attacker attacker{hosts.lab().host("intruder")};
    const std::string robot = hosts.lab().host("robot").address();
    Rng rng{11};
    for (std::size_t i = 0; i < kOfEachKind; ++i) {
      const Datagram datagram = make(seen[rng.bits() % seen.size()], rng);
      for (const std::uint16_t port : ports) attacker.send(datagram, robot, port);
      // Now and then what is good must pass; and no faster, or the test measures socket buffers.
      if (i % 50 != 0) continue;
      ASSERT_TRUE(poses_get_through(hosts, seconds{20})) << "after " << i << " datagrams, seed 11";
    }
    EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
    EXPECT_TRUE(hosts.robot().relay_runs());
    const double growth_MB = hosts.robot().relay_memory_MB() - before_MB;
    EXPECT_LT(growth_MB, kMostGrowth_MB);
    RecordProperty("growth_MB", std::to_string(growth_MB));
  }
};

TEST_F(HostileDatagrams, X2NoiseToEveryPortIsHarmless) {
  TANDEM_NEEDS_LABORATORY();
  expect_harmless(noise);
}

TEST_F(HostileDatagrams, X2TruncatedHeadersAreHarmless) {
  TANDEM_NEEDS_LABORATORY();
  expect_harmless(truncated_header);
}

TEST_F(HostileDatagrams, X2MutatedMessagesAreHarmless) {
  TANDEM_NEEDS_LABORATORY();
  expect_harmless(mutated);
}

/// Robot and laptop, and a third host that knows their relays' names and speaks for either to the other.
class ForgedDatagrams : public ::testing::Test {
 protected:
  using Say = std::function<void(const Forger&, const std::string& to)>;

  void expect_unharmed_by(const Say& say) {
    TwoHosts hosts{{}, {}, {"intruder"}};
    ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
    Forger forger{hosts.lab().host("intruder"), hosts.link_domain()};
    const RelayHealth laptop_health{hosts.laptop()};
    const std::string robot = hosts.lab().host("robot").address();
    const std::string laptop = hosts.lab().host("laptop").address();
    for (const auto& [from, to] : {std::pair{laptop, robot}, std::pair{robot, laptop}}) {
      ASSERT_TRUE(forger.overhear(from));
      say(forger, to);
    }
    EXPECT_TRUE(poses_get_through(hosts, seconds{10}));
    EXPECT_TRUE(bus::wait_until(hosts.laptop().bus(), seconds{10}, [&] {
      say(forger, laptop);
      return laptop_health.names("X2: datagrams from " + hosts.lab().host("intruder").address() + " dropped: sequence");
    }));
    // A reader that Fast DDS holds locked would keep its participant from ending.
    hosts.robot().restart_relay();
    hosts.laptop().restart_relay();
    EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
  }
};

TEST_F(ForgedDatagrams, X2AGapWithoutEndDoesNotStopTheLink) {
  TANDEM_NEEDS_LABORATORY();
  expect_unharmed_by([](const Forger& forger, const std::string& to) { forger.forge_gap(to, 1, 1LL << 40); });
}

TEST_F(ForgedDatagrams, X2ASampleFarAheadDoesNotHideThoseThatFollow) {
  TANDEM_NEEDS_LABORATORY();
  const auto payload = bus::encode<msg::RobotPosePubSubType>(msg::RobotPose{});
  expect_unharmed_by([&](const Forger& forger, const std::string& to) {
    for (const std::int64_t number : {100'000LL, 900'000'000LL, 1LL << 40}) forger.forge(to, payload, number);
  });
}

TEST_F(HostileDatagrams, X4AHostsOwnDomainCannotBeReachedFromTheAir) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts{{}, {}, {"intruder"}};
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
  auto commands = hosts.robot().bus().in_order(topic::kVelocityCommand);
  const LabHost& host = hosts.lab().host("intruder");
  bus::DomainOptions options;
  options.domain = hosts.host_domain();
  options.participant = "navigator@robot1";
  options.address = host.address();
  const auto intruder = host.run([&] { return std::make_unique<bus::Bus>(options); });
  auto writer = host.run([&] { return intruder->writer(topic::kVelocityCommand); });
  msg::VelocityCommand command;
  command.robot("robot1");
  command.forward_mps(0.5);
  // For longer than it takes the robot's own poses to get to the laptop.
  for (int i = 0; i < 10; ++i) {
    writer.write(command);
    ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
  }
  EXPECT_EQ(writer.raw().matched_readers(), 0);
  EXPECT_EQ(commands.matched_writers(), 0);
  EXPECT_TRUE(commands.take().empty());
}

}  // namespace
}  // namespace tandem::test
