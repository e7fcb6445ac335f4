// Requirements SAF-1 to SAF-7 and SAF-10 of docs/safety.md, at the wheels of the simulated robot, in virtual time.
#include <gtest/gtest.h>

#include <memory>

#include "services/common/random.hpp"
#include "tests/robot/pioneer/simulated_base.hpp"

namespace tandem {
namespace {

using safety::Cause;
using safety::Hull;

constexpr double kQuantum_mps = 0.002;  ///< Velocities go over the wire in mm/s.

TEST(BaseLimits, SAF1SpeedAndAccelerationAtTheWheels) {
  SimulatedBase robot;
  robot.command = {1.9, 0.0};
  double last = 0.0;
  double fastest = 0.0;
  double hardest_braking = 0.0;
  for (int i = 0; i < 40 * 20; ++i) {
    if (i == 40 * 15) robot.command = {};
    robot.step();
    const double speed = robot.forward_mps();
    ASSERT_LE(speed - last, 0.3 * 0.025 + kQuantum_mps);
    hardest_braking = std::max(hardest_braking, last - speed);
    fastest = std::max(fastest, speed);
    last = speed;
  }
  EXPECT_NEAR(fastest, 0.5, kQuantum_mps);
  EXPECT_NEAR(hardest_braking, 0.6 * 0.025, kQuantum_mps);
  EXPECT_TRUE(robot.stands());
}

TEST(BaseLimits, SAF1TurnRateAtTheWheels) {
  SimulatedBase robot;
  robot.command = {0.0, 6.0};
  double fastest = 0.0;
  for (int i = 0; i < 40 * 12; ++i) {
    robot.step();
    fastest = std::max(fastest, robot.world.robot().turn_rate_radps);
  }
  EXPECT_LE(fastest, from_degrees(60.5));
  EXPECT_GT(fastest, from_degrees(55.0));
}

/// What SAF-2 allows with somebody at this distance from the hull.
double allowed_mps(double distance_m) {
  if (distance_m > 2.5) return 0.5;
  if (distance_m >= 1.2) return 0.4;
  return distance_m >= 0.6 ? 0.2 : 0.0;
}

TEST(BaseLimits, SAF2AThousandScenesWithAPersonWithoutAViolationBeyondACycleAndBraking) {
  constexpr std::uint64_t kSeed = 3;
  Rng rng{kSeed};
  auto robot = std::make_unique<SimulatedBase>();
  int close = 0;
  for (int scene = 0; scene < 1000; ++scene) {
    if (robot->map_from_base().x > 30.0 || scene % 20 == 0) {  // on from the start of the hall
      robot = std::make_unique<SimulatedBase>();
      robot->reach_cruise();
    }
    const std::vector<Eigen::Vector2d> person{{rng.uniform(-4.0, 4.0), rng.uniform(-4.0, 4.0)}};
    robot->input().people.in_base = person;
    const double allowed = allowed_mps(distance_to_hull(Hull{}, person[0]));
    const double from = robot->forward_mps();
    const double braking_s = std::max(0.0, from - allowed) / 0.6;
    robot->run(0.1 + 0.1 + braking_s);  // a cycle, the controller's own, and the ramp
    for (int i = 0; i < 20; ++i) {
      ASSERT_LE(robot->wheel_mps(), allowed + kQuantum_mps) << "seed " << kSeed << " scene " << scene;
      robot->step();
    }
    close += allowed == 0.0 ? 1 : 0;
    robot->input().people.in_base = {};
    robot->run(allowed == 0.0 ? 7.5 : 1.0);
  }
  EXPECT_GT(close, 30);
}

TEST(BaseLimits, SAF2S5ItStandsBeforeAWallWithRoomLeft) {
  for (std::uint64_t time = 0; time < 20; ++time) {
    SimulatedBase::Setup setup;
    setup.start = {25.0, 5.5, 0.02 * static_cast<double>(time) - 0.2};
    setup.seed = time + 1;
    SimulatedBase robot{setup};
    robot.run(60.0);
    ASSERT_LT(robot.wheel_mps(), 0.02);
    ASSERT_EQ(robot.world.collisions(), 0);
    const Eigen::Vector2d front = robot.map_from_base() * Eigen::Vector2d{0.313, 0.0};
    ASSERT_GT(39.0 - front.x(), 0.10) << "seed " << time + 1;
    ASSERT_LT(39.0 - front.x(), 0.30);
  }
}

TEST(BaseLimits, SAF2ObstacleToBrakingTakesThreeTenthsOfASecondAtMost) {
  for (std::uint64_t time = 0; time < 100; ++time) {
    SimulatedBase::Setup setup;
    setup.seed = time + 1;
    SimulatedBase robot{setup};
    robot.reach_cruise();
    robot.run(0.025 * static_cast<double>(time % 8));
    robot.spoil_scan = [](auto& ranges) {  // something stepped before the robot, 0.35 m from its front
      std::fill(ranges.begin() + 115, ranges.begin() + 156, 0.5F);
      return true;
    };
    ASSERT_LE(robot.time_to_braking(), 0.3);
  }
}

TEST(BaseLimits, SAF3WithLittleFreeWayItIsSlow) {
  SimulatedBase::Setup setup;
  setup.start = {30.0, 5.5, 0.0};
  SimulatedBase robot{setup};
  bool looked = false;
  robot.run(6.0);
  for (int i = 0; i < 40 * 40; ++i) {
    robot.step();
    const double free_m = 39.0 - robot.map_from_base().x - 0.313;
    if (free_m > 1.5 - 0.3) continue;  // braking from 0.5 to 0.3 m/s within a scan, a cycle and the ramp
    looked = true;
    ASSERT_LE(robot.forward_mps(), 0.3 + kQuantum_mps);
  }
  EXPECT_TRUE(looked);
}

TEST(BaseLimits, SAF4TurnsInPlaceSlowlyNearThingsAndNotAtAllTooNear) {
  const auto turning_at = [](double distance_m) {
    SimulatedBase robot;
    robot.command = {0.0, 1.0};
    robot.spoil_scan = [=](auto& ranges) {
      ranges[135] = static_cast<float>(distance_m - 0.16);  // ahead of the base's centre
      return true;
    };
    robot.run(12.0);
    return robot.world.robot().turn_rate_radps;
  };
  EXPECT_NEAR(turning_at(2.0), 1.0, 0.03);
  EXPECT_NEAR(turning_at(0.8), 0.5, 0.03) << "within 0.6 m of the hull";
  EXPECT_EQ(turning_at(0.48), 0.0) << "within 0.1 m of the circle of 0.4 m";
}

TEST(BaseLimits, SAF4ReversesForAnOperatorAloneAndALittle) {
  SimulatedBase robot;
  robot.command = {-0.5, 0.0};
  robot.run(12.0);
  EXPECT_EQ(robot.way_m, 0.0);
  robot.kind = safety::CommanderKind::Operator;
  double fastest = 0.0;
  for (int i = 0; i < 40 * 20; ++i) {
    robot.step();
    fastest = std::max(fastest, robot.wheel_mps());
  }
  EXPECT_NEAR(fastest, 0.1, kQuantum_mps);
  EXPECT_NEAR(robot.way_m, 0.3, 0.03);
  EXPECT_TRUE(robot.stands());
}

TEST(BaseLimits, SAF5B5AnOperatorBacksOutOfAPressedBumperAndNobodyElse) {
  for (const bool operated : {false, true}) {
    SimulatedBase robot;
    robot.reach_cruise();
    robot.faults().front_bumpers = 2;
    robot.run(3.0);
    ASSERT_TRUE(robot.stands());
    robot.kind = operated ? safety::CommanderKind::Operator : safety::CommanderKind::Program;
    robot.command = {-0.5, 0.3};
    robot.run(1.0);
    ASSERT_EQ(robot.resume(), operated ? "" : "a bumper touches something");
    const double x = robot.map_from_base().x;
    robot.run(1.9);
    ASSERT_NEAR(robot.map_from_base().x, x, 1e-9);
    robot.command = {0.5, 0.0};
    robot.run(2.0);
    ASSERT_NEAR(robot.map_from_base().x, x, 1e-9) << "never further in";
    robot.command = {-0.5, 0.3};
    robot.run(1.0);
    ASSERT_LE(robot.wheel_mps(), 0.1 + kQuantum_mps) << "straight and slowly";
    ASSERT_EQ(robot.map_from_base().x < x - 0.03, operated);
    if (!operated) continue;
    EXPECT_TRUE(robot.holds(Cause::Bumper)) << "it is still pressed, and said";
    robot.kind = safety::CommanderKind::Program;
    robot.run(0.5);
    EXPECT_TRUE(robot.stands());
    EXPECT_TRUE(robot.decision.latched) << "the leave was the operator's";
  }
}

TEST(BaseLimits, SAF6UnknownBrakesCapTheSpeed) {
  SimulatedBase::Setup setup;
  setup.watchdog = std::chrono::milliseconds{2000};  // as from the factory
  SimulatedBase robot{setup};
  robot.run(15.0);
  EXPECT_NEAR(robot.forward_mps(), 0.3, 0.01);
}

TEST(BaseLimits, SAF7NothingMovesAtStartForFiveSecondsAndMotorsAreOffUntilAskedToDrive) {
  SimulatedBase robot;
  robot.command = {};
  robot.run(20.0);
  EXPECT_FALSE(robot.input().base.motors_enabled);
  SimulatedBase eager;
  eager.run(5.0);
  EXPECT_EQ(eager.way_m, 0.0);
}

}  // namespace
}  // namespace tandem
