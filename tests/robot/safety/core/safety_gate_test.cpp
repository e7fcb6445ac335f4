#include "robot/safety/core/safety_gate.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <new>

#include "tests/robot/safety/core/gate_world.hpp"

namespace {
std::size_t allocations = 0;
}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;  // NOLINT: this is the allocator
  throw std::bad_alloc{};
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}  // NOLINT
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}  // NOLINT

namespace tandem::safety {
namespace {

TEST(SafetyGate, DrivesAsToldWhereAllIsWell) {
  GateWorld world;
  world.command = {0.4, 0.1};
  world.reach_cruise();
  EXPECT_EQ(world.last.motion, (Motion{0.4, 0.1}));
  EXPECT_TRUE(world.last.causes.none());
}

TEST(SafetyGate, WaitsAtStartUntilAllHasBeenWellForThreeSecondsAndWarnsForTwo) {
  GateWorld world;
  world.run(5.0);
  EXPECT_EQ(world.last.motion, Motion{});
  EXPECT_GT(world.last.resume_in_s, 0.0);
  world.run(0.5);
  EXPECT_GT(world.last.motion.forward_mps, 0.0);  // nobody had to resume anything
}

TEST(SafetyGate, NeverExceedsTheSpeedLimits) {
  GateWorld world;
  world.command = {1.9, 6.0};
  world.reach_cruise();
  EXPECT_LE(world.last.motion.forward_mps, 0.5);
  EXPECT_LE(world.last.motion.turn_rate_radps, 1.0472);
}

TEST(SafetyGate, GathersSpeedGentlyAndLosesItAtOnce) {
  GateWorld world;
  world.command = {0.0, 0.0};
  world.run(6.0);
  world.command = {0.5, 0.0};
  double last = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double speed = world.cycle().motion.forward_mps;
    EXPECT_LE(speed - last, 0.3 * 0.05 + 1e-9);
    last = speed;
  }
  EXPECT_DOUBLE_EQ(last, 0.5);
  world.command = {0.0, 0.0};
  EXPECT_EQ(world.cycle().motion, Motion{});
}

TEST(SafetyGate, StartsFromStandingAfterItWasNotAskedForAWhile) {
  GateWorld world;
  world.reach_cruise();
  world.now += std::chrono::milliseconds{250};
  EXPECT_LE(world.cycle().motion.forward_mps, 0.3 * 0.2 + 1e-9);
}

TEST(SafetyGate, LetsAProgramNeverGoBackAndAnOperatorALittle) {
  GateWorld program;
  program.command = {-0.3, 0.0};
  program.reach_cruise();
  EXPECT_EQ(program.last.motion, Motion{});

  GateWorld operator_;
  operator_.kind = CommanderKind::Operator;
  operator_.command = {-0.3, 0.0};
  operator_.run(6.0);
  EXPECT_DOUBLE_EQ(operator_.last.motion.forward_mps, -0.1);
  operator_.run(10.0);
  EXPECT_EQ(operator_.last.motion, Motion{});
  EXPECT_NEAR(operator_.input.base.odom_from_base.x, -0.3, 0.01);
}

TEST(SafetyGate, LetsAnOperatorDriveWithoutAPose) {
  GateWorld world;
  world.kind = CommanderKind::Operator;
  world.input.pose.age_s.reset();
  world.reach_cruise();
  EXPECT_DOUBLE_EQ(world.last.motion.forward_mps, 0.5);
}

TEST(SafetyGate, SilenceAfterStandStillIsNoFault) {
  GateWorld world;
  world.command = {0.0, 0.0};
  world.reach_cruise();
  world.commanding = false;
  world.run(10.0);
  EXPECT_TRUE(world.last.causes.none());
}

TEST(SafetyGate, KeepsTheLastGoodCommandWhileABadOneComes) {
  GateWorld world;
  world.reach_cruise();
  world.send_command({100.0, 0.0});
  EXPECT_DOUBLE_EQ(world.cycle().motion.forward_mps, 0.5);
  EXPECT_EQ(world.gate().rejected_commands(), 1u);
}

TEST(SafetyGate, RefusesToResumeWhileACauseHolds) {
  GateWorld world;
  world.reach_cruise();
  world.input.base.estop_pressed = true;
  world.run(1.0);
  EXPECT_EQ(world.gate().take_resume(2.0, world.now), "the emergency stop is pressed");
  EXPECT_TRUE(world.last.latched);
}

TEST(SafetyGate, ResumingNothingSaysSo) {
  GateWorld world;
  world.reach_cruise();
  EXPECT_EQ(world.gate().take_resume(2.0, world.now), "nothing to resume");
}

TEST(SafetyGate, ALinkOutageLatchesOnlyWhenItIsLong) {
  GateWorld world;
  world.reach_cruise();
  for (double silent_s = 0.0; silent_s < 9.0; silent_s += 0.05) {
    world.input.link.silent_s = silent_s;
    world.cycle();
  }
  EXPECT_FALSE(world.last.latched);
  world.input.link.silent_s = 10.5;
  world.cycle();
  EXPECT_TRUE(world.last.latched);
}

TEST(SafetyGate, ALinkThatWasNeverUpDoesNotLatch) {
  GateWorld world;
  world.input.link.silent_s.reset();
  world.run(30.0);
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::LinkLost)));
  EXPECT_FALSE(world.last.latched);
}

