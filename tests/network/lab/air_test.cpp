#include "tests/network/lab/air.hpp"

#include <gtest/gtest.h>

namespace tandem::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const MacAddress kRobot{2, 0, 0, 0, 0, 1};
const MacAddress kLaptop{2, 0, 0, 0, 0, 2};
const MacAddress kPhone{2, 0, 0, 0, 0, 3};
const MacAddress kGroup{1, 0, 0x5E, 0, 0, 1};
const MacAddress kEveryone{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF};
constexpr std::size_t kRobotPort = 0;
constexpr std::size_t kLaptopPort = 1;

Frame frame_to(const MacAddress& destination, std::size_t size = 100) {
  Frame frame(size, 0);
  std::copy(destination.begin(), destination.end(), frame.begin());
  frame[12] = 0x08;  // IPv4
  return frame;
}

Air air_of_three(std::uint64_t seed = 1) {
  Air air{seed};
  air.add_host(kRobot);
  air.add_host(kLaptop);
  air.add_host(kPhone);
  return air;
}

Time at_ms(int value) {
  return Time{milliseconds{value}};
}

/// How many of `count` frames from the robot reach the laptop, one a millisecond.
std::size_t arrived(Air& air, int count, int first_ms = 0) {
  std::size_t sum = 0;
  for (int i = 0; i < count; ++i) sum += air.carry(frame_to(kLaptop), kRobotPort, at_ms(first_ms + i)).size();
  return sum;
}

TEST(Air, CarriesAFrameAtOnceToWhomItIsMeantFor) {
  Air air = air_of_three();
  const auto deliveries = air.carry(frame_to(kLaptop), kRobotPort, at_ms(5));
  ASSERT_EQ(deliveries.size(), 1U);
  EXPECT_EQ(deliveries[0].to, kLaptopPort);
  EXPECT_EQ(deliveries[0].at, at_ms(5));
}

TEST(Air, CarriesABroadcastToAllOthers) {
  Air air = air_of_three();
  EXPECT_EQ(air.carry(frame_to(kEveryone), kRobotPort, at_ms(0)).size(), 2U);
}

TEST(Air, CarriesOnlyIpv4AndArp) {
  Air air = air_of_three();
  Frame arp = frame_to(kEveryone);
  arp[13] = 0x06;
  Frame ipv6 = frame_to(kEveryone);
  ipv6[12] = 0x86;
  ipv6[13] = 0xDD;
  EXPECT_EQ(air.carry(arp, kRobotPort, at_ms(0)).size(), 2U);
  EXPECT_TRUE(air.carry(ipv6, kRobotPort, at_ms(0)).empty());
  EXPECT_TRUE(air.carry(Frame(3, 0), kRobotPort, at_ms(0)).empty());
}

TEST(Air, LosesTheShareItIsTold) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.loss = 0.2});
  EXPECT_NEAR(static_cast<double>(arrived(air, 10'000)), 8'000.0, 160.0);  // four standard deviations
}

TEST(Air, LosesTheSameFramesForTheSameSeed) {
  Air first = air_of_three(7);
  Air second = air_of_three(7);
  Air other = air_of_three(8);
  bool differs = false;
  for (auto* air : {&first, &second, &other}) air->set(kLaptopPort, {.loss = 0.5});
  for (int i = 0; i < 100; ++i) {
    const bool arrives = !first.carry(frame_to(kLaptop), kRobotPort, at_ms(i)).empty();
    EXPECT_EQ(arrives, !second.carry(frame_to(kLaptop), kRobotPort, at_ms(i)).empty());
    differs = differs || arrives != !other.carry(frame_to(kLaptop), kRobotPort, at_ms(i)).empty();
  }
  EXPECT_TRUE(differs);
}

TEST(Air, IsDeadAtTheStartOfEachPeriodOfBursts) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.dead_for = milliseconds{300}, .dead_every = seconds{1}});
  EXPECT_EQ(arrived(air, 300, 0), 0U);
  EXPECT_EQ(arrived(air, 700, 300), 700U);
  EXPECT_EQ(arrived(air, 300, 1000), 0U);
}

TEST(Air, AnOutageIsOfOneDirection) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.out = true});
  EXPECT_EQ(arrived(air, 10), 0U);
  EXPECT_EQ(air.carry(frame_to(kRobot), kLaptopPort, at_ms(10)).size(), 1U);
}

