// Relays find each other in every way of discovery, over airs that carry multicast and airs that do not.
#include <gtest/gtest.h>

#include <set>

#include "tests/network/relayed_host.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

/// A robot and two laptops of its team.
class ThreeHosts {
 public:
  ThreeHosts(RelayOptions options, const Conditions& conditions) {
    lab_.set_all(conditions);
    options.host_domain = domains_[0];
    options.link_domain = domains_[1];
    for (const std::string name : {"robot", "laptop", "second"}) {
      options.role = name == "robot" ? "robot" : "laptop";
      hosts_.push_back(std::make_unique<RelayedHost>(lab_.host(name), options));
    }
  }

  /// True when the pose of the robot reaches both laptops, and what they send reaches the robot.
  bool all_are_heard() {
    auto pose_out = hosts_[0]->bus().writer(topic::kRobotPose);
    auto first_in = hosts_[1]->bus().latest(topic::kRobotPose);
    auto second_in = hosts_[2]->bus().latest(topic::kRobotPose);
    auto health_in = hosts_[0]->bus().latest(topic::kServiceHealth);
    return bus::wait_until(hosts_[0]->bus(), seconds{30}, [&] {
      msg::RobotPose pose;
      pose.robot("robot1");
      pose.stamp_ns(to_stamp_ns(hosts_[0]->bus().clock().now()));
      pose_out.write(pose);
      std::set<std::string> heard;
      for (const auto& health : health_in.each()) heard.insert(health.message.host());
      return first_in.newest() && second_in.newest() && heard.contains("laptop") && heard.contains("second");
    });
  }

 private:
  DomainLease domains_{2};
  Laboratory lab_{{"robot", "laptop", "second"}};
  std::vector<std::unique_ptr<RelayedHost>> hosts_;
};

const std::vector<std::string> kEveryone{"10.66.0.1", "10.66.0.2", "10.66.0.3"};
const Conditions kWithoutMulticast{.multicast = false};

TEST(DiscoveryOverTheAir, MulticastNeedsNoNames) {
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE((ThreeHosts{{.link = {.discovery = "multicast"}}, {}}.all_are_heard()));
}

TEST(DiscoveryOverTheAir, AutoNeedsNoNamesWhereMulticastWorks) {
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE((ThreeHosts{{.link = {.discovery = "auto"}}, {}}.all_are_heard()));
}

TEST(DiscoveryOverTheAir, AutoNeedsNoMulticastWhereNamesAreGiven) {
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE((ThreeHosts{{.link = {.discovery = "auto", .peers = kEveryone}}, kWithoutMulticast}.all_are_heard()));
}

TEST(DiscoveryOverTheAir, PeersFindEachOtherByUnicastAlone) {
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE((ThreeHosts{{.link = {.discovery = "peers", .peers = kEveryone}}, kWithoutMulticast}.all_are_heard()));
}

TEST(DiscoveryOverTheAir, AServerIntroducesThem) {
  TANDEM_NEEDS_LABORATORY();
  EXPECT_TRUE(
      (ThreeHosts{{.link = {.discovery = "server", .servers = {"10.66.0.1"}}}, kWithoutMulticast}.all_are_heard()));
}

TEST(DiscoveryOverTheAir, TwoServersIntroduceThem) {
  TANDEM_NEEDS_LABORATORY();
  const RelayOptions options{.link = {.discovery = "server", .servers = {"10.66.0.1", "10.66.0.2"}}};
  EXPECT_TRUE((ThreeHosts{options, kWithoutMulticast}.all_are_heard()));
}

}  // namespace
}  // namespace tandem::test
