#include "services/cli/teleop/gamepad_state.hpp"

#include <gtest/gtest.h>

namespace tandem::cli {
namespace {

constexpr std::int16_t kFull = 32'767;

Time at(double seconds) {
  return Time{std::chrono::seconds{100}} + from_seconds(seconds);
}
js_event axis(std::uint8_t number, std::int16_t value) {
  return {.time = 0, .value = value, .type = JS_EVENT_AXIS, .number = number};
}
js_event button(std::uint8_t number, bool pressed) {
  return {.time = 0, .value = static_cast<std::int16_t>(pressed ? 1 : 0), .type = JS_EVENT_BUTTON, .number = number};
}
GamepadState pad() {
  return {GamepadLayout{}, TeleopSpeeds{.forward_mps = 0.4, .turn_rate_radps = 0.5}};
}

TEST(GamepadState, DrivesAsTheStickSaysWhileTheButtonIsHeld) {
  GamepadState state = pad();
  state.take(axis(1, -kFull), at(0));
  EXPECT_FALSE(state.wanted(at(0)));
  state.take(button(4, true), at(0));
  EXPECT_EQ(*state.wanted(at(0)), (Twist2{0.4, 0.0, 0.0})) << "up is ahead";
  state.take(axis(0, kFull), at(0.1));
  EXPECT_EQ(*state.wanted(at(0.1)), (Twist2{0.4, 0.0, -0.5})) << "right is clockwise";
  state.take(button(4, false), at(0.2));
  EXPECT_FALSE(state.wanted(at(0.2)));
}

TEST(GamepadState, AStickThatNobodyTouchesAsksForNothing) {
  GamepadState state = pad();
  state.take(button(4, true), at(0));
  state.take(axis(1, -4900), at(0));  // 0.1495 of its way
  state.take(axis(0, 3000), at(0));
  EXPECT_EQ(*state.wanted(at(0)), Twist2{});
  state.take(axis(1, static_cast<std::int16_t>(-0.575 * kFull)), at(0));  // half the way that is left
  EXPECT_NEAR(state.wanted(at(0))->forward_mps, 0.2, 1e-4);
}

TEST(GamepadState, StandsWhenNothingHasComeForTwoSeconds) {
  GamepadState state = pad();
  state.take(axis(1, -kFull), at(0));
  state.take(button(4, true), at(0));
  EXPECT_GT(state.wanted(at(1.9))->forward_mps, 0.0);
  EXPECT_EQ(*state.wanted(at(2.1)), Twist2{});
  state.take(axis(1, -kFull + 5), at(3.0));
  EXPECT_GT(state.wanted(at(3.0))->forward_mps, 0.0);
}

TEST(GamepadState, AButtonThatWasHeldWhenThePadWasOpenedCountsOnlyOnceItIsPressedAnew) {
  GamepadState state = pad();
  js_event held = button(4, true);
  held.type |= JS_EVENT_INIT;
  js_event pushed = axis(1, -kFull);
  pushed.type |= JS_EVENT_INIT;
  state.take(held, at(0));
  state.take(pushed, at(0));
  EXPECT_FALSE(state.wanted(at(0)));
  state.take(button(4, true), at(1));
  EXPECT_DOUBLE_EQ(state.wanted(at(1))->forward_mps, 0.4);
}

TEST(GamepadState, TellsHowLongTheResumeButtonWasHeld) {
  GamepadState state = pad();
  state.take(button(7, true), at(0));
  EXPECT_FALSE(state.take_resume());
  state.take(button(7, false), at(1.25));
  EXPECT_NEAR(state.take_resume().value_or(0.0), 1.25, 1e-9);
  EXPECT_FALSE(state.take_resume());
}

}  // namespace
}  // namespace tandem::cli
