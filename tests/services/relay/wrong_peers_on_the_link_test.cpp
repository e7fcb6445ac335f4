// Rows X1, X3, X6 and X7 of docs/network.md, "Wrong peers", where the peer is on the link: the relay names it in its
// service_health on the host, and lets nothing of it in.
#include <gtest/gtest.h>

#include "services/common/version.hpp"
#include "services/relay/relay_service.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

using std::chrono::seconds;

/// A laptop with its relay, and somebody else on its team's link.
class WrongPeersOnTheLink : public ::testing::Test {
 protected:
  [[nodiscard]] SiteConfig site() const {
    SiteConfig site;
    site.host = "laptop1";
    site.role = "laptop";
    site.host_domain = domains_[0];
    site.link_domain = domains_[1];
    return site;
  }
  [[nodiscard]] bus::DomainOptions as(const std::string& participant) const {
    auto options = link_domain(site(), {}, "127.0.0.1");
    options.participant = participant;
    return options;
  }
  /// A heartbeat of another relay, repeated with each step.
  void beat(const std::string& host, const std::string& role, const std::string& contract) {
    heartbeat_.host(host);
    heartbeat_.role(role);
    heartbeat_.contract_hash(contract);
  }
  void step() {
    relay_.step();
    heartbeat_.sequence_number(heartbeat_.sequence_number() + 1);
    if (!heartbeat_.host().empty()) heartbeats_.write(heartbeat_);
  }
  [[nodiscard]] bool relay_says(const std::string& text) {
    for (const auto& received : signs_.take()) {
      if (received.message.service() == "relay") said_ = received.message;
    }
    return said_.state() == msg::HEALTH_DEGRADED && said_.reason().find(text) != std::string::npos;
  }
  void expect_named(const std::string& text) {
    const Time began = services_.clock().now();
    EXPECT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
      step();
      return relay_says(text);
    })) << said_.reason();
    EXPECT_LE(services_.clock().now() - began, seconds{2});
  }

  test::DomainLease domains_{2};
  bus::Bus services_{bus::host_domain(site(), "test")};
  bus::InOrder<msg::ServiceHealth, msg::ServiceHealthPubSubType> signs_{services_.in_order(topic::kServiceHealth)};
  bus::Latest<msg::LinkStatus, msg::LinkStatusPubSubType> link_{services_.latest(topic::kLinkStatus)};
  bus::Bus relay_host_{bus::host_domain(site(), "relay")};
  RelayService relay_{site(), {}, relay_host_};
  bus::Bus other_{as("relay@other")};
  bus::Writer<msg::LinkHeartbeat, msg::LinkHeartbeatPubSubType> heartbeats_{other_.writer(topic::kLinkHeartbeat)};
  msg::LinkHeartbeat heartbeat_;
  msg::ServiceHealth said_;
};

TEST_F(WrongPeersOnTheLink, X1MalformedSamplesAreNamedWithTheirSender) {
  auto raw = other_.raw_writer(info_of(topic::kBaseStatus));
  EXPECT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    raw->write({0x12, 0x34, 0, 0, 1, 2, 3, 4}, {9});
    step();
    return relay_says("X1: malformed samples on base_status from relay@other dropped: unknown encapsulation");
  })) << said_.reason();
}

TEST_F(WrongPeersOnTheLink, X3AWrongTypeIsNamedWithItsWriter) {
  TopicInfo wrong = info_of(topic::kBaseStatus);
  wrong.make_type = info_of(topic::kSession).make_type;
  const auto raw = other_.raw_writer(wrong);
  expect_named("X3: wrong type on base_status: relay@other writes tandem::msg::SessionState");
}

TEST_F(WrongPeersOnTheLink, X6AnotherHostOfOurNameIsNamedAndNoPeer) {
  beat("laptop1", "robot", contract_hash());
  expect_named("X6: another host on the link is called laptop1 too");
  EXPECT_FALSE(link_.newest()->message.up());
}

TEST_F(WrongPeersOnTheLink, X5ASecondLaptopIsNamedAndNoPeer) {
  beat("laptop2", "laptop", contract_hash());
  expect_named("X5: host laptop2 on the link is a laptop of robot1 too");
  EXPECT_FALSE(link_.newest()->message.up());
}

TEST_F(WrongPeersOnTheLink, X6TwoRobotsOfOneTeamAreNamedAndNeitherIsThePeer) {
  beat("robot1", "robot", contract_hash());
  ASSERT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    step();
    return link_.newest() && link_.newest()->message.up();
  }));
  const auto both_beat = [&] {
    beat(heartbeat_.host() == "robot1" ? "robot2" : "robot1", "robot", contract_hash());
    step();
  };
  EXPECT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    both_beat();
    return relay_says("X6: hosts robot1 and robot2 on the link are both a robot of robot1: end one") &&
           !link_.newest()->message.up();
  })) << said_.reason();

  beat("robot2", "robot", contract_hash());
  EXPECT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    step();
    return link_.newest()->message.up() && link_.newest()->message.peer() == "robot2";
  }));
}

TEST_F(WrongPeersOnTheLink, X7NothingComesInFromAHostOfAnotherVersionAndTheLinkIsDown) {
  auto status = other_.writer(topic::kBaseStatus);
  auto here = services_.in_order(topic::kBaseStatus);
  beat("robot1", "robot", "0123456789abcdef");
  expect_named("X7: host robot1 runs another version: its contract is 0123456789abcdef, ours " + contract_hash());
  EXPECT_FALSE(link_.newest()->message.up());
  ASSERT_TRUE(bus::wait_until(other_, seconds{10}, [&] { return status.raw().matched_readers() == 1; }));
  msg::BaseStatus message;
  message.robot("robot1");
  message.battery_v(11.0);
  status.write(message);
  ASSERT_TRUE(status.raw().wait_for_acknowledgments(seconds{10}));

  // Once it runs our version its next state comes in, and the one before never did.
  beat("robot1", "robot", contract_hash());
  ASSERT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    step();
    return link_.newest()->message.up();
  }));
  message.battery_v(12.0);
  std::vector<double> batteries;
  EXPECT_TRUE(bus::wait_until(services_, seconds{10}, [&] {
    step();
    status.write(message);
    for (const auto& received : here.take()) batteries.push_back(received.message.battery_v());
    return !batteries.empty();
  }));
  for (const double battery : batteries) EXPECT_EQ(battery, 12.0);
}

}  // namespace
}  // namespace tandem
