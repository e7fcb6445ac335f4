// The rows of docs/safety.md that concern base and gate, at the wheels of the simulated robot: each a hundred times,
// with another moment and another noise each, in virtual time.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "tests/robot/pioneer/simulated_base.hpp"

namespace tandem {
namespace {

using safety::Cause;

constexpr int kTimes = 100;

/// How a row of the table is tried.
struct Row {
  std::function<void(SimulatedBase&)> begin;
  std::function<void(SimulatedBase&)> end;
  Cause cause;
  double within_s;  ///< From the fault to braking.
};

/// A robot that drives, at a moment of its own within the cycles of base, controller and laser.
std::unique_ptr<SimulatedBase> driving_robot(int time) {
  SimulatedBase::Setup setup;
  setup.seed = static_cast<std::uint64_t>(time) + 1;
  auto robot = std::make_unique<SimulatedBase>(setup);
  robot->reach_cruise();
  robot->run(0.025 * (time % 8));
  return robot;
}

/// Standing again after it was braking at 0.6 m/s^2 from 0.5 m/s.
constexpr double kBraking_s = 0.5 / 0.6 + 0.3;

void expect_to_stop_and_to_come_back(const Row& row) {
  const bool latched = rule_of(row.cause).resume == safety::Resume::Latched;
  for (int time = 0; time < kTimes; ++time) {
    SCOPED_TRACE(testing::Message() << "time " << time);
    const auto robot = driving_robot(time);
    robot->seen.reset();
    row.begin(*robot);
    ASSERT_LE(robot->time_to_braking(), row.within_s + 1e-9);
    ASSERT_LE(robot->time_to_standstill(), kBraking_s);
    robot->run(0.1);
    ASSERT_TRUE(robot->seen.test(index_of(row.cause))) << "another cause was faster";
    ASSERT_EQ(robot->decision.latched, latched);

    const bool lasts = robot->holds(row.cause);  // else the three seconds began with it
    row.end(*robot);
    const double stood_at_m = robot->way_m;
    robot->run(latched ? 10.0 : (lasts ? 4.5 : 3.4));
    ASSERT_EQ(robot->way_m, stood_at_m) << "moved too early, or without anybody's resume";
    if (latched) {
      ASSERT_EQ(robot->resume(), "");
      robot->run(1.9);
      ASSERT_EQ(robot->way_m, stood_at_m) << "2 s of warning";
    }
    robot->run(4.0);
    ASSERT_GT(robot->forward_mps(), 0.1) << "it must come back";
  }
}

TEST(BaseFaults, P3S1ALaserThatFallsSilentStopsTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) { r.spoil_scan = [](auto&) { return false; }; },
                                   [](auto& r) { r.spoil_scan = [](auto&) { return true; }; }, Cause::StaleScan, 0.5});
}

TEST(BaseFaults, P4CommandsThatCeaseStopTheWheels) {
  expect_to_stop_and_to_come_back(
      {[](auto& r) { r.commanding = false; }, [](auto& r) { r.commanding = true; }, Cause::StaleCommand, 0.5});
}

TEST(BaseFaults, P5APoseThatGoesStaleStopsTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) {
                                     r.localizing = false;
                                     r.input().pose.age_s = 0.525;  // what the feed says half a second later
                                   },
                                   [](auto& r) { r.localizing = true; }, Cause::StalePose, 0.2});
}

TEST(BaseFaults, P15N2N4ALinkThatIsGoneStopsTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) { r.input().link.silent_s = 1.525; },
                                   [](auto& r) { r.input().link.silent_s = 0.0; }, Cause::LinkLost, 0.1});
  expect_to_stop_and_to_come_back({[](auto& r) { r.input().link.silent_s = 10.1; },
                                   [](auto& r) { r.input().link.silent_s = 0.0; }, Cause::LinkLongLost, 0.1});
}

TEST(BaseFaults, P7PeopleUnknownCapTheSpeed) {
  for (int time = 0; time < kTimes; ++time) {
    const auto robot = driving_robot(time);
    robot->input().people.age_s = 0.525;
    ASSERT_LE(robot->time_to_braking(), 0.2);
    robot->run(1.0);
    ASSERT_NEAR(robot->forward_mps(), 0.3, 0.01);
  }
}

TEST(BaseFaults, S2AScanThatRepeatsItselfStopsTheWheels) {
  expect_to_stop_and_to_come_back(
      {[](auto& r) { r.spoil_scan = [same = r.ranges](auto& ranges) { return ranges = same, true; }; },
       [](auto& r) { r.spoil_scan = [](auto&) { return true; }; }, Cause::StuckScan, 1.2});
}

