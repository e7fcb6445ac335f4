// X2: what must not reach Fast DDS is dropped before it, and named; what our own participants send passes.
#include "services/bus/guarded_transport.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "services/bus/bus.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/rtps_datagram.hpp"

namespace tandem::bus {
namespace {

using std::chrono::seconds;

/// Two participants of one link on this machine.
class GuardedLink : public ::testing::Test {
 protected:
  [[nodiscard]] DomainOptions as(const std::string& participant) const {
    DomainOptions options;
    options.kind = DomainOptions::Kind::Link;
    options.domain = domains_[0];
    options.participant = participant;
    options.partitions = {"robot1"};
    return options;
  }
  /// Sends `datagram` to each port at which a participant of the domain may listen.
  void send_to_every_port(const std::vector<std::uint8_t>& datagram) const {
    const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    ASSERT_GE(socket, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    inet_pton(AF_INET, "127.0.0.1", &to.sin_addr);
    for (int offset = 10; offset < 60; ++offset) {
      to.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * domains_[0] + offset));
      std::ignore = sendto(socket, datagram.data(), datagram.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
    }
    close(socket);
  }
  [[nodiscard]] bool robot_names(const std::string& text) const {
    for (const auto& fault : robot_.peer_faults()) {
      if (text_of(fault) == text) return true;
    }
    return false;
  }
  void expect_dropped(const std::vector<std::uint8_t>& datagram, RtpsFault fault) {
    const std::string text = "X2: datagrams from 127.0.0.1 dropped: " + std::string{text_of(fault)};
    EXPECT_TRUE(wait_until(robot_, seconds{10}, [&] {
      send_to_every_port(datagram);
      return robot_names(text);
    })) << text;
  }
  [[nodiscard]] bool plan_gets_through(std::size_t size) {
    msg::TeamPlan plan;
    plan.robot("robot1");
    plan.reason(std::string(size, 'x'));
    plans_out_.write(plan);
    return wait_until(robot_, seconds{10}, [&] {
      const auto newest = plans_in_.newest();
      return newest && newest->message.reason().size() == size;
    });
  }

  test::DomainLease domains_{1};
  Bus robot_{as("relay@robot1")};
  Bus laptop_{as("relay@laptop1")};
  Latest<msg::TeamPlan, msg::TeamPlanPubSubType> plans_in_{robot_.latest(topic::kTeamPlan)};
  Writer<msg::TeamPlan, msg::TeamPlanPubSubType> plans_out_{laptop_.writer(topic::kTeamPlan)};
};

TEST_F(GuardedLink, WhatOurOwnParticipantsSendPasses) {
  for (const std::size_t size : {10U, 5'000U, 100'000U}) EXPECT_TRUE(plan_gets_through(size)) << size;
  msg::TeamPlan plan;
  plan.robot("robot1");
  plans_out_.dispose(plan);
  EXPECT_TRUE(wait_until(robot_, seconds{10}, [&] { return !plans_in_.newest(); }));
  EXPECT_TRUE(robot_.peer_faults().empty());
  EXPECT_TRUE(laptop_.peer_faults().empty());
}

TEST_F(GuardedLink, X2WhatMustNotReachFastDdsIsDroppedAndNamed) {
  ASSERT_TRUE(plan_gets_through(10));
  expect_dropped({1, 2, 3}, RtpsFault::NoMessage);
  expect_dropped(test::RtpsDatagram{}.gap(1, 1LL << 40).bytes(), RtpsFault::Numbers);
  EXPECT_TRUE(plan_gets_through(20));
}

}  // namespace
}  // namespace tandem::bus
