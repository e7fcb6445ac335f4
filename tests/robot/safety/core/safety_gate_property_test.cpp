#include <gtest/gtest.h>

#include <limits>

#include "services/common/random.hpp"
#include "tests/robot/safety/core/gate_world.hpp"

namespace tandem::safety {
namespace {

double anything(Rng& rng) {
  switch (rng.index(8)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return std::numeric_limits<double>::infinity();
    case 2:
      return rng.uniform(-1e6, 1e6);
    default:
      return rng.uniform(-1.5, 1.5);
  }
}

/// Undoes what disturb() broke, so that the robot drives again now and then.
void heal(GateWorld& world) {
  const Pose2 pose = world.input.base.odom_from_base;
  world.input.base = GateWorld{}.input.base;
  if (std::isfinite(pose.x)) world.input.base.odom_from_base = pose;
  world.input.pose = {.age_s = 0.0, .lost = false};
  world.input.link.silent_s = 0.0;
  world.scanning = world.commanding = true;
  world.put_wall_ahead(3.0);
}

/// Turns every knob of the world at random, sane or not.
void disturb(GateWorld& world, Rng& rng) {
  BaseInput& base = world.input.base;
  if (rng.index(60) == 0) heal(world);
  if (rng.index(400) == 0) base.connected = false;
  if (rng.index(400) == 0) base.estop_pressed = !base.estop_pressed;
  if (rng.index(400) == 0) base.front_bumpers ^= 1u;
  if (rng.index(400) == 0) base.left_stalled = !base.left_stalled;
  if (rng.index(50) == 0) base.watchdog_s = rng.uniform(0.0, 2.0);
  if (rng.index(50) == 0) base.deceleration_mps2 = rng.uniform(0.0, 1.0);
  if (rng.index(500) == 0) base.odom_from_base.x = anything(rng);
  if (rng.index(30) == 0) world.input.people.age_s = rng.uniform(0.0, 0.8);
  if (rng.index(100) == 0) world.input.pose.age_s = rng.uniform(0.0, 0.6);
  if (rng.index(500) == 0) world.input.pose.lost = true;
  if (rng.index(300) == 0) world.input.link.silent_s = rng.uniform(0.0, 12.0);
  if (rng.index(10) == 0) world.put_person(rng.uniform(-6, 6), rng.uniform(-6, 6));
  if (rng.index(20) == 0) world.put_wall_ahead(rng.uniform(-0.1, 3.0));
  if (rng.index(100) == 0) world.ranges[rng.index(GateWorld::kBeams)] = static_cast<float>(anything(rng));
  if (rng.index(10) == 0) world.command = {rng.uniform(-0.5, 1.5), rng.uniform(-1.5, 1.5)};
  if (rng.index(100) == 0) world.command = {anything(rng), anything(rng)};
  if (rng.index(500) == 0) world.scanning = false;
  if (rng.index(500) == 0) world.commanding = false;
  if (rng.index(500) == 0) world.gate().take_stop(rng.index(2) == 0);
  if (rng.index(5) == 0) static_cast<void>(world.gate().take_resume(rng.uniform(0.0, 2.0), world.now));
}

TEST(SafetyGateProperty, NoInputEverExceedsALimit) {
  constexpr std::uint64_t kSeed = 42;
  Rng rng{kSeed};
  int moving = 0;
  const GateConfig config{.healthy_s = 0.1, .warning_s = 0.5};  // short, to be out of stops often
  for (int episode = 0; episode < 1000; ++episode) {            // 10^6 cycles in all
    GateWorld world{config};
    world.wheels_turn = rng.index(4) != 0;
    world.kind = rng.index(2) == 0 ? CommanderKind::Program : CommanderKind::Operator;
    double last_forward = 0.0;
    double last_turn = 0.0;
    for (int i = 0; i < 1000; ++i) {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " episode " << episode << " cycle " << i);
      disturb(world, rng);
      const GateDecision decision = world.cycle();
      const double forward = decision.motion.forward_mps;
      const double turn = decision.motion.turn_rate_radps;
      const Hull hull{};

      ASSERT_TRUE(std::isfinite(forward) && std::isfinite(turn));
      ASSERT_LE(std::abs(forward), 0.5 + 1e-9);  // SAF-1
      ASSERT_LE(std::abs(turn), 1.0472 + 1e-9);
      ASSERT_LE(std::abs(forward) - std::abs(last_forward), 0.3 * 0.05 + 1e-9);
      ASSERT_LE(std::abs(turn) - std::abs(last_turn), 1.745 * 0.05 + 1e-9);
      ASSERT_GE(forward * last_forward, -1e-12);  // never through zero
      ASSERT_GE(forward, world.kind == CommanderKind::Operator ? -0.1 - 1e-9 : 0.0);
      const double person_m = nearest_person_m(hull, world.input.people);
      ASSERT_LE(std::abs(forward), speed_near_person(person_m, 0.5) + 1e-9);  // SAF-2
      if (*world.input.people.age_s > 0.5) {
        ASSERT_LE(std::abs(forward), 0.3 + 1e-9);
      }
      if (world.input.base.watchdog_s > 1.0) {
        ASSERT_LE(std::abs(forward), 0.3 + 1e-9);
      }
      const bool contact =
          world.input.base.estop_pressed || world.input.base.left_stalled || !world.input.base.connected;
      if (contact || decision.latched) {
        ASSERT_EQ(decision.motion, Motion{});
      }
      if (world.input.base.front_bumpers != 0) {  // B5: an operator who resumed may back out
        ASSERT_EQ(turn, 0.0);
        ASSERT_LE(forward, 0.0);
      }
      if (decision.motion != Motion{}) ++moving;
      last_forward = forward;
      last_turn = turn;
    }
  }
  EXPECT_GT(moving, 30'000) << "the test must see the robot move";
}

}  // namespace
}  // namespace tandem::safety