TEST(BaseFaults, S3AScanWithoutSenseStopsTheWheels) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const float value : {kNan, -1.0F, kInfinite, 30.0F, 0.0F, 4.0F}) {
    SCOPED_TRACE(value);
    expect_to_stop_and_to_come_back(
        {[=](auto& r) { r.spoil_scan = [=](auto& ranges) { return ranges.assign(ranges.size(), value), true; }; },
         [](auto& r) { r.spoil_scan = [](auto&) { return true; }; }, Cause::BadScan, 0.5});
  }
  expect_to_stop_and_to_come_back({[=](auto& r) {
                                     r.spoil_scan = [=](auto& ranges) {
                                       std::fill_n(ranges.begin(), ranges.size() * 4 / 10, kNan);
                                       return true;
                                     };
                                   },
                                   [](auto& r) { r.spoil_scan = [](auto&) { return true; }; }, Cause::BadScan, 0.5});
}

TEST(BaseFaults, S4AScanOfAWrongNumberOfRangesIsNone) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{29}, std::size_t{10'000}}) {
    SCOPED_TRACE(count);
    expect_to_stop_and_to_come_back(
        {[=](auto& r) { r.spoil_scan = [=](auto& ranges) { return ranges.assign(count, 4.0F), true; }; },
         [](auto& r) { r.spoil_scan = [](auto&) { return true; }; }, Cause::StaleScan, 0.5});
  }
}

TEST(BaseFaults, S5SomethingRightBeforeTheLaserStopsTheWheels) {
  for (int time = 0; time < kTimes; ++time) {
    const auto robot = driving_robot(time);
    robot->spoil_scan = [](auto& ranges) {  // a jacket over the middle
      std::fill(ranges.begin() + 100, ranges.begin() + 170, 0.04F);
      return true;
    };
    ASSERT_LE(robot->time_to_braking(), 0.3);
    ASSERT_LE(robot->time_to_standstill(), kBraking_s);
    ASSERT_TRUE(robot->holds(Cause::ObstacleAhead));
  }
}

TEST(BaseFaults, S6ALaserOfTooFewScansPerSecondStopsTheWheels) {
  const auto robot = driving_robot(0);
  int scans = 0;
  robot->spoil_scan = [&](auto&) { return ++scans % 4 == 0; };  // 2.5 a second
  robot->run(2.0);
  EXPECT_TRUE(robot->stands());
  EXPECT_TRUE(robot->seen.test(index_of(Cause::StaleScan)));
}

TEST(BaseFaults, B5ABumperStopsTheWheelsInTwoTenthsOfASecond) {
  for (const bool front : {true, false}) {
    expect_to_stop_and_to_come_back({[=](auto& r) { (front ? r.faults().front_bumpers : r.faults().rear_bumpers) = 4; },
                                     [](auto& r) { r.faults().front_bumpers = r.faults().rear_bumpers = 0; },
                                     Cause::Bumper, 0.2});
  }
}

TEST(BaseFaults, B5AStallStopsTheWheelsAndTheEndOfTheStallDoesNotStartThem) {
  for (const bool left : {true, false}) {
    expect_to_stop_and_to_come_back(
        {[=](auto& r) { (left ? r.faults().left_blocked : r.faults().right_blocked) = true; },
         [](auto& r) { r.faults().left_blocked = r.faults().right_blocked = false; }, Cause::Stall, 0.2});
  }
}

TEST(BaseFaults, B6TheStopButtonStopsTheWheelsAndItsReleaseDoesNotStartThem) {
  expect_to_stop_and_to_come_back({[](auto& r) { r.firmware().press_stop(true); },
                                   [](auto& r) { r.firmware().press_stop(false); }, Cause::EmergencyStop, 0.05});
}

TEST(BaseFaults, B6AButtonWiredToADigitalInputIsAnEmergencyStop) {
  SimulatedBase::Setup setup;
  setup.config.stop_inputs = 0x10;
  SimulatedBase robot{setup};
  robot.reach_cruise();
  robot.faults().digital_in = 0x0F;
  robot.run(1.0);
  ASSERT_FALSE(robot.stands()) << "other inputs are nothing";
  robot.faults().digital_in = 0x10;
  EXPECT_LE(robot.time_to_braking(), 0.2);
  robot.run(2.0);
  EXPECT_TRUE(robot.stands());
  EXPECT_TRUE(robot.holds(Cause::EmergencyStop));
}

