#include "services/simulator/core/simulation.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

constexpr double kStep_s = 0.025;

Place hall() {
  return Place{test::ascii_map({"################", "#..............#", "#..............#", "#..............#",
                                "#..............#", "################"})};
}

Scene scene() {
  return {.robot_start = {2.5, 2.5, 0.0},
          .person_start = {2.5, 4.0, 0.0},
          .tokens_in_map = {Eigen::Vector2d{12.5, 2.5}, Eigen::Vector2d{12.6, 2.5}, Eigen::Vector2d{12.5, 2.6}}};
}

Simulation simulation(std::uint64_t seed, std::int64_t passers_by = 0) {
  SimulationOptions options;
  options.firmware.parameters = *pioneer::robot_parameters("p2at");
  options.passers_by = passers_by;
  options.seed = seed;
  return {options, hall(), scene(), std::make_unique<ObedientPerson>(), Time{}};
}

void drive(Simulation& world, int speed_mmps) {
  using pioneer::Command;
  using pioneer::command;
  for (const auto sync : {Command::Pulse, Command::Open, Command::Close, Command::Open}) {
    (void)world.firmware().receive(command(sync), Time{});
  }
  (void)world.firmware().receive(command(Command::Enable, 1), Time{});
  (void)world.firmware().receive(command(Command::Velocity, speed_mmps), Time{});
}

/// Steps the world for `seconds` with a host that only pulses.
void run(Simulation& world, double seconds, const Simulation::PhoneView& view = {}) {
  const Time start{};
  for (int i = 1; i * kStep_s <= seconds; ++i) {
    const Time now = start + from_seconds(i * kStep_s);
    (void)world.firmware().receive(pioneer::command(pioneer::Command::Pulse), now);
    world.step(kStep_s, now);
    (void)world.step_person(view, kStep_s, now);
  }
}

TEST(Simulation, TheRobotDrivesAndItsOdometryDrifts) {
  Simulation world = simulation(1);
  drive(world, 500);
  run(world, 10.0);
  EXPECT_GT(world.robot().map_from_body.x, 6.0);
  const Pose2 believed = scene().robot_start * world.firmware().odom_from_base();
  const double drift = (believed.position() - world.robot().map_from_body.position()).norm();
  EXPECT_GT(drift, 0.001);
  EXPECT_LT(drift, 0.5);
}

TEST(Simulation, AWallEndsTheDriveAndCountsAsACollision) {
  Simulation world = simulation(1);
  drive(world, 1000);
  run(world, 40.0);
  EXPECT_GE(world.collisions(), 1);
  EXPECT_LT(world.robot().map_from_body.x, 14.8);
}

TEST(Simulation, EqualSeedsGiveEqualEpisodes) {
  const auto episode = [](std::uint64_t seed) {
    Simulation world = simulation(seed, 2);
    drive(world, 300);
    run(world, 20.0, {.connected = true, .plan = PhonePlan{"a", {{2.5, 4.0}, {10.0, 4.0}}}});
    std::vector<double> all{world.robot().map_from_body.x, world.robot().map_from_body.heading};
    for (const auto& person : world.people()) all.push_back(person.map_from_body.x);
    const std::vector<Beam> beams{{0.0, 0.0}, {1.0, 0.5}};
    for (const double range : world.scan(beams)) all.push_back(range);
    return all;
  };
  EXPECT_EQ(episode(3), episode(3));
  EXPECT_NE(episode(3), episode(4));
}

TEST(Simulation, ThePersonWalksThePlanOnThePhoneAndFindsTheToken) {
  Simulation world = simulation(1);
  run(world, 40.0, {.connected = true, .plan = PhonePlan{"a", {{2.5, 4.0}, {11.5, 4.0}}}});
  EXPECT_TRUE(world.seen_by_person());
  ASSERT_EQ(world.people().size(), 1U);
  EXPECT_GT(world.people()[0].map_from_body.x, 9.0);
}

TEST(Simulation, TheLaserSeesThePersonsLegs) {
  Simulation world = simulation(1);
  const auto to_person = std::atan2(4.0 - 2.5 + 0.15, 2.5 - 2.66);  // the left leg, seen from the laser
  const std::vector<Beam> beams{{to_person, 0.0}};
  EXPECT_LT(world.scan(beams).front(), 1.75);
}

TEST(Simulation, WithoutAPersonNobodyIsThere) {
  SimulationOptions options;
  options.firmware.parameters = *pioneer::robot_parameters("p2at");
  Simulation world{options, hall(), scene(), nullptr, Time{}};
  EXPECT_FALSE(world.has_person());
  EXPECT_TRUE(world.people().empty());
  EXPECT_TRUE(world.step_person({.connected = true}, kStep_s, Time{}).empty());
}

}  // namespace
}  // namespace tandem::simulator
