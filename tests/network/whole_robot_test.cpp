// The whole robot side, all its services as processes on simulated hardware, and what the link can do to it: nothing
// ends, nothing grows, and it goes on afterwards. (Five minutes without Wi-Fi: `./run bench network`.)
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "tests/network/attacker.hpp"
#include "tests/network/team_on_the_air.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/process_use.hpp"

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr double kTurning_mps = 0.15;
/// A service that kept a kilobyte of every datagram of one kind, at one port, would have grown by 1 MB. What the
/// robot's services grow by themselves in these tests is 0.3 MB at most.
constexpr double kMostGrowth_MB = 1.0;

class WholeRobot : public ::testing::Test {
 protected:
  /// A team whose robot drives, without a person, so that its search takes longer than the test.
  bool drives() {
    lab_.emplace(std::vector<std::string>{"robot1", "laptop1", "intruder"});
    auto options = team_on(*lab_, "robot1", "laptop1");
    options.scenario = "brl";
    options.play = true;
    options.robot_domain = domains_[0];
    options.laptop_domain = domains_[1];
    options.link_domain = domains_[2];
    team_.emplace(options);
    if (!team_->run_until(seconds{90}, [&] { return team_->wheel_speed_mps().value_or(0.0) > kTurning_mps; })) {
      return false;
    }
    lead(seconds{5});  // what grows at the beginning has grown
    before_MB_ = memory_MB();
    return true;
  }

  void lead(Duration duration) {
    const SteadyClock clock;
    const Time end = clock.now() + duration;
    std::ignore = team_->run_until(duration + seconds{10}, [&] { return clock.now() >= end; });
  }

  /// A pose that was sent from now on reaches the laptop, and a plan the robot.
  bool is_heard_both_ways(Duration timeout) {
    auto poses = team_->laptop_bus().in_order(topic::kRobotPose);
    auto plans = team_->robot_bus().in_order(topic::kTeamPlan);
    const auto began_ns = to_stamp_ns(team_->laptop_bus().clock().now());
    const auto is_new = [&](const auto& one) { return one.message.stamp_ns() >= began_ns; };
    bool pose = false;
    bool plan = false;
    return team_->run_until(timeout, [&] {
      for (const auto& one : poses.take()) pose = pose || is_new(one);
      for (const auto& one : plans.take()) plan = plan || is_new(one);
      return pose && plan;
    });
  }

  std::map<std::string, double> memory_MB() const {
    std::map<std::string, double> uses;
    for (const auto& service : team_->services("robot1")) {
      uses[service] = memory_MB_of(*team_->process("robot1", service));
    }
    return uses;
  }

  void expect_unharmed() {
    EXPECT_EQ(team_->unexpected_ends(), "");
    for (const auto& [service, MB] : memory_MB()) {
      EXPECT_LT(MB - before_MB_.at(service), kMostGrowth_MB) << service;
      RecordProperty("growth_MB_" + service, std::to_string(MB - before_MB_.at(service)));
    }
  }

  DomainLease domains_{3};
  std::optional<Laboratory> lab_;
  std::optional<SimulatedTeam> team_;
  std::map<std::string, double> before_MB_;
};

TEST_F(WholeRobot, SurvivesThatTheWiFiIsGone) {
  TANDEM_NEEDS_LABORATORY();
  ASSERT_TRUE(drives()) << team_->last_words();

  lab_->set_all({.out = true});
  lead(seconds{20});  // four leases: every participant of the other side is forgotten
  lab_->set_all({});

  EXPECT_TRUE(is_heard_both_ways(seconds{20})) << team_->last_words();
  expect_unharmed();
}

TEST_F(WholeRobot, SurvivesANewAddress) {
  TANDEM_NEEDS_LABORATORY();
  ASSERT_TRUE(drives()) << team_->last_words();

  for (const char* address : {"10.66.0.22", "10.66.0.23"}) {
    lab_->host("robot1").change_address(address);
    EXPECT_TRUE(is_heard_both_ways(seconds{20})) << team_->last_words();
  }
  expect_unharmed();
}

TEST_F(WholeRobot, SurvivesAThousandHostileDatagramsOfEachKindAtEveryPort) {
  TANDEM_NEEDS_LABORATORY();
  constexpr std::size_t kOfEachKind = 1'000;
  constexpr std::size_t kAtOnce = 25;  // more, and the test measures socket buffers
  ASSERT_TRUE(drives()) << team_->last_words();
  const Sniffer sniffer{lab_->host("robot1")};
  const Attacker attacker{lab_->host("intruder")};
  const auto seen = sniffer.listen(100);
  ASSERT_GE(seen.size(), 20U);
  const auto ports = open_ports(lab_->host("robot1"));
  ASSERT_GE(ports.size(), 3U);  // of the relay: the group's, and two of its own

  Rng rng{11};
  for (const auto make : {noise, truncated_header, mutated}) {
    for (std::size_t i = 0; i < kOfEachKind; ++i) {
      const Datagram datagram = make(seen[rng.bits() % seen.size()], rng);
      for (const std::uint16_t port : ports) attacker.send(datagram, lab_->host("robot1").address(), port);
      if (i % kAtOnce == 0) lead(milliseconds{20});
    }
    // What forges our participants may interrupt the link, and stops the robot (docs/network.md, X2).
    if (make != mutated) {
      EXPECT_TRUE(is_heard_both_ways(seconds{30})) << team_->last_words();
    }
  }
  expect_unharmed();
}

}  // namespace
}  // namespace tandem::test
