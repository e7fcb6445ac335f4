#include "services/simulator/core/base_line.hpp"

#include <gtest/gtest.h>

#include "robot/pioneer/core/sip.hpp"

namespace tandem::simulator {
namespace {

using pioneer::Bytes;

constexpr Time kStart{std::chrono::seconds{100}};
constexpr Duration kCycle = std::chrono::milliseconds{100};

Bytes report(std::uint16_t x) {
  pioneer::Sip sip;
  sip.x = x;
  return pioneer::framed(pioneer::encode_sip(sip));
}

/// What arrives of fifty reports, one each 100 ms.
std::vector<Bytes> arrived(HardwareFault fault) {
  BaseLine line{1};
  static_cast<void>(line.to_host(report(1), kStart));
  line.set_fault(fault, kStart);
  std::vector<Bytes> all;
  for (int i = 0; i < 50; ++i) {
    Bytes bytes = line.to_host(report(static_cast<std::uint16_t>(100 + i)), kStart + i * kCycle);
    if (!bytes.empty()) all.push_back(std::move(bytes));
  }
  return all;
}

TEST(BaseLine, CarriesEverythingAsItIsWithoutAFault) {
  const auto all = arrived(HardwareFault::None);
  ASSERT_EQ(all.size(), 50u);
  EXPECT_EQ(all[7], report(107));
  BaseLine line{1};
  EXPECT_EQ(line.to_controller(report(3), kStart), report(3));
}

TEST(BaseLine, OffCarriesNothingEitherWay) {
  EXPECT_TRUE(arrived(HardwareFault::Off).empty());
  BaseLine line{1};
  line.set_fault(HardwareFault::Off, kStart);
  EXPECT_TRUE(line.to_controller(report(3), kStart).empty());
}

TEST(BaseLine, StuckRepeatsTheLastReport) {
  for (const auto& bytes : arrived(HardwareFault::Stuck)) EXPECT_EQ(bytes, report(1));
}

TEST(BaseLine, GarbageIsNoPacketAndWrongIsOneThatIsNotTrue) {
  for (const auto& bytes : arrived(HardwareFault::Garbage)) {
    pioneer::PacketReceiver receiver;
    receiver.push(bytes, kStart);
    EXPECT_FALSE(receiver.next());
  }
  for (const auto& bytes : arrived(HardwareFault::Wrong)) {
    pioneer::PacketReceiver receiver;
    receiver.push(bytes, kStart);
    EXPECT_TRUE(pioneer::decode_sip(*receiver.next()));
  }
}

TEST(BaseLine, SlowLetsOneInFiveThroughDelayedAllAndLate) {
  EXPECT_EQ(arrived(HardwareFault::Slow).size(), 10u);
  const auto late = arrived(HardwareFault::Delayed);
  ASSERT_EQ(late.size(), 46u);
  EXPECT_EQ(late[0], report(100));
}

TEST(BaseLine, IntermittentIsThereEverySecondSecond) {
  EXPECT_EQ(arrived(HardwareFault::Intermittent).size(), 20u);  // of five seconds the second and the fourth
}

TEST(BaseLine, NoiseDamagesAsManyPacketsAsItIsTold) {
  BaseLine line{1};
  line.set_noise(0.2);
  int damaged = 0;
  for (int i = 0; i < 1000; ++i) damaged += line.to_host(report(7), kStart + i * kCycle) != report(7) ? 1 : 0;
  EXPECT_NEAR(damaged, 360, 60);  // a byte, garbage before it, or both
}

}  // namespace
}  // namespace tandem::simulator
