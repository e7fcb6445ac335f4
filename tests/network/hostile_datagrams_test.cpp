// Rows X2 and X4 of docs/network.md, "Wrong peers": datagrams that are no RTPS, or RTPS gone wrong, sent to every port
// of a relay from another host of the link.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <linux/if_ether.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <set>

#include "services/common/random.hpp"
#include "tests/network/two_hosts.hpp"

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t kOfEachKind = 1'000;
constexpr double kMostGrowth_MB = 50.0;

using Datagram = std::vector<std::uint8_t>;

/// A datagram as it was seen on the air, and the port it went to.
struct Seen {
  std::uint16_t port = 0;
  Datagram payload;
};

/// Listens at the robot's interface until `count` RTPS messages have passed, both ways.
class Sniffer {
 public:
  explicit Sniffer(const LabHost& host)
      : socket_(host.run([] { return socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_ALL)); })) {
    EXPECT_GE(socket_, 0) << std::strerror(errno);
  }
  ~Sniffer() { close(socket_); }
  Sniffer(const Sniffer&) = delete;
  Sniffer& operator=(const Sniffer&) = delete;

  [[nodiscard]] std::vector<Seen> listen(std::size_t count) const {
    std::vector<Seen> seen;
    const SteadyClock clock;
    const Time end = clock.now() + seconds{10};
    std::array<std::uint8_t, 65536> packet{};
    while (seen.size() < count && clock.now() < end) {
      pollfd waiting{socket_, POLLIN, 0};
      if (poll(&waiting, 1, 100) <= 0) continue;
      const ssize_t size = recv(socket_, packet.data(), packet.size(), 0);
      if (size > 0) append(seen, {packet.begin(), packet.begin() + size});
    }
    return seen;
  }

 private:
  static void append(std::vector<Seen>& seen, const Datagram& ip) {
    constexpr std::size_t kUdpHeader = 8;
    if (ip.size() < 20 || ip[0] >> 4 != 4 || ip[9] != IPPROTO_UDP) return;
    const std::size_t udp = (ip[0] & 0xFU) * 4U;
    if (ip.size() < udp + kUdpHeader + 4 || std::memcmp(&ip[udp + kUdpHeader], "RTPS", 4) != 0) return;
    const auto port = static_cast<std::uint16_t>(ip[udp + 2] << 8 | ip[udp + 3]);
    seen.push_back({port, {ip.begin() + static_cast<std::ptrdiff_t>(udp + kUdpHeader), ip.end()}});
  }

  int socket_;
};

/// Sends datagrams from a host of the laboratory.
class Attacker {
 public:
  explicit Attacker(const LabHost& host)
      : socket_(host.run([] { return socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0); })) {}
  ~Attacker() { close(socket_); }
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  void send(const Datagram& payload, const std::string& address, std::uint16_t port) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    inet_pton(AF_INET, address.c_str(), &to.sin_addr);
    // A port where nobody listens answers with an error, which the next call reports: it is sent all the same.
    std::ignore = sendto(socket_, payload.data(), payload.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
  }

 private:
  int socket_;
};

std::size_t below(Rng& rng, std::size_t bound) {
  return static_cast<std::size_t>(rng.bits() % bound);
}

Datagram noise(Rng& rng) {
  Datagram bytes(1 + below(rng, 1400));
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(rng.bits());
  return bytes;
}

/// The first bytes of a message, within the header of the message or of its first submessage.
Datagram truncated_header(const Seen& seen, Rng& rng) {
  Datagram bytes = seen.payload;
  bytes.resize(std::min<std::size_t>(bytes.size(), 1 + below(rng, 28)));
  return bytes;
}

/// A message with one to eight bytes changed, or cut, behind its header; one in four pretends to be of another vendor
/// or participant as well.
Datagram mutated(const Seen& seen, Rng& rng) {
  Datagram bytes = seen.payload;
  const std::size_t from = below(rng, 4) == 0 ? 4 : 20;
  for (std::size_t changes = 1 + below(rng, 8); changes > 0 && bytes.size() > from; --changes) {
    const std::size_t at = from + below(rng, bytes.size() - from);
    if (below(rng, 10) == 0) {
      bytes.resize(at);
    } else {
      bytes[at] = below(rng, 3) == 0 ? 0xFF : static_cast<std::uint8_t>(rng.bits());
    }
  }
  return bytes;
}

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
      const Datagram datagram = make(seen[below(rng, seen.size())], rng);
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
  expect_harmless([](const Seen&, Rng& rng) { return noise(rng); });
}

TEST_F(HostileDatagrams, X2TruncatedHeadersAreHarmless) {
  TANDEM_NEEDS_LABORATORY();
  expect_harmless(truncated_header);
}

TEST_F(HostileDatagrams, X2MutatedMessagesAreHarmless) {
  TANDEM_NEEDS_LABORATORY();
  expect_harmless(mutated);
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
