#include "services/cli/teleop/operator_keys.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

constexpr TeleopSpeeds kSpeeds{.forward_mps = 0.3, .turn_rate_radps = 0.5};

Time at(double seconds) {
  return Time{std::chrono::seconds{100}} + from_seconds(seconds);
}

TEST(OperatorKeys, EachDrivingKeyHasItsVelocity) {
  const auto wanted = [](std::string_view bytes) {
    OperatorKeys keys{kSpeeds};
    keys.take(bytes, at(0));
    return keys.wanted(at(0.1));
  };
  EXPECT_EQ(wanted("w"), (Twist2{0.3, 0.0, 0.0}));
  EXPECT_EQ(wanted("W"), (Twist2{0.3, 0.0, 0.0}));
  EXPECT_EQ(wanted("s"), (Twist2{-0.3, 0.0, 0.0}));
  EXPECT_EQ(wanted("a"), (Twist2{0.0, 0.0, 0.5}));
  EXPECT_EQ(wanted("d"), (Twist2{0.0, 0.0, -0.5}));
  EXPECT_EQ(wanted("q"), (Twist2{0.3, 0.0, 0.25}));
  EXPECT_EQ(wanted("e"), (Twist2{0.3, 0.0, -0.25}));
  EXPECT_EQ(wanted("\x1b[A"), (Twist2{0.3, 0.0, 0.0}));
  EXPECT_EQ(wanted("\x1bOD"), (Twist2{0.0, 0.0, 0.5})) << "as terminals in application mode send it";
  EXPECT_EQ(wanted("z"), Twist2{});
}

TEST(OperatorKeys, ATouchEndsByItselfAndSoDoesAHeldKeySoonAfterItsLastRepetition) {
  OperatorKeys keys{kSpeeds};
  EXPECT_EQ(keys.wanted(at(0)), Twist2{});
  keys.take("w", at(0));
  EXPECT_NE(keys.wanted(at(0.69)), Twist2{});
  EXPECT_EQ(keys.wanted(at(0.71)), Twist2{});

  keys.take("w", at(10.0));
  for (int i = 0; i <= 20; ++i) {  // the terminal begins after 0.5 s, and then does so each 50 ms
    EXPECT_NE(keys.wanted(at(10.499 + 0.05 * i)), Twist2{});
    keys.take("w", at(10.5 + 0.05 * i));
  }
  EXPECT_NE(keys.wanted(at(11.5 + 0.24)), Twist2{});
  EXPECT_EQ(keys.wanted(at(11.5 + 0.26)), Twist2{});
}

TEST(OperatorKeys, AnotherKeyTakesOverAtOnceAndOneThatDrivesNotStops) {
  OperatorKeys keys{kSpeeds};
  keys.take("w", at(0));
  keys.take("a", at(0.1));
  EXPECT_EQ(keys.wanted(at(0.11)), (Twist2{0.0, 0.0, 0.5}));
  keys.take(" ", at(0.2));
  EXPECT_EQ(keys.wanted(at(0.21)), Twist2{});
}

TEST(OperatorKeys, AnArrowMayComeInPieces) {
  OperatorKeys keys{kSpeeds};
  keys.take("\x1b", at(0));
  keys.take("[", at(0.01));
  EXPECT_EQ(keys.wanted(at(0.01)), Twist2{});
  keys.take("B", at(0.02));
  EXPECT_EQ(keys.wanted(at(0.03)), (Twist2{-0.3, 0.0, 0.0}));
}

TEST(OperatorKeys, SpeedGoesByStepsBetweenTheSlowestAndTheHardLimit) {
  OperatorKeys keys{kSpeeds};
  keys.take("+", at(0));
  EXPECT_DOUBLE_EQ(keys.speeds().forward_mps, 0.35);
  for (int i = 0; i < 20; ++i) keys.take("=", at(1));
  EXPECT_DOUBLE_EQ(keys.speeds().forward_mps, 0.7);
  for (int i = 0; i < 40; ++i) keys.take("-", at(2));
  EXPECT_DOUBLE_EQ(keys.speeds().forward_mps, 0.05);
  EXPECT_EQ(keys.wanted(at(2)), Twist2{}) << "that drives nothing";
}

TEST(OperatorKeys, ResumesOnceForASecondOfHolding) {
  OperatorKeys keys{kSpeeds};
  keys.take("r", at(0));
  for (double t = 0.5; t < 0.99; t += 0.05) keys.take("r", at(t));
  EXPECT_FALSE(keys.take_resume());
  keys.take("r", at(1.05));
  keys.take("r", at(1.1));
  const auto held_s = keys.take_resume();
  ASSERT_TRUE(held_s);
  EXPECT_NEAR(*held_s, 1.05, 1e-6);
  EXPECT_FALSE(keys.take_resume());
  keys.take("r", at(3.0));  // let go in between: it begins anew
  keys.take("r", at(3.5));
  EXPECT_FALSE(keys.take_resume());
}

TEST(OperatorKeys, XEndsIt) {
  OperatorKeys keys{kSpeeds};
  EXPECT_FALSE(keys.wants_to_quit());
  keys.take("wx", at(0));
  EXPECT_TRUE(keys.wants_to_quit());
  EXPECT_EQ(keys.wanted(at(0)), Twist2{});
}

}  // namespace
}  // namespace tandem::cli
