#include "tests/network/lab/laboratory.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <optional>

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int kPort = 4000;

sockaddr_in place_of(const std::string& address) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(kPort);
  inet_pton(AF_INET, address.c_str(), &place.sin_addr);
  return place;
}

/// A UDP socket of a host, at port 4000.
class Udp {
 public:
  explicit Udp(const LabHost& host) {
    host.run([&] {
      socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
      const auto place = place_of("0.0.0.0");
      EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);  // NOLINT: socket interface
      ip_mreq group{};
      inet_pton(AF_INET, "239.1.2.3", &group.imr_multiaddr);
      inet_pton(AF_INET, host.address().c_str(), &group.imr_interface);
      EXPECT_EQ(setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group), 0);
    });
  }
  ~Udp() { close(socket_); }
  Udp(const Udp&) = delete;
  Udp& operator=(const Udp&) = delete;

  void send(const std::string& address, const std::string& text) const {
    const auto place = place_of(address);
    std::ignore = sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&place),
                         sizeof place);  // NOLINT: socket interface
  }
  /// The next datagram; nothing within `patience_ms`.
  [[nodiscard]] std::optional<std::string> receive(int patience_ms) const {
    pollfd source{socket_, POLLIN, 0};
    if (poll(&source, 1, patience_ms) <= 0) return std::nullopt;
    std::string text(65536, ' ');
    const ssize_t size = recv(socket_, text.data(), text.size(), 0);
    if (size < 0) return std::nullopt;
    text.resize(static_cast<std::size_t>(size));
    return text;
  }

 private:
  int socket_ = -1;
};

TEST(Laboratory, CarriesDatagramsOfAnySizeBetweenItsHosts) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  const std::string large(20'000, 'x');  // 14 fragments
  robot.send("10.66.0.2", "hello");
  robot.send("10.66.0.2", large);
  EXPECT_EQ(laptop.receive(5000), "hello");
  EXPECT_EQ(laptop.receive(5000), large);
  EXPECT_GT(lab.count("robot").bytes_sent, 20'000U);
  EXPECT_GT(lab.count("laptop").bytes_received, 20'000U);
}

TEST(Laboratory, CarriesMulticastUnlessItIsSwitchedOff) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop", "phone"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  const Udp phone{lab.host("phone")};
  robot.send("239.1.2.3", "all");
  EXPECT_EQ(laptop.receive(5000), "all");
  EXPECT_EQ(phone.receive(5000), "all");

  lab.set_all({.multicast = false});
  robot.send("239.1.2.3", "nobody");
  robot.send("10.66.0.2", "laptop");
  EXPECT_EQ(laptop.receive(5000), "laptop");  // and not what was sent before
}

TEST(Laboratory, AnOutageOfOneDirectionLeavesTheOther) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  robot.send("10.66.0.2", "hello");  // both know each other's address afterwards
  ASSERT_EQ(laptop.receive(5000), "hello");

  lab.set("laptop", {.out = true});
  robot.send("10.66.0.2", "lost");
  laptop.send("10.66.0.1", "heard");
  EXPECT_EQ(robot.receive(5000), "heard");
  lab.set("laptop", {});
  robot.send("10.66.0.2", "again");
  EXPECT_EQ(laptop.receive(5000), "again");
}

TEST(Laboratory, DelaysWhatAHostReceives) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  lab.set("laptop", {.delay = milliseconds{200}});
  const SteadyClock clock;
  const Time sent = clock.now();
  robot.send("10.66.0.2", "late");
  EXPECT_EQ(laptop.receive(5000), "late");
  EXPECT_GE(clock.now() - sent, milliseconds{200});
}

TEST(Laboratory, AHostThatChangedItsAddressIsHeardAtTheNewOneAlone) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  lab.host("robot").change_address("10.66.0.22");
  laptop.send("10.66.0.1", "old");
  laptop.send("10.66.0.22", "new");
  EXPECT_EQ(robot.receive(5000), "new");
}

TEST(Laboratory, AnInterfaceThatWasDownComesBack) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  const Udp robot{lab.host("robot")};
  const Udp laptop{lab.host("laptop")};
  lab.host("robot").interface_down();
  robot.send("10.66.0.2", "lost");
  lab.host("robot").interface_up();
  robot.send("10.66.0.2", "again");
  EXPECT_EQ(laptop.receive(5000), "again");
}

TEST(Laboratory, ProgramsRunInAHostsNetwork) {
  TANDEM_NEEDS_LABORATORY();
  Laboratory lab{{"robot", "laptop"}};
  lab.host("robot").run([] { run_program({"ip", "address", "show", "dev", "wifi0"}); });
  EXPECT_THROW(run_program({"ip", "address", "show", "dev", "wifi0"}), std::runtime_error);
}

}  // namespace
}  // namespace tandem::test
