#include "services/simulator/core/hardware_fault.hpp"

#include <gtest/gtest.h>

namespace tandem::simulator {
namespace {

Time at(double seconds) {
  return Time{} + from_seconds(seconds);
}

TEST(HardwareFault, HasTheNamesOfTheTable) {
  for (const auto* name : {"none", "off", "stuck", "garbage", "wrong", "slow", "delayed", "intermittent"}) {
    const auto fault = hardware_fault(name);
    ASSERT_TRUE(fault) << name;
    EXPECT_EQ(name_of(*fault), name);
  }
  EXPECT_FALSE(hardware_fault("broken"));
  EXPECT_EQ(hardware_fault_names(), "none, off, stuck, garbage, wrong, slow, delayed, intermittent");
}

TEST(FaultyLine, PassesAllWhenNothingIsWrong) {
  FaultyLine line{1};
  EXPECT_TRUE(line.hears(at(0)));
  EXPECT_EQ(line.pass("answer", at(0)), "answer");
  EXPECT_EQ(line.pass_message("scan", at(0)), "scan");
}

TEST(FaultyLine, WithoutPowerNothingGoesEitherWay) {
  FaultyLine line{1};
  line.set(HardwareFault::Off, at(0));
  EXPECT_FALSE(line.hears(at(1)));
  EXPECT_EQ(line.pass("answer", at(1)), "");
  line.set(HardwareFault::None, at(2));
  EXPECT_EQ(line.pass("answer", at(2)), "answer");
}

TEST(FaultyLine, GarbageKeepsTheLengthAlone) {
  FaultyLine line{1};
  line.set(HardwareFault::Garbage, at(0));
  const std::string bytes = line.pass(std::string(100, 'x'), at(0));
  EXPECT_EQ(bytes.size(), 100u);
  EXPECT_NE(bytes, std::string(100, 'x'));
}

TEST(FaultyLine, ASlowDeviceAnswersButSendsEveryFourthMessage) {
  FaultyLine line{1};
  line.set(HardwareFault::Slow, at(0));
  int passed = 0;
  for (int i = 0; i < 12; ++i) passed += line.pass_message("scan", at(0.1 * i)).empty() ? 0 : 1;
  EXPECT_EQ(passed, 3);
  EXPECT_EQ(line.pass("answer", at(2)), "answer");
}

TEST(FaultyLine, WhatIsDelayedComesWholeAndInOrder) {
  FaultyLine line{1};
  line.set(HardwareFault::Delayed, at(0));
  EXPECT_EQ(line.pass("a", at(0)), "");
  EXPECT_EQ(line.pass_message("b", at(0.1)), "");
  EXPECT_EQ(line.due(at(0.39)), "");
  EXPECT_EQ(line.due(at(0.41)), "a");
  EXPECT_EQ(line.due(at(0.6)), "b");
  EXPECT_EQ(line.due(at(1.0)), "");
}

TEST(FaultyLine, AnIntermittentOneIsJoinedEverySecondSecond) {
  FaultyLine line{1};
  EXPECT_EQ(line.pass("answer", at(9.9)), "answer");
  line.set(HardwareFault::Intermittent, at(10.0));
  EXPECT_FALSE(line.hears(at(10.1)));
  EXPECT_EQ(line.pass("answer", at(10.1)), "ans") << "cut off in the middle";
  EXPECT_EQ(line.pass("answer", at(10.9)), "");
  EXPECT_TRUE(line.hears(at(11.1)));
  EXPECT_EQ(line.pass("answer", at(11.9)), "answer");
  EXPECT_FALSE(line.hears(at(12.1)));
}

TEST(FaultyLine, NoiseDamagesAsManyMessagesAsItIsTold) {
  FaultyLine line{1};
  line.set_noise(0.2);
  int damaged = 0;
  for (int i = 0; i < 1000; ++i) damaged += line.pass_message("report", at(0.1 * i)) != "report" ? 1 : 0;
  EXPECT_NEAR(damaged, 360, 60);  // a byte, garbage before it, or both
}

}  // namespace
}  // namespace tandem::simulator
