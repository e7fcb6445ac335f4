#include "robot/safety/core/hard_zones.hpp"

#include <gtest/gtest.h>

#include "tests/robot/safety/core/gate_world.hpp"

namespace tandem::safety {
namespace {

/// Everything right of x = 5, as wide as a hall; keep-out unless a speed is given.
HardZone beyond_five(double max_speed_mps = 0.0) {
  return {{{5.0, -9.0}, {20.0, -9.0}, {20.0, 9.0}, {5.0, 9.0}}, max_speed_mps};
}

/// A U around (2, 0), open to the left.
const HardZone kPocket{{{0, -2}, {4, -2}, {4, 2}, {0, 2}, {0, 1}, {3, 1}, {3, -1}, {0, -1}}, 0.0};

TEST(HardZones, OverlapWhereTheHullAndThePolygonShareAPoint) {
  const Hull hull{0.3, 0.2};
  EXPECT_FALSE(overlaps(hull, {4.69, 0.0, 0.0}, beyond_five()));
  EXPECT_TRUE(overlaps(hull, {4.71, 0.0, 0.0}, beyond_five()));
  EXPECT_TRUE(overlaps(hull, {10.0, 0.0, 1.0}, beyond_five())) << "wholly inside";
  EXPECT_FALSE(overlaps(hull, {2.0, 0.0, 0.0}, kPocket)) << "in the pocket of a hollow polygon";
  EXPECT_TRUE(overlaps(hull, {2.0, 1.5, 0.0}, kPocket));
}

TEST(HardZones, SlowDownToWhatStopsBeforeAKeepOutZone) {
  const GateConfig config;
  const Hull hull{0.3, 0.2};
  const std::vector<HardZone> zones{beyond_five()};
  const auto limited = [&](double x) {
    return limited_by_zones(config, hull, 0.6, {0.5, 0.0}, zones, {x, 0.0, 0.0}, false);
  };
  EXPECT_EQ(limited(2.0).motion, (Motion{0.5, 0.0}));
  // 0.1 m of margin and 0.5 m/s x 0.5 s + 0.25 / 1.2 m = 0.458 m to stop.
  EXPECT_NEAR(limited(4.6 - 0.459).motion.forward_mps, 0.5, 1e-3);
  EXPECT_LT(limited(4.6 - 0.40).motion.forward_mps, 0.5);
  EXPECT_EQ(limited(4.65).motion, Motion{});
  EXPECT_TRUE(limited(4.65).limited_to_zero);
  EXPECT_EQ(limited(12.0).motion, Motion{}) << "inside";
}

TEST(HardZones, LetTheRobotTurnAndGoAwayInTheMarginAndAnOperatorCreepOut) {
  const GateConfig config;
  const Hull hull{0.3, 0.2};
  const std::vector<HardZone> zones{beyond_five()};
  const Pose2 near_edge{4.65, 0.0, 0.0};
  EXPECT_EQ(limited_by_zones(config, hull, 0.6, {-0.1, 0.0}, zones, near_edge, false).motion, (Motion{-0.1, 0.0}));
  const Pose2 inside{6.0, 0.0, from_degrees(180)};
  EXPECT_EQ(limited_by_zones(config, hull, 0.6, {0.5, 0.0}, zones, inside, false).motion, Motion{});
  EXPECT_EQ(limited_by_zones(config, hull, 0.6, {0.5, 0.0}, zones, inside, true).motion, (Motion{0.1, 0.0}));
}

TEST(HardZones, AreEnteredAndCrossedNoFasterThanSlowOnesAllow) {
  const GateConfig config;
  const Hull hull{0.3, 0.2};
  const std::vector<HardZone> zones{beyond_five(0.2)};
  const auto speed_at = [&](double x) {
    return limited_by_zones(config, hull, 0.6, {0.5, 0.1}, zones, {x, 0.0, 0.0}, false).motion;
  };
  EXPECT_EQ(speed_at(1.0), (Motion{0.5, 0.1}));
  EXPECT_NEAR(speed_at(4.6).forward_mps, 0.2, 1e-9);
  EXPECT_NEAR(speed_at(9.0).forward_mps, 0.2, 1e-9);
  EXPECT_NEAR(speed_at(9.0).turn_rate_radps, 0.04, 1e-9) << "the shape of the arc is kept";
}

TEST(HardZones, StopTheGateInFrontOfThemWithAReasonAndLetItGoElsewhere) {
  GateWorld world{{}, {beyond_five()}};
  world.follow_with_pose = true;
  world.run(40.0);
  EXPECT_EQ(world.last.motion, Motion{});
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::KeepOutAhead)));
  EXPECT_FALSE(world.last.latched);
  EXPECT_FALSE(overlaps(Hull{}, world.input.base.odom_from_base, beyond_five()));
  EXPECT_GT(world.input.base.odom_from_base.x, 4.0);

  world.kind = CommanderKind::Operator;
  world.command = {-0.1, 0.0};
  world.run(1.0);
  EXPECT_LT(world.last.motion.forward_mps, 0.0);
  EXPECT_TRUE(world.last.causes.none());
}

TEST(HardZones, NeedAPoseOnTheirMapEvenWhereNoneIsRequired) {
  for (const bool other_map : {false, true}) {
    GateWorld world{{.require_pose = false}, {beyond_five()}};
    world.follow_with_pose = true;
    world.run(6.0);
    ASSERT_GT(world.last.motion.forward_mps, 0.0);
    if (other_map) {
      world.input.other_map = true;
    } else {
      world.follow_with_pose = false;
      world.input.pose.age_s.reset();
    }
    world.cycle();
    EXPECT_EQ(world.last.motion, Motion{});
    EXPECT_TRUE(world.last.causes.test(index_of(other_map ? Cause::OtherMap : Cause::StalePose)));
    world.kind = CommanderKind::Operator;
    world.run(7.0);
    EXPECT_GT(world.last.motion.forward_mps, 0.0) << "an operator sees the zones";
  }
}

TEST(HardZones, OneWithoutCornersIsNowhere) {
  EXPECT_FALSE(overlaps(Hull{0.3, 0.2}, {}, HardZone{}));
}

TEST(HardZones, LetAMotionBeThatIsAsSlowAsTheEndOfAnApproach) {
  const Motion barely{0.005, 0.0};
  const std::vector<HardZone> zones{beyond_five()};
  EXPECT_EQ(limited_by_zones({}, Hull{0.3, 0.2}, 0.6, barely, zones, {2.0, 0.0, 0.0}, false).motion, barely);
  EXPECT_EQ(limited_by_zones({}, Hull{0.3, 0.2}, 0.6, {}, zones, {2.0, 0.0, 0.0}, false).motion, Motion{});
}

TEST(HardZones, AreUnknownToAnOperatorWithALostPoseOrOnAnotherMap) {
  for (const bool lost : {true, false}) {
    GateWorld world{{}, {beyond_five()}};
    world.kind = CommanderKind::Operator;
    world.reach_cruise();
    world.input.pose = {.age_s = 0.0, .lost = lost, .map_from_base = {6.0, 0.0, 0.0}, .stamp = world.now};
    world.input.other_map = !lost;
    EXPECT_GT(world.cycle().motion.forward_mps, 0.1);
  }
}

}  // namespace
}  // namespace tandem::safety
