#include "services/bus/bus.hpp"

#include <gtest/gtest.h>

#include "tests/support/domain_lease.hpp"

namespace tandem::bus {
namespace {

using std::chrono::seconds;

DomainOptions options_in(int domain, const std::string& name) {
  DomainOptions options;
  options.domain = domain;
  options.participant = name;
  return options;
}

msg::TeammateState teammate(const std::string& agent, double x) {
  msg::TeammateState state;
  state.agent(agent);
  state.map_from_agent().x(x);
  return state;
}

TEST(Bus, DeliversAStreamToAReaderOfAnotherParticipant) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  Bus receiver{options_in(domain[0], "receiver")};
  auto writer = sender.writer(topic::kOdometry);
  auto reader = receiver.in_order(topic::kOdometry);
  ASSERT_TRUE(wait_until(receiver, seconds{10}, [&] { return reader.matched_writers() == 1; }));
  ASSERT_TRUE(wait_until(sender, seconds{10}, [&] { return writer.raw().matched_readers() == 1; }));

  for (int i = 0; i < 5; ++i) {
    msg::Odometry odometry;
    odometry.robot("robot1");
    odometry.stamp_ns(i);
    EXPECT_TRUE(writer.write(odometry));
  }

  std::vector<std::int64_t> stamps;
  EXPECT_TRUE(wait_until(receiver, seconds{10}, [&] {
    for (const auto& received : reader.take()) stamps.push_back(received.message.stamp_ns());
    return stamps.size() == 5;
  }));
  EXPECT_EQ(stamps, (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
}

TEST(Bus, ATimeThatFastDdsCannotCarryDoesNotHoldUpTheWriter) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  auto writer = sender.writer(topic::kTeammates);
  const msg::TeammateState state = teammate("person1", 1.0);
  const auto payload = encode<msg::TeammateStatePubSubType>(state);
  const auto key = key_of<msg::TeammateStatePubSubType>(state);
  // What a sample has that came without a time, less an offset between clocks; and a time after 2038.
  EXPECT_TRUE(writer.raw().write(payload, key, from_stamp_ns(-1'500'000'000)));
  EXPECT_TRUE(writer.raw().write(payload, key, Time{seconds{3'000'000'000}}));
}

TEST(Bus, ALateJoinerGetsTheStateOfEveryInstance) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  auto writer = sender.writer(topic::kTeammates);
  EXPECT_TRUE(writer.write(teammate("person1", 1.0)));
  EXPECT_TRUE(writer.write(teammate("person1", 2.0)));
  EXPECT_TRUE(writer.write(teammate("person2", 3.0)));

  Bus late{options_in(domain[0], "late")};
  auto reader = late.latest(topic::kTeammates);
  ASSERT_TRUE(wait_until(late, seconds{10}, [&] { return reader.each().size() == 2; }));
  double sum = 0.0;
  for (const auto& received : reader.each()) sum += received.message.map_from_agent().x();
  EXPECT_DOUBLE_EQ(sum, 5.0);  // the newest of person1, and person2
}

TEST(Bus, AnInstanceIsOneWhateverOthersAreCalled) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  Bus receiver{options_in(domain[0], "receiver")};
  auto writer = sender.writer(topic::kServiceHealth);
  auto reader = receiver.latest(topic::kServiceHealth);
  const auto tell = [&](const std::string& host, const std::string& service, std::int64_t stamp_ns) {
    msg::ServiceHealth health;
    health.host(host);
    health.service(service);
    health.stamp_ns(stamp_ns);
    writer.write(health);
  };
  // Hosts and services of any length, so that what lies between them in a key differs.
  const std::vector<std::pair<std::string, std::string>> all{
      {"laptop-of-robot1", "gateway"}, {"robot1", "base"}, {"a-host-of-a-long-name-indeed", "localization"}};
  constexpr std::int64_t kRounds = 4;
  for (std::int64_t round = 1; round <= kRounds; ++round) {
    for (const auto& [host, service] : all) tell(host, service, round);
    ASSERT_TRUE(wait_until(receiver, seconds{10}, [&] {
      const auto newest = reader.newest();
      return newest && newest->message.host() == all.back().first && newest->message.stamp_ns() == round;
    }));
  }
  EXPECT_EQ(reader.each().size(), all.size());
}

TEST(Bus, ADisposedInstanceIsForgotten) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  Bus receiver{options_in(domain[0], "receiver")};
  auto writer = sender.writer(topic::kTeammates);
  auto reader = receiver.latest(topic::kTeammates);
  EXPECT_TRUE(writer.write(teammate("person1", 1.0)));
  ASSERT_TRUE(wait_until(receiver, seconds{10}, [&] { return reader.each().size() == 1; }));

  EXPECT_TRUE(writer.dispose(teammate("person1", 0.0)));
  EXPECT_TRUE(wait_until(receiver, seconds{10}, [&] { return reader.each().empty(); }));
}

TEST(Bus, MalformedSamplesOfAKeyedTopicEndNeitherReaderNorProcess) {
  const test::DomainLease domain{1};
  Bus sender{options_in(domain[0], "sender")};
  Bus receiver{options_in(domain[0], "receiver")};
  auto raw = sender.raw_writer(info_of(topic::kTeammates));
  auto good = sender.writer(topic::kTeammates);
  auto reader = receiver.in_order(topic::kTeammates);
  const std::vector<std::vector<std::uint8_t>> bad{
      {0x12, 0x34, 0, 0, 1, 2, 3, 4},                   // unknown encapsulation
      {0, 1, 0, 0, 1, 2, 3, 4},                         // cut short
      {0, 1, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 1, 2, 3, 4}  // a string of four gigabytes
  };

  std::size_t whole = 0;
  EXPECT_TRUE(wait_until(receiver, seconds{20}, [&] {
    for (const auto& payload : bad) raw->write(payload, {9});
    good.write(teammate("person1", 1.0));
    whole += reader.take().size();
    return whole >= 5 && reader.undecodable() >= 3;
  }));
}

TEST(Bus, PartitionsKeepTeamsApartOnOneLink) {
  const test::DomainLease domain{1};
  auto team1 = options_in(domain[0], "team1");
  team1.kind = DomainOptions::Kind::Link;
  team1.partitions = {"robot1"};
  auto team2 = team1;
  team2.partitions = {"robot2"};
  Bus writer_of_1{team1};
  Bus reader_of_1{team1};
  Bus reader_of_2{team2};
  auto writer = writer_of_1.writer(topic::kSession);
  auto own = reader_of_1.latest(topic::kSession);
  auto other = reader_of_2.latest(topic::kSession);
  EXPECT_TRUE(writer.write(msg::SessionState{}));

  EXPECT_TRUE(wait_until(reader_of_1, seconds{10}, [&] { return own.newest().has_value(); }));
  EXPECT_FALSE(other.newest());
  EXPECT_EQ(other.matched_writers(), 0);
}

TEST(Bus, ALargeStateCrossesTheLinkInSmallDatagrams) {
  const test::DomainLease domain{1};
  auto link = options_in(domain[0], "link");
  link.kind = DomainOptions::Kind::Link;
  Bus sender{link};
  Bus receiver{link};
  auto writer = sender.writer(topic::kMap);
  auto reader = receiver.latest(topic::kMap);
  msg::OccupancyGrid grid;
  grid.map_id("big");
  grid.cells(std::vector<std::uint8_t>(300'000, 7));
  EXPECT_TRUE(writer.write(grid));

  ASSERT_TRUE(wait_until(receiver, seconds{20}, [&] { return reader.newest().has_value(); }));
  EXPECT_EQ(reader.newest()->message.cells().size(), 300'000U);
}

TEST(Bus, AnAddressThatIsNotOursIsRefusedWithARemedy) {
  const test::DomainLease domain{1};
  auto options = options_in(domain[0], "nowhere");
  options.address = "203.0.113.7";
  try {
    Bus bus{options};
    auto writer = bus.writer(topic::kSession);
    FAIL() << "joined a domain at an address of another machine";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string{error.what()}.find("203.0.113.7"), std::string::npos);
  }
}

}  // namespace
}  // namespace tandem::bus