TEST(Air, CanDropMulticastAlone) {
  Air air = air_of_three();
  for (std::size_t host = 0; host < 3; ++host) air.set(host, {.multicast = false});
  EXPECT_TRUE(air.carry(frame_to(kGroup), kRobotPort, at_ms(0)).empty());
  EXPECT_EQ(air.carry(frame_to(kEveryone), kRobotPort, at_ms(0)).size(), 2U);
  EXPECT_EQ(air.carry(frame_to(kLaptop), kRobotPort, at_ms(0)).size(), 1U);
}

TEST(Air, QueuesAtItsRateAndLosesWhatDoesNotFitInTheQueue) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.rate_bps = 8'000.0, .queue = milliseconds{250}});  // 100 bytes: 100 ms
  const Frame frame = frame_to(kLaptop, 100);
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(0)).at(0).at, at_ms(100));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(0)).at(0).at, at_ms(200));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(0)).at(0).at, at_ms(300));
  EXPECT_TRUE(air.carry(frame, kRobotPort, at_ms(0)).empty());  // it would wait 300 ms
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(500)).at(0).at, at_ms(600));
}

TEST(Air, ABurstPassesAtOnceAfterAPause) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.rate_bps = 8'000.0, .burst_bytes = 200.0});  // 100 bytes: 100 ms
  const Frame frame = frame_to(kLaptop, 100);
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1000)).at(0).at, at_ms(1000));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1000)).at(0).at, at_ms(1000));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1000)).at(0).at, at_ms(1100));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1300)).at(0).at, at_ms(1300));  // 200 ms of pause: as much again
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1300)).at(0).at, at_ms(1300));
  EXPECT_EQ(air.carry(frame, kRobotPort, at_ms(1300)).at(0).at, at_ms(1400));
}

TEST(Air, JitterKeepsTheOrder) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.delay = milliseconds{10}, .jitter = milliseconds{30}});
  Time last{};
  for (int i = 0; i < 200; ++i) {
    const Time at = air.carry(frame_to(kLaptop), kRobotPort, at_ms(i)).at(0).at;
    EXPECT_GE(at, last);
    EXPECT_GE(at, at_ms(i + 10));
    EXPECT_LE(at, at_ms(i + 40));
    last = at;
  }
}

TEST(Air, ReordersWhatItHoldsBack) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.reordered = 1.0, .held_back = milliseconds{20}});
  const Time first = air.carry(frame_to(kLaptop), kRobotPort, at_ms(0)).at(0).at;
  air.set(kLaptopPort, {});
  const Time second = air.carry(frame_to(kLaptop), kRobotPort, at_ms(1)).at(0).at;
  EXPECT_EQ(first, at_ms(20));
  EXPECT_EQ(second, at_ms(1));
}

TEST(Air, Duplicates) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.duplicated = 1.0});
  EXPECT_EQ(air.carry(frame_to(kLaptop), kRobotPort, at_ms(0)).size(), 2U);
}

TEST(Air, CountsFragments) {
  Air air = air_of_three();
  Frame first = frame_to(kLaptop);
  first[20] = 0x20;  // more fragments
  Frame last = frame_to(kLaptop);
  last[21] = 0xB9;  // 1480 bytes from the start
  Frame whole = frame_to(kLaptop);
  whole[20] = 0x40;  // must not be fragmented
  for (const Frame& frame : {first, last, whole}) (void)air.carry(frame, kRobotPort, at_ms(0));
  EXPECT_EQ(air.count(kRobotPort).fragments_sent, 2U);
}

TEST(Air, CountsWhatWasSentAndWhatArrived) {
  Air air = air_of_three();
  air.set(kLaptopPort, {.out = true});
  arrived(air, 3);
  air.set(kLaptopPort, {});
  arrived(air, 2, 10);
  EXPECT_EQ(air.count(kRobotPort).frames_sent, 5U);
  EXPECT_EQ(air.count(kRobotPort).bytes_sent, 500U);
  EXPECT_EQ(air.count(kLaptopPort).frames_received, 2U);
  EXPECT_EQ(air.count(kLaptopPort).bytes_received, 200U);
}

}  // namespace
}  // namespace tandem::test
