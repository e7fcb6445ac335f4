#include "robot/safety/core/link_monitor.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/robot/safety/core/gate_world.hpp"

namespace tandem::safety {
namespace {

/// A gate whose site lets the robot go on, driving, when the link falls silent.
std::unique_ptr<GateWorld> without_link(const GateConfig& config = {}) {
  auto world = std::make_unique<GateWorld>(config);
  world->input.link.may_go_on = true;
  world->reach_cruise();
  world->input.link.silent_s = 1.6;
  return world;
}

TEST(LinkMonitor, StopsAtOnceWhereTheSiteSaysStop) {
  const auto world = without_link();
  world->input.link.may_go_on = false;
  EXPECT_EQ(world->cycle().motion, Motion{});
  EXPECT_TRUE(world->last.causes.test(index_of(Cause::LinkLost)));
}

TEST(LinkMonitor, LetsTheRobotGoOnSlowlyForItsLastLeg) {
  const auto world = without_link();
  const double x = world->input.base.odom_from_base.x;
  world->run(20.0);
  EXPECT_DOUBLE_EQ(world->last.motion.forward_mps, 0.3);
  world->input.link.silent_s = 21.6;
  world->run(20.0);
  EXPECT_EQ(world->last.motion, Motion{});
  EXPECT_TRUE(world->last.causes.test(index_of(Cause::LinkLongLost)));
  EXPECT_TRUE(world->last.latched);
  EXPECT_NEAR(world->input.base.odom_from_base.x - x, 10.0, 0.1);
}

TEST(LinkMonitor, EndsTheLastLegAfterItsTimeToo) {
  const auto world = without_link({.last_leg_s = 5.0});
  world->run(4.9);
  EXPECT_GT(world->last.motion.forward_mps, 0.0);
  world->run(0.3);
  EXPECT_EQ(world->last.motion, Motion{});
}

TEST(LinkMonitor, BeginsAnewOnceTheLinkIsThereAgain) {
  const auto world = without_link();
  world->run(30.0);
  world->input.link.silent_s = 0.1;
  world->run(1.0);
  EXPECT_DOUBLE_EQ(world->last.motion.forward_mps, 0.5);
  world->input.link.silent_s = 1.6;
  world->run(30.0);
  EXPECT_DOUBLE_EQ(world->last.motion.forward_mps, 0.3);
}

TEST(LinkMonitor, KnowsNoLastLegBeforeThereWasALink) {
  GateWorld world;
  world.input.link = {.silent_s = std::nullopt, .may_go_on = true};
  world.run(10.0);
  EXPECT_EQ(world.last.motion, Motion{});
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::LinkLost)));
}

TEST(LinkMonitor, MindsNoLinkWhereNoneIsRequired) {
  GateWorld world{{.require_link = false}};
  world.input.link.silent_s.reset();
  world.reach_cruise();
  EXPECT_DOUBLE_EQ(world.last.motion.forward_mps, 0.5);
}

TEST(LinkMonitor, ALinkOfWhichNothingIsKnownAnyMoreIsGoneForLong) {
  GateWorld world;
  world.reach_cruise();
  world.input.link.silent_s.reset();
  world.cycle();
  EXPECT_TRUE(world.last.causes.test(index_of(Cause::LinkLongLost)));
}

}  // namespace
}  // namespace tandem::safety
