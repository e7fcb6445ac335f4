#include "services/relay/core/forwarding.hpp"

#include <gtest/gtest.h>

namespace tandem {
namespace {

TEST(Forwarding, EachHostSendsWhatTheOtherReads) {
  const ForwardingRule to_laptop{.to_laptop = true};
  EXPECT_TRUE(carries(to_laptop, HostRole::Robot, Crossing::HostToLink));
  EXPECT_FALSE(carries(to_laptop, HostRole::Robot, Crossing::LinkToHost));
  EXPECT_FALSE(carries(to_laptop, HostRole::Laptop, Crossing::HostToLink));
  EXPECT_TRUE(carries(to_laptop, HostRole::Laptop, Crossing::LinkToHost));

  const ForwardingRule never{};
  for (const auto role : {HostRole::Robot, HostRole::Laptop}) {
    EXPECT_FALSE(carries(never, role, Crossing::HostToLink));
    EXPECT_FALSE(carries(never, role, Crossing::LinkToHost));
  }
}

TEST(Forwarding, ThinsAStreamToItsRate) {
  ForwardingGate gate{{.to_laptop = true, .max_rate_hz = 5.0}};
  int passed = 0;
  for (int i = 0; i < 100; ++i) {  // 20 Hz for 5 s
    passed += gate.passes({}, from_stamp_ns(i * 50'000'000LL), 0.0) ? 1 : 0;
  }
  EXPECT_EQ(passed, 25);
}

TEST(Forwarding, AStreamAtItsOwnRatePassesInSpiteOfJitter) {
  ForwardingGate gate{{.to_laptop = true, .max_rate_hz = 10.0}};
  int passed = 0;
  for (int i = 0; i < 100; ++i) {
    const std::int64_t jitter_ns = i % 2 == 0 ? 0 : -8'000'000;
    passed += gate.passes({}, from_stamp_ns(i * 100'000'000LL + jitter_ns), 0.0) ? 1 : 0;
  }
  EXPECT_EQ(passed, 100);
}

TEST(Forwarding, EachInstanceHasItsOwnRate) {
  ForwardingGate gate{{.to_laptop = true, .max_rate_hz = 1.0}};
  EXPECT_TRUE(gate.passes({1}, Time{}, 0.0));
  EXPECT_TRUE(gate.passes({2}, Time{}, 0.0));
  EXPECT_FALSE(gate.passes({1}, Time{}, 0.0));
}

TEST(Forwarding, DropsWhatIsTooOld) {
  ForwardingGate gate{{.to_laptop = true, .max_age_s = 1.0}};
  EXPECT_TRUE(gate.passes({}, Time{}, 1.0));
  EXPECT_FALSE(gate.passes({}, Time{}, 1.1));
}

}  // namespace
}  // namespace tandem
