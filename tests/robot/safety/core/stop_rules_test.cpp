#include "robot/safety/core/stop_rules.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "tests/robot/safety/core/gate_world.hpp"

namespace tandem::safety {
namespace {

/// How to bring a cause about in a world that drives, and how to end it.
struct Fault {
  std::function<void(GateWorld&)> begin;
  std::function<void(GateWorld&)> end;
  double within_s = 0.05;  ///< braking must have begun after this
};

void once(GateWorld&) {}

/// A zone that nobody comes near: where there is one, the map matters.
const HardZone kFarZone{{{900.0, 0.0}, {901.0, 0.0}, {901.0, 1.0}}, 0.0};

const std::map<Cause, Fault>& faults() {
  static const std::map<Cause, Fault> all{
      {Cause::EmergencyStop,
       {[](GateWorld& w) { w.input.base.estop_pressed = true; },
        [](GateWorld& w) { w.input.base.estop_pressed = false; }}},
      {Cause::Bumper,
       {[](GateWorld& w) { w.input.base.front_bumpers = 4; }, [](GateWorld& w) { w.input.base.front_bumpers = 0; }}},
      {Cause::Stall,
       {[](GateWorld& w) { w.input.base.left_stalled = true; },
        [](GateWorld& w) { w.input.base.left_stalled = false; }}},
      {Cause::StopRequested, {[](GateWorld& w) { w.gate().take_stop(true); }, once}},
      {Cause::PauseRequested, {[](GateWorld& w) { w.gate().take_stop(false); }, once}},
      {Cause::BaseLost,
       {[](GateWorld& w) { w.input.base.connected = false; }, [](GateWorld& w) { w.input.base.connected = true; }}},
      {Cause::ServiceFailed, {[](GateWorld& w) { w.gate().take_service_failure(); }, once}},
      {Cause::OdometryJump, {[](GateWorld& w) { w.input.base.odom_from_base.x += 0.6; }, once}},
      {Cause::Overspeed,
       {[](GateWorld& w) {
          w.wheels_turn = false;
          w.input.base.measured.forward_mps = 0.8;
        },
        [](GateWorld& w) { w.wheels_turn = true; }, 0.3}},
      {Cause::EncoderDead,
       {[](GateWorld& w) {
          w.wheels_turn = false;
          w.input.base.measured = {};
        },
        [](GateWorld& w) { w.wheels_turn = true; }, 1.1}},
      {Cause::LowBattery,
       {[](GateWorld& w) { w.input.base.battery_v = 10.0; }, [](GateWorld& w) { w.input.base.battery_v = 20.0; }, 5.0}},
      {Cause::StuckScan,
       {[](GateWorld& w) { w.scanning = false; }, [](GateWorld& w) { w.scanning = true; }, 1.2}},  // see the test
      {Cause::StaleScan, {[](GateWorld& w) { w.scanning = false; }, [](GateWorld& w) { w.scanning = true; }, 0.4}},
      {Cause::BadScan,
       {[](GateWorld& w) { w.ranges.assign(GateWorld::kBeams, -1.0F); },
        [](GateWorld& w) { w.ranges.assign(GateWorld::kBeams, 8.0F); }, 0.1}},
      {Cause::PersonClose,
       {[](GateWorld& w) { w.put_person(0.0, 0.8); }, [](GateWorld& w) { w.put_person(0.0, 5.0); }}},
      {Cause::LinkLongLost,
       {[](GateWorld& w) { w.input.link.silent_s = 10.1; }, [](GateWorld& w) { w.input.link.silent_s = 0.0; }}},
      {Cause::LinkLost,
       {[](GateWorld& w) { w.input.link.silent_s = 1.6; }, [](GateWorld& w) { w.input.link.silent_s = 0.0; }}},
      {Cause::LostPose,
       {[](GateWorld& w) { w.input.pose.lost = true; }, [](GateWorld& w) { w.input.pose.lost = false; }}},
      {Cause::StalePose,
       {[](GateWorld& w) { w.input.pose.age_s = 0.6; }, [](GateWorld& w) { w.input.pose.age_s = 0.1; }}},
      {Cause::TwoBases,
       {[](GateWorld& w) { w.input.other_base = true; }, [](GateWorld& w) { w.input.other_base = false; }}},
      {Cause::TwoCommanders,
       {[](GateWorld& w) {
          w.send_command({0.1, 0.0}, 2);
        },
        once}},
      {Cause::BadCommand,
       {[](GateWorld& w) {
          for (int i = 0; i < 4; ++i) w.send_command({std::numeric_limits<double>::quiet_NaN(), 0.0});
        },
        once}},
      {Cause::OtherMap,
       {[](GateWorld& w) { w.input.other_map = true; }, [](GateWorld& w) { w.input.other_map = false; }}},
      {Cause::StaleCommand,
       {[](GateWorld& w) { w.commanding = false; }, [](GateWorld& w) { w.commanding = true; }, 0.4}},
  };
  return all;
}

/// Runs until the wheels are told to stand; how long that took [s].
double time_to_braking(GateWorld& world, const Fault& fault, Cause cause) {
  const Time begin = world.now;
  fault.begin(world);
  const auto frozen = world.ranges;
  for (int i = 0; i < 200; ++i) {
    if (cause == Cause::StuckScan && i % 2 == 0) {
      world.ranges = frozen;
      world.send_scan();  // ever new sequence numbers, ever the same picture
    }
    if (world.cycle().motion == Motion{}) break;
  }
  return to_seconds(world.now - begin);
}

TEST(StopRules, AreInTheOrderOfTheirCauses) {
  for (std::size_t i = 0; i < kCauses; ++i) EXPECT_EQ(index_of(kStopRules[i].cause), i);
}

TEST(StopRules, EachHasAMessageAndAFaultId) {
  for (const StopRule& rule : kStopRules) {
    EXPECT_FALSE(rule.message.empty());
    EXPECT_FALSE(rule.fault_id.empty());
    EXPECT_NE(rule.reason, StopReason::None);
  }
}

class EachStopRule : public testing::TestWithParam<Cause> {};

TEST_P(EachStopRule, BrakesInTimeAndResumesAsTheTableSays) {
  const Cause cause = GetParam();
  const Fault& fault = faults().at(cause);
  GateWorld world{{}, {kFarZone}};
  world.reach_cruise();
  ASSERT_DOUBLE_EQ(world.last.motion.forward_mps, 0.5);

  EXPECT_LE(time_to_braking(world, fault, cause), fault.within_s + 0.001);
  EXPECT_EQ(world.last.motion, Motion{});
  EXPECT_TRUE(world.last.causes.test(index_of(cause))) << "another cause was faster";

  if (rule_of(cause).resume == Resume::Latched) {
    EXPECT_TRUE(world.last.latched);
    fault.end(world);
    world.run(20.0);
    EXPECT_EQ(world.last.motion, Motion{}) << "moved without anybody's resume";
    EXPECT_TRUE(world.last.causes.test(index_of(cause))) << "the reason is shown until the resume";
    EXPECT_EQ(world.gate().take_resume(0.9, world.now), "hold the button longer");
    EXPECT_EQ(world.gate().take_resume(1.0, world.now), "");
    world.run(1.9);
    EXPECT_EQ(world.last.motion, Motion{}) << "2 s of warning";
    world.run(0.2);
    EXPECT_GT(world.last.motion.forward_mps, 0.0);
  } else {
    EXPECT_FALSE(world.last.latched);
    fault.end(world);
    world.run(4.9);
    EXPECT_EQ(world.last.motion, Motion{}) << "3 s healthy and 2 s of warning";
    world.run(1.5);
    EXPECT_GT(world.last.motion.forward_mps, 0.0);
  }
  EXPECT_TRUE(world.last.causes.none());
}

std::vector<Cause> stopping_causes() {
  std::vector<Cause> causes;
  for (const StopRule& rule : kStopRules) {
    // Before the first connection there is no driving, and what is in the way limits: tests of their own.
    if (rule.cause != Cause::BaseNotThere && rule.resume != Resume::AtOnce) causes.push_back(rule.cause);
  }
  return causes;
}

INSTANTIATE_TEST_SUITE_P(Table, EachStopRule, testing::ValuesIn(stopping_causes()),
                         [](const auto& row) { return "Cause" + std::to_string(index_of(row.param)); });

TEST(StopRules, ABaseThatHasNotAnsweredYetDoesNotLatch) {
  GateWorld world;
  world.input.base.connected = false;
  world.run(30.0);
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::BaseNotThere)));
  EXPECT_FALSE(world.last.latched);
  world.input.base.connected = true;
  world.run(7.0);
  EXPECT_GT(world.last.motion.forward_mps, 0.0);
}

TEST(StopRules, AnObstacleStopsAndLetsGoAtOnce) {
  GateWorld world;
  world.reach_cruise();
  world.put_wall_ahead(0.1);
  world.run(0.1);
  EXPECT_EQ(world.last.motion, Motion{});
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::ObstacleAhead)));
  EXPECT_FALSE(world.last.latched);
  world.put_wall_ahead(5.0);
  world.run(0.15);
  EXPECT_GT(world.last.motion.forward_mps, 0.0);
  EXPECT_TRUE(world.last.causes.none());
}

}  // namespace
}  // namespace tandem::safety
