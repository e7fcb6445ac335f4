// The whole team as real processes: what must hold when one of them dies, and when two teams share a link.
#include <gtest/gtest.h>

#include "tests/support/domain_lease.hpp"
#include "tests/support/simulated_team.hpp"

namespace tandem::test {
namespace {

using cli::Episode;
using std::chrono::seconds;

constexpr double kTurning_mps = 0.15;
/// From full speed to standstill: 0.5 m/s at 0.6 m/s^2, a control cycle of base and firmware, and what the truth's own
/// rate of 20 Hz adds.
constexpr double kBraking_s = 0.5 / 0.6 + 0.1 + 0.1 + 0.05;

TeamOptions options_in(const DomainLease& domains) {
  TeamOptions options;
  options.scenario = "brl";  // long ways: the robot drives for a while
  options.robot_domain = domains[0];
  options.laptop_domain = domains[1];
  options.link_domain = domains[2];
  return options;
}

bool is_driving(const SimulatedTeam& team) {
  return team.wheel_speed_mps().value_or(0.0) > kTurning_mps;
}

/// Kills `service` while the robot drives; the wheels must stand still within `limit_s` and stay so.
void expect_standstill(const std::string& host, const std::string& service, double limit_s) {
  const DomainLease domains{3};
  SimulatedTeam team{options_in(domains)};
  ASSERT_TRUE(team.run_until(seconds{120}, [&] { return is_driving(team); })) << team.last_words();

  team.kill(host, service);

  EXPECT_LE(team.watch_wheels(seconds{6}).after_s, limit_s) << team.last_words();
}

TEST(Team, TheBaseStopsWhenTheNavigatorDies) {
  expect_standstill("robot1", "navigator", 0.5 + kBraking_s);
}

TEST(Team, TheBaseStopsWhenTheLaserDies) {
  expect_standstill("robot1", "laser", 0.5 + kBraking_s);
}

TEST(Team, TheBaseStopsWhenThePlannerDies) {
  expect_standstill("laptop-of-robot1", "planner", 2.5 + kBraking_s);
}

TEST(Team, TheBaseStopsWhenTheRelayOfTheRobotDies) {
  expect_standstill("robot1", "relay", 1.6 + kBraking_s);
}

TEST(Team, TheBaseStopsWhenTheRelayOfTheLaptopDies) {
  expect_standstill("laptop-of-robot1", "relay", 1.6 + kBraking_s);
}

TEST(Team, ALateJoinerGetsTheMap) {
  const DomainLease domains{3};
  auto options = options_in(domains);
  options.without = {"camera"};
  SimulatedTeam team{options};
  ASSERT_TRUE(team.run_until(seconds{60}, [&] { return team.episode().phase() >= Episode::Phase::Placing; }))
      << team.last_words();

  SiteConfig site;
  site.host_domain = domains[1];
  bus::Bus late{bus::host_domain(site, "late")};
  auto map = late.latest(topic::kMap);
  EXPECT_TRUE(bus::wait_until(late, seconds{10}, [&] { return map.newest().has_value(); }));
}

TEST(Team, AVelocityFromTheLinkNeverMovesTheRobot) {
  const DomainLease domains{3};
  auto options = options_in(domains);
  options.without = {"planner", "camera"};  // nobody else moves it
  SimulatedTeam team{options};
  auto health = team.laptop_bus().latest(topic::kServiceHealth);
  ASSERT_TRUE(team.run_until(seconds{60}, [&] { return team.wheel_speed_mps().has_value() && !health.each().empty(); }))
      << team.last_words();

  bus::DomainOptions link;
  link.kind = bus::DomainOptions::Kind::Link;
  link.domain = domains[2];
  link.participant = "intruder";
  link.partitions = {"robot1"};
  bus::Bus intruder{link};
  auto velocity = intruder.writer(topic::kVelocityCommand);
  msg::VelocityCommand command;
  command.robot("robot1");
  command.commander("navigator");
  command.forward_mps(0.5);
  bool moved = false;
  const Time end = intruder.clock().now() + seconds{5};
  EXPECT_TRUE(team.run_until(seconds{20}, [&] {
    command.stamp_ns(to_stamp_ns(intruder.clock().now()));
    command.sequence_number(command.sequence_number() + 1);
    velocity.write(command);
    moved = moved || team.wheel_speed_mps().value_or(0.0) > 0.001;
    return intruder.clock().now() > end;
  })) << team.last_words();
  EXPECT_FALSE(moved);
  EXPECT_EQ(velocity.raw().matched_readers(), 0);
}

/// Which robots and agents are heard of in a laptop's domain.
class Ear {
 public:
  explicit Ear(bus::Bus& bus)
      : poses_(bus.in_order(topic::kRobotPose)),
        teammates_(bus.in_order(topic::kTeammates)),
        messages_(bus.in_order(topic::kHumanMessage)),
        plans_(bus.in_order(topic::kTeamPlan)) {}
  void listen() {
    for (const auto& pose : poses_.take()) heard_.insert(pose.message.robot());
    for (const auto& teammate : teammates_.take()) heard_.insert(teammate.message.agent());
    for (const auto& message : messages_.take()) heard_.insert(message.message.agent());
    for (const auto& plan : plans_.take()) heard_.insert(plan.message.robot());
  }
  [[nodiscard]] const std::set<std::string>& heard() const { return heard_; }

 private:
  std::set<std::string> heard_;
  bus::InOrder<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  bus::InOrder<msg::TeammateState, msg::TeammateStatePubSubType> teammates_;
  bus::InOrder<msg::HumanMessage, msg::HumanMessagePubSubType> messages_;
  bus::InOrder<msg::TeamPlan, msg::TeamPlanPubSubType> plans_;
};

TEST(Team, TwoRobotsAndTwoPeopleOnOneLinkDoNotMix) {
  const DomainLease domains{5};
  TeamOptions first = options_in(domains);
  first.link_domain = domains[4];
  first.without = {"camera"};
  TeamOptions second = first;
  second.robot = "robot2";
  second.agent = "person2";
  second.seed = 2;
  second.robot_domain = domains[2];
  second.laptop_domain = domains[3];
  SimulatedTeam team1{first};
  SimulatedTeam team2{second};
  Ear ear1{team1.laptop_bus()};
  Ear ear2{team2.laptop_bus()};

  bool both_run = true;
  const auto both_drive_and_are_heard = [&] {
    both_run = team2.run_until(seconds{1}, [] { return true; });
    ear1.listen();
    ear2.listen();
    const bool heard = ear1.heard().size() >= 2 && ear2.heard().size() >= 2;
    return !both_run || (heard && is_driving(team1) && is_driving(team2));
  };
  EXPECT_TRUE(team1.run_until(seconds{180}, both_drive_and_are_heard)) << team1.last_words() << team2.last_words();
  ASSERT_TRUE(both_run) << team2.last_words();
  EXPECT_EQ(ear1.heard(), (std::set<std::string>{"person1", "robot1"}));
  EXPECT_EQ(ear2.heard(), (std::set<std::string>{"person2", "robot2"}));
}

}  // namespace
}  // namespace tandem::test
