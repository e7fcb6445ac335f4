// What the link between driver and controller may suffer, and how motion comes back: rows B1 to B4, P1 and P2 of
// docs/safety.md, at the wheels of the simulated robot, in virtual time.
#include <gtest/gtest.h>

#include <memory>

#include "services/common/random.hpp"
#include "tests/robot/pioneer/simulated_base.hpp"

namespace tandem {
namespace {

using safety::Cause;

std::unique_ptr<SimulatedBase> driving_robot(std::uint64_t seed, Duration watchdog = std::chrono::milliseconds{500}) {
  SimulatedBase::Setup setup;
  setup.seed = seed;
  setup.watchdog = watchdog;
  auto robot = std::make_unique<SimulatedBase>(setup);
  robot->command.forward_mps = 0.3;  // allowed with any watchdog
  robot->reach_cruise();
  return robot;
}

template <typename Event>
int count_of(const SimulatedBase& robot) {
  return static_cast<int>(std::count_if(robot.events.begin(), robot.events.end(),
                                        [](const auto& event) { return std::holds_alternative<Event>(event); }));
}

TEST(BaseRecovery, B1NoiseOnTheLineChangesNothingThatIsCommanded) {
  constexpr std::uint64_t kSeed = 5;
  Rng rng{kSeed};
  const auto robot = driving_robot(1);
  robot->spoil_bytes = [&](pioneer::Bytes bytes) {  // one packet in ten has a wrong byte, another ten garbage before it
    if (rng.index(10) == 0 && !bytes.empty())
      bytes[rng.index(bytes.size())] ^= static_cast<std::uint8_t>(1 + rng.index(255));
    if (rng.index(10) == 0) {
      for (std::size_t i = 0; i < 1 + rng.index(40); ++i) {
        bytes.insert(bytes.begin(), static_cast<std::uint8_t>(rng.bits()));
      }
    }
    return bytes;
  };
  robot->command.forward_mps = 0.2;
  for (int i = 0; i < 400; ++i) {
    robot->run(0.1);
    ASSERT_LE(robot->wheel_mps(), 0.31);
  }
  EXPECT_NEAR(robot->forward_mps(), 0.2, 0.01);
  EXPECT_EQ(count_of<pioneer::Lost>(*robot), 0) << "never drops the connection for a bad checksum";
  EXPECT_GT(robot->session.receiver().bad_checksums(), 5u);
}

TEST(BaseRecovery, B1ALineOfNoiseAloneStopsTheWheelsAndIsLatched) {
  const auto robot = driving_robot(2);
  Rng rng{7};
  robot->spoil_bytes = [&](pioneer::Bytes bytes) {
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(rng.bits());
    return bytes;
  };
  EXPECT_LE(robot->time_to_braking(), 1.3);
  robot->run(3.0);
  EXPECT_TRUE(robot->stands());
  EXPECT_TRUE(robot->holds(Cause::BaseLost));
  EXPECT_TRUE(robot->decision.latched);
}

TEST(BaseRecovery, B2APowerCycleIsFoundOutAndNothingMovesBeforeAResume) {
  for (std::uint64_t time = 0; time < 100; ++time) {
    SCOPED_TRACE(time);
    const auto robot = driving_robot(time + 1);
    robot->run(0.025 * static_cast<double>(time % 8));
    const auto epoch = robot->base.odometry().state().epoch;
    const Pose2 before = robot->base.odometry().state().odom_from_base;
    robot->firmware().power_cycle(robot->now);
    ASSERT_EQ(robot->wheel_mps(), 0.0);
    const double way_m = robot->way_m;
    ASSERT_LE(robot->time_until([&] { return robot->holds(Cause::BaseLost) && robot->session.is_running(); }), 3.0);
    ASSERT_EQ(robot->base.odometry().state().epoch, epoch + 1);
    const Pose2 step = inverse(before) * robot->base.odometry().state().odom_from_base;
    ASSERT_LT(std::hypot(step.x, step.y), 0.1) << "the published pose goes on";
    robot->run(10.0);
    ASSERT_EQ(robot->way_m, way_m);
    ASSERT_TRUE(robot->decision.latched);
    ASSERT_EQ(robot->resume(), "");
    robot->run(4.0);
    ASSERT_GT(robot->forward_mps(), 0.1);
  }
}

TEST(BaseRecovery, B2APulledCableStopsTheWheelsByTheFirmwareAndPluggedInAgainNothingMoves) {
  const auto robot = driving_robot(3);
  robot->plug(false);
  EXPECT_LE(robot->time_to_braking(), 0.6) << "the watchdog of the firmware";
  robot->run(3.0);
  ASSERT_TRUE(robot->stands());
  const double way_m = robot->way_m;
  robot->plug(true);
  robot->run(10.0);
  EXPECT_TRUE(robot->session.is_running());
  EXPECT_EQ(robot->way_m, way_m) << "0 mm travelled after recovery";
  EXPECT_TRUE(robot->holds(Cause::BaseLost));
}

TEST(BaseRecovery, B3ABaseThatIsOffIsNeverReady) {
  SimulatedBase robot;
  robot.spoil_bytes = [](pioneer::Bytes) { return pioneer::Bytes{}; };
  EXPECT_LE(robot.time_until([&] { return count_of<pioneer::GaveUp>(robot) == 1; }), 3.0);
  EXPECT_FALSE(robot.session.is_running());
  EXPECT_TRUE(robot.holds(Cause::BaseNotThere));
  EXPECT_EQ(std::get<pioneer::GaveUp>(robot.events.front()).why, "no answer");
}

TEST(BaseRecovery, B4P2AFrozenBaseIsStoppedByTheFirmwareAndGoesOnFromStanding) {
  for (std::uint64_t time = 0; time < 100; ++time) {
    SCOPED_TRACE(time);
    const auto robot = driving_robot(time + 1);
    robot->run(0.025 * static_cast<double>(time % 8));
    robot->hosted = false;
    ASSERT_LE(robot->time_to_braking(), 0.6) << "watchdog and 100 ms";
    robot->run(2.0);
    ASSERT_TRUE(robot->stands());
    const double way_m = robot->way_m;
    robot->hosted = true;
    robot->run(10.0);
    ASSERT_EQ(robot->way_m, way_m) << "0 mm travelled after recovery";
    ASSERT_TRUE(robot->holds(Cause::ServiceFailed));
    ASSERT_TRUE(robot->decision.latched);
    ASSERT_EQ(robot->resume(), "");
    robot->run(4.0);
    ASSERT_GT(robot->forward_mps(), 0.1);
  }
}

TEST(BaseRecovery, B4AGapBelowAFreezeSendsVelocityZeroFirst) {
  const auto robot = driving_robot(1);
  robot->hosted = false;
  robot->run(0.8);
  robot->hosted = true;
  robot->run(0.1);
  EXPECT_EQ(count_of<pioneer::Gap>(*robot), 1);
  EXPECT_TRUE(robot->stands() || robot->wheel_mps() < 0.3);
}

TEST(BaseRecovery, P1TheNextProcessFindsAnOpenControllerAndStartsFromStanding) {
  const auto robot = driving_robot(1);
  SimulatedBase::Setup setup;
  const Time now = robot->now;
  // A second host takes over the line while the controller still drives at what the first one told.
  pioneer::Session next{session_config(setup.config)};
  next.link_opened(now);
  pioneer::Bytes said = next.take_output();
  static_cast<void>(robot->firmware().receive(said, now));
  robot->hosted = false;
  robot->run(1.5);
  EXPECT_TRUE(robot->stands()) << "its first words are velocity 0";
}

}  // namespace
}  // namespace tandem