TEST(SafetyGate, StopsBeforeAWallWithoutTouchingIt) {
  GateWorld world;
  world.reach_cruise();
  double ahead_m = 3.0;
  for (int i = 0; i < 20 * 30; ++i) {
    world.put_wall_ahead(ahead_m);
    ahead_m -= 0.05 * world.cycle().motion.forward_mps;
    ASSERT_GT(ahead_m, 0.15 - 0.03);
  }
  EXPECT_LT(world.last.motion.forward_mps, 0.02);
}

TEST(SafetyGate, ACycleAllocatesNothingWhateverHappens) {
  GateWorld world{{}, {{{{3.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {3.0, 9.0}}, 0.0}}};
  world.follow_with_pose = true;
  world.reach_cruise();
  const std::size_t before = allocations;
  world.run(5.0);
  world.put_wall_ahead(0.3);
  world.run(1.0);
  world.put_person(0.5, 0.5);
  world.input.base.front_bumpers = 1;
  world.input.link.silent_s = 11.0;
  world.run(1.0);
  world.input.base.front_bumpers = 0;
  world.input.link.silent_s = 0.0;
  world.put_person(5.0, 5.0);
  for (int i = 0; i < 5; ++i) world.send_command({std::numeric_limits<double>::quiet_NaN(), 0.0});
  world.run(2.0);
  static_cast<void>(world.gate().take_resume(1.0, world.now));
  world.run(5.0);
  world.kind = CommanderKind::Operator;
  world.command = {-0.1, 0.2};
  world.run(5.0);
  EXPECT_EQ(allocations, before);
}

TEST(SafetyGate, StartsFromStandingAfterTheMotorsWereOffOrTimeWentBack) {
  GateWorld off;
  off.reach_cruise();
  off.input.base.motors_enabled = false;
  EXPECT_LE(off.cycle().motion.forward_mps, 0.3 * 0.05 + 1e-9);

  GateWorld back;
  back.reach_cruise();
  back.now -= std::chrono::milliseconds{250};
  EXPECT_LE(back.cycle().motion.forward_mps, 1e-9);
}

TEST(SafetyGate, CountsOnHalfTheBrakesWhereTheBaseSaysNothingOfThem) {
  const auto speed_before_a_wall = [](double deceleration_mps2) {
    GateWorld world;
    world.input.base.deceleration_mps2 = deceleration_mps2;
    world.put_wall_ahead(0.3);
    return world.run(10.0).motion.forward_mps;
  };
  EXPECT_GT(speed_before_a_wall(0.6), speed_before_a_wall(0.0));
  EXPECT_DOUBLE_EQ(speed_before_a_wall(0.0), speed_before_a_wall(0.3));
}

TEST(SafetyGate, LetsAnOperatorOutOfAContactAwayFromItAlone) {
  for (const bool rear : {false, true}) {
    GateWorld world;
    world.kind = CommanderKind::Operator;
    world.command = {};
    world.reach_cruise();
    (rear ? world.input.base.rear_bumpers : world.input.base.front_bumpers) = 1;
    world.run(1.0);
    ASSERT_EQ(world.last.motion, Motion{});
    ASSERT_EQ(world.gate().take_resume(1.0, world.now), "");
    world.command = {rear ? 0.3 : -0.3, 0.4};
    world.run(2.2);
    EXPECT_GT((rear ? 1.0 : -1.0) * world.last.motion.forward_mps, 0.0);
    EXPECT_LE(std::abs(world.last.motion.forward_mps), 0.1);
    EXPECT_EQ(world.last.motion.turn_rate_radps, 0.0);
    world.command.forward_mps = -world.command.forward_mps;
    world.run(1.0);
    EXPECT_EQ(world.last.motion, Motion{}) << "never further into it";
  }
}

TEST(SafetyGate, WarnsOfABatteryThatRunsLowBeforeItStops) {
  GateWorld world;
  EXPECT_FALSE(world.cycle().battery_warning);
  world.input.base.battery_v = 11.6;
  EXPECT_TRUE(world.run(60.0).battery_warning);
  EXPECT_FALSE(world.last.battery_return);
  world.input.base.battery_v = 11.4;
  EXPECT_TRUE(world.run(60.0).battery_return);
  EXPECT_TRUE(world.last.causes.none());

  GateWorld unknown;
  unknown.input.base.battery_v = 0.0;
  EXPECT_FALSE(unknown.cycle().battery_warning);
}

TEST(SafetyGate, IsSlowWhereNobodyEverSaidWherePeopleAre) {
  GateWorld world;
  world.input.people.age_s.reset();
  world.reach_cruise();
  EXPECT_DOUBLE_EQ(world.last.motion.forward_mps, 0.3);
}

TEST(SafetyGate, NeedsNoPoseWhereNoneIsRequiredAndThereAreNoZones) {
  GateWorld world{{.require_pose = false}};
  world.input.pose = {};
  world.reach_cruise();
  EXPECT_DOUBLE_EQ(world.last.motion.forward_mps, 0.5);
}

}  // namespace
}  // namespace tandem::safety
