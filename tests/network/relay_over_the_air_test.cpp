// Two relays as processes, and the air between them at its worst. How soon things happen is measured by
// `./run bench network`; here they must happen.
#include <gtest/gtest.h>

#include <set>

#include "services/bus/events.hpp"
#include "tests/network/two_hosts.hpp"

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Conditions kLossy{.loss = 0.2, .dead_for = milliseconds{300}, .dead_every = seconds{1}};

/// Waits until the laptop knows `state_of_robot` of the robot's base.
bool state_gets_through(TwoHosts& hosts, Duration timeout) {
  auto writer = hosts.robot().bus().writer(topic::kBaseStatus);
  auto reader = hosts.laptop().bus().latest(topic::kBaseStatus);
  msg::BaseStatus status;
  status.robot("robot1");
  writer.write(status);  // once: it is a State
  return bus::wait_until(hosts.laptop().bus(), timeout, [&] { return reader.newest().has_value(); });
}

TEST(RelayOverTheAir, FirstDataArriveAfterTheStart) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  EXPECT_TRUE(state_gets_through(hosts, seconds{20}));
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
}

TEST(RelayOverTheAir, FirstDataArriveThroughLossAndBursts) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts{{}, kLossy};
  EXPECT_TRUE(state_gets_through(hosts, seconds{60}));
  EXPECT_TRUE(poses_get_through(hosts, seconds{60}));
}

TEST(RelayOverTheAir, AutoWorksWhereTheAirDropsMulticast) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts{{.link = {.discovery = "auto"}}, {.multicast = false}};
  EXPECT_TRUE(state_gets_through(hosts, seconds{20}));
}

TEST(RelayOverTheAir, DataGoOnAfterAnOutageLongerThanTheLease) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  auto link = hosts.laptop().bus().latest(topic::kLinkStatus);
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));

  hosts.lab().set_all({.out = true});
  EXPECT_FALSE(poses_get_through(hosts, seconds{8}));  // the lease is 5 s
  EXPECT_FALSE(link.newest()->message.up());
  hosts.lab().set_all({});
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
  EXPECT_TRUE(state_gets_through(hosts, seconds{20}));
}

TEST(RelayOverTheAir, AnOutageOfOneDirectionIsNamedByTheSideThatStillHears) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  auto robot_link = hosts.robot().bus().latest(topic::kLinkStatus);
  auto laptop_link = hosts.laptop().bus().latest(topic::kLinkStatus);
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));

  hosts.lab().set("laptop", {.out = true});
  EXPECT_TRUE(bus::wait_until(hosts.robot().bus(), seconds{20}, [&] {
    const auto robot = robot_link.newest();
    const auto laptop = laptop_link.newest();
    return robot && laptop && robot->message.one_way() && !laptop->message.up();
  }));
}

TEST(RelayOverTheAir, EveryMessageIsAppliedExactlyOnce) {
  TANDEM_NEEDS_LABORATORY();
  Conditions air = kLossy;
  air.reordered = 0.1;
  air.duplicated = 0.1;
  TwoHosts hosts{{}, air};
  bus::EventSender sender{hosts.laptop().bus(), topic::kPoseHint, seconds{60}};
  bus::EventReceiver receiver{hosts.robot().bus(), topic::kPoseHint, "localization"};
  std::vector<std::string> sent;
  std::multiset<std::string> applied;
  for (int i = 0; i < 20; ++i) {
    msg::PoseHint hint;
    hint.robot("robot1");
    hint.id(bus::new_event_id("test", hosts.laptop().bus().clock()));
    sent.push_back(hint.id());
    sender.send(hint);
  }
  EXPECT_TRUE(bus::wait_until(hosts.robot().bus(), seconds{60}, [&] {
    sender.step();
    for (const auto& hint : receiver.take()) {
      applied.insert(hint.id());
      receiver.applied(hint.id());
    }
    return std::all_of(sent.begin(), sent.end(),
                       [&](const auto& id) { return sender.outcome(id).state == bus::EventOutcome::State::Applied; });
  }));
  EXPECT_EQ(applied, (std::multiset<std::string>{sent.begin(), sent.end()}));
}

}  // namespace
}  // namespace tandem::test
