// Every way in which the base's hardware may fail, by the words that tests of flight software use, at the wheels of the
// simulated robot: it brakes in time, and nothing that mends itself moves it.
#include <gtest/gtest.h>

#include <memory>

#include "tests/robot/pioneer/simulated_base.hpp"

namespace tandem {
namespace {

using safety::Cause;
using simulator::HardwareFault;

struct Row {
  HardwareFault fault;
  Cause cause;
  double within_s;
};

class EachHardwareFault : public testing::TestWithParam<Row> {};

TEST_P(EachHardwareFault, StopsTheWheelsAndNothingMovesBeforeAResume) {
  const Row& row = GetParam();
  for (std::uint64_t time = 0; time < 100; ++time) {
    SCOPED_TRACE(time);
    SimulatedBase::Setup setup;
    setup.seed = time + 1;
    SimulatedBase robot{setup};
    robot.reach_cruise();
    robot.run(0.025 * static_cast<double>(time % 8));
    robot.seen.reset();
    robot.world.set_base_fault(row.fault, robot.now);
    ASSERT_LE(robot.time_to_braking(), row.within_s);
    robot.run(6.0);
    ASSERT_TRUE(robot.stands());
    ASSERT_TRUE(robot.seen.test(index_of(row.cause)));
    ASSERT_TRUE(robot.decision.latched);
    const double way_m = robot.way_m;
    robot.world.set_base_fault(HardwareFault::None, robot.now);
    robot.run(12.0);
    ASSERT_EQ(robot.way_m, way_m) << "0 mm travelled after recovery";
    ASSERT_TRUE(robot.session.is_running()) << "and it is connected again";
    ASSERT_EQ(robot.resume(), "");
    robot.run(4.0);
    ASSERT_GT(robot.forward_mps(), 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Base, EachHardwareFault,
                         testing::Values(Row{HardwareFault::Off, Cause::BaseLost, 0.05},
                                         Row{HardwareFault::Stuck, Cause::EncoderDead, 1.2},
                                         Row{HardwareFault::Garbage, Cause::BaseLost, 1.2},
                                         Row{HardwareFault::Wrong, Cause::OdometryJump, 0.3},
                                         Row{HardwareFault::Intermittent, Cause::BaseLost, 1.2}),
                         [](const auto& row) { return std::string{simulator::name_of(row.param.fault)}; });

TEST(HardwareFaults, ASlowOrLateBaseStillStopsInTimeBeforeWhatTheLaserSees) {
  for (const HardwareFault fault : {HardwareFault::Slow, HardwareFault::Delayed}) {
    SimulatedBase::Setup setup;
    setup.start = {25.0, 5.5, 0.0};
    SimulatedBase robot{setup};
    robot.reach_cruise();
    robot.world.set_base_fault(fault, robot.now);
    robot.run(40.0);
    EXPECT_EQ(robot.world.collisions(), 0);
    EXPECT_LT(robot.map_from_base().x + 0.313, 39.0 - 0.1);
    robot.base.gate().take_stop(true);
    EXPECT_LE(robot.time_to_standstill(), 1.5);
  }
}

TEST(HardwareFaults, NoiseOnTheLineMovesNothing) {
  SimulatedBase robot;
  robot.reach_cruise();
  robot.world.base_line().set_noise(0.1);
  robot.run(20.0);
  EXPECT_NEAR(robot.forward_mps(), 0.5, 0.01);
  EXPECT_GT(robot.session.receiver().bad_checksums(), 5u);
}

}  // namespace
}  // namespace tandem