TEST(BaseFaults, SAF11TheStopButtonStopsTheWheelsWhateverAProgramSends) {
  using pioneer::Command;
  using pioneer::command;
  const auto robot = driving_robot(0);
  robot->hosted = false;  // no gate: something that has run wild holds the line
  const auto run_wild = [&](double duration_s) {
    for (int i = 0; i < static_cast<int>(duration_s / to_seconds(SimulatedBase::kStep)); ++i) {
      for (const auto& bytes : {command(Command::Enable, 1), command(Command::Velocity, 500)}) {
        static_cast<void>(robot->world.base_receive(bytes, robot->now));
      }
      robot->step();
    }
  };
  run_wild(1.0);
  ASSERT_GT(robot->wheel_mps(), 0.45);
  robot->firmware().press_stop(true);
  run_wild(2.0);
  EXPECT_TRUE(robot->stands());
  const double way_m = robot->way_m;
  run_wild(5.0);
  EXPECT_EQ(robot->way_m, way_m) << "0 mm while it is pressed";
}

TEST(BaseFaults, B7AnEmptyBatteryStopsTheWheelsAfterFiveSeconds) {
  const auto robot = driving_robot(0);
  robot->faults().battery_v = 11.6;
  robot->run(15.0);
  EXPECT_TRUE(robot->decision.battery_warning);
  EXPECT_FALSE(robot->decision.battery_return);
  EXPECT_FALSE(robot->stands());
  robot->faults().battery_v = 10.5;
  EXPECT_LE(robot->time_to_braking(), 5.0);
  robot->run(2.0);
  EXPECT_TRUE(robot->stands());
  EXPECT_TRUE(robot->holds(Cause::LowBattery));
  EXPECT_TRUE(robot->decision.latched);
}

TEST(BaseFaults, B8EncodersThatCountNothingStopTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) { r.faults().encoders_dead = true; },
                                   [](auto& r) { r.faults().encoders_dead = false; }, Cause::EncoderDead, 1.2});
}

TEST(BaseFaults, B8AControllerThatRepeatsItsLastReportStopsTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) {
                                     r.spoil_bytes = [last = pioneer::Bytes{}](pioneer::Bytes bytes) mutable {
                                       if (last.empty()) last = bytes;
                                       return bytes.empty() ? bytes : last;
                                     };
                                   },
                                   [](auto& r) { r.spoil_bytes = [](pioneer::Bytes bytes) { return bytes; }; },
                                   Cause::EncoderDead, 1.2});
}

TEST(BaseFaults, B8AJumpOfTheOdometryStopsTheWheels) {
  expect_to_stop_and_to_come_back(
      {[](auto& r) { r.faults().odometry_offset.x += 0.8; }, [](auto&) {}, Cause::OdometryJump, 0.2});
}

TEST(BaseFaults, B9NonsenseIsRejectedAndTooMuchOfItStopsTheWheels) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const safety::Motion& nonsense :
       {safety::Motion{kNan, 0.0}, {0.1, kNan}, {kInfinite, 0.0}, {100.0, 0.0}, {0.0, -50.0}}) {
    const auto robot = driving_robot(0);
    robot->send_command(nonsense);
    robot->run(1.5);
    ASSERT_NEAR(robot->forward_mps(), 0.5, 0.01) << "one is nothing";
    for (int i = 0; i < 4; ++i) robot->send_command(nonsense);
    ASSERT_LE(robot->time_to_braking(), 0.5);
    robot->run(0.5);
    ASSERT_TRUE(robot->holds(Cause::BadCommand));
  }
}

TEST(BaseFaults, L1ALostPoseStopsTheWheels) {
  expect_to_stop_and_to_come_back({[](auto& r) {
                                     r.localizing = false;
                                     r.input().pose.lost = true;
                                   },
                                   [](auto& r) { r.localizing = true; }, Cause::LostPose, 0.1});
}

TEST(BaseFaults, H2APersonInTheStopZoneStopsTheWheels) {
  const std::vector<Eigen::Vector2d> close{{0.0, 0.8}};
  expect_to_stop_and_to_come_back({[&](auto& r) { r.input().people.in_base = close; },
                                   [](auto& r) { r.input().people.in_base = {}; }, Cause::PersonClose, 0.3});
}

TEST(BaseFaults, SAF8StopAndPauseStopTheWheels) {
  for (const bool latched : {true, false}) {
    expect_to_stop_and_to_come_back({[=](auto& r) { r.base.gate().take_stop(latched); }, [](auto&) {},
                                     latched ? Cause::StopRequested : Cause::PauseRequested, 0.1});
  }
}

}  // namespace
}  // namespace tandem
