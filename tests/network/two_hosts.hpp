#pragma once

#include <memory>

#include "tests/network/relayed_host.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem::test {

/// A robot that publishes its base's status and its pose, and a laptop that reads both.
class TwoHosts {
 public:
  /// `options` of the robot; the laptop's are the same but for the role. Peers are each other's address.
  /// `others` are further hosts on the same air, with nothing on them.
  explicit TwoHosts(RelayOptions options = {}, const Conditions& conditions = {},
                    const std::vector<std::string>& others = {})
      : lab_(with(others)) {
    lab_.set_all(conditions);
    options.host_domain = domains_[0];
    options.link_domain = domains_[1];
    options.role = "robot";
    options.link.peers = {lab_.host("laptop").address()};
    robot_ = std::make_unique<RelayedHost>(lab_.host("robot"), options);
    options.role = "laptop";
    options.link.peers = {lab_.host("robot").address()};
    laptop_ = std::make_unique<RelayedHost>(lab_.host("laptop"), options);
  }

  [[nodiscard]] Laboratory& lab() { return lab_; }
  [[nodiscard]] RelayedHost& robot() { return *robot_; }
  [[nodiscard]] RelayedHost& laptop() { return *laptop_; }
  [[nodiscard]] int host_domain() const { return domains_[0]; }
  [[nodiscard]] int link_domain() const { return domains_[1]; }

 private:
  [[nodiscard]] static std::vector<std::string> with(const std::vector<std::string>& others) {
    std::vector<std::string> hosts{"robot", "laptop"};
    hosts.insert(hosts.end(), others.begin(), others.end());
    return hosts;
  }

  DomainLease domains_{2};  // a host domain is the same on both: each has a loopback interface of its own
  Laboratory lab_;
  std::unique_ptr<RelayedHost> robot_;
  std::unique_ptr<RelayedHost> laptop_;
};

/// Sends a pose each 50 ms until the laptop has heard one that was sent after the call. False after `timeout`.
inline bool poses_get_through(TwoHosts& hosts, Duration timeout) {
  auto writer = hosts.robot().bus().writer(topic::kRobotPose);
  auto reader = hosts.laptop().bus().latest(topic::kRobotPose);
  const Time began = hosts.robot().bus().clock().now();
  return bus::wait_until(hosts.laptop().bus(), timeout, [&] {
    msg::RobotPose pose;
    pose.robot("robot1");
    pose.stamp_ns(to_stamp_ns(hosts.robot().bus().clock().now()));
    writer.write(pose);
    const auto newest = reader.newest();
    return newest && newest->message.stamp_ns() >= to_stamp_ns(began);
  });
}

}  // namespace tandem::test
