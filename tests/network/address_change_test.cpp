// The robot roams: its address changes, its interface goes down and comes back. No process is restarted.
#include <gtest/gtest.h>

#include <optional>

#include "tests/network/two_hosts.hpp"

namespace tandem::test {
namespace {

using std::chrono::seconds;

TEST(AddressChange, PosesGetThroughFromTheNewAddress) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
  hosts.lab().host("robot").change_address("10.66.0.22");
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
}

TEST(AddressChange, WorksWithoutMulticast) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts{{}, {.multicast = false}};
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
  hosts.lab().host("robot").change_address("10.66.0.22");
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
  hosts.lab().host("robot").change_address("10.66.0.23");
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
}

TEST(AddressChange, StatesOfBothHostsAreCurrentAgain) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  auto status = hosts.robot().bus().writer(topic::kBaseStatus);
  auto session = hosts.laptop().bus().writer(topic::kSession);
  auto status_reader = hosts.laptop().bus().latest(topic::kBaseStatus);
  auto session_reader = hosts.robot().bus().latest(topic::kSession);
  const auto say = [&](const std::string& code, double battery) {
    msg::BaseStatus base;
    base.robot("robot1");
    base.battery_v(battery);
    status.write(base);
    msg::SessionState state;
    state.code(code);
    session.write(state);
  };
  const auto known = [&](const std::string& code, double battery) {
    return bus::wait_until(hosts.laptop().bus(), seconds{20}, [&] {
      const auto base = status_reader.newest();
      const auto state = session_reader.newest();
      return base && state && base->message.battery_v() == battery && state->message.code() == code;
    });
  };
  say("first", 12.0);
  ASSERT_TRUE(known("first", 12.0));

  hosts.lab().host("robot").change_address("10.66.0.22");
  say("second", 11.0);  // once each, while the link is away
  EXPECT_TRUE(known("second", 11.0));
}

TEST(AddressChange, WhatEndedMeanwhileEndsOnTheOtherHostToo) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  std::optional writer{hosts.laptop().bus().writer(topic::kSession)};
  auto reader = hosts.robot().bus().latest(topic::kSession);
  msg::SessionState state;
  state.code("first");
  writer->write(state);
  auto link = hosts.robot().bus().latest(topic::kLinkStatus);
  const auto link_is = [&](bool up) {
    return bus::wait_until(hosts.robot().bus(), seconds{20}, [&] {
      const auto status = link.newest();
      return status && status->message.up() == up;
    });
  };
  ASSERT_TRUE(bus::wait_until(hosts.robot().bus(), seconds{20}, [&] { return reader.newest().has_value(); }));
  ASSERT_TRUE(link_is(true));

  // The robot joins its link anew while nothing arrives; whoever could tell it that the session ended is gone by then.
  hosts.lab().set_all({.out = true});
  hosts.lab().host("robot").change_address("10.66.0.22");
  ASSERT_TRUE(link_is(false));
  writer.reset();
  hosts.laptop().restart_relay();
  hosts.lab().set_all({});
  EXPECT_TRUE(bus::wait_until(hosts.robot().bus(), seconds{40}, [&] { return !reader.newest(); }));
}

TEST(AddressChange, TheRelayWaitsForAnAddressAndSurvivesItsLoss) {
  TANDEM_NEEDS_LABORATORY();
  TwoHosts hosts;
  ASSERT_TRUE(poses_get_through(hosts, seconds{20}));
  hosts.lab().host("robot").interface_down();
  EXPECT_FALSE(poses_get_through(hosts, seconds{7}));
  hosts.robot().restart_relay();
  hosts.lab().host("robot").interface_up();
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));

  hosts.lab().host("robot").interface_down();
  EXPECT_FALSE(poses_get_through(hosts, seconds{1}));
  hosts.lab().host("robot").interface_up();
  EXPECT_TRUE(poses_get_through(hosts, seconds{20}));
}

}  // namespace
}  // namespace tandem::test
