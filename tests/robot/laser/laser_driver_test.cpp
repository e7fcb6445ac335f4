#include "robot/laser/laser_driver.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/robot/laser/fake_tcp_sensor.hpp"

namespace tandem {
namespace {

using State = LaserCondition::State;

/// A driver and a sensor that take turns.
struct Pair {
  /// Steps both until `condition` holds; false after 20 s.
  bool step_until(const std::function<bool()>& condition) {
    const Time deadline = clock.now() + from_seconds(20.0);
    while (!condition() && clock.now() < deadline) {
      server.step();
      for (LaserReading& reading : driver.step()) readings.push_back(std::move(reading));
    }
    return condition();
  }
  bool step_until(State state) {
    return step_until([&] { return driver.condition().state == state; });
  }
  bool step_until_scans(std::size_t count) {
    readings.clear();
    return step_until([&] { return readings.size() >= count; });
  }

  FakeTcpSensor server;
  LaserConfig config{.device = server.device()};
  SteadyClock clock;
  LaserDriver driver{config, clock, clock};
  std::vector<LaserReading> readings;
};

TEST(LaserDriver, ReadsScansFromASensorOnTheNetwork) {
  Pair pair;
  ASSERT_TRUE(pair.step_until_scans(5)) << pair.driver.condition().reason;
  EXPECT_EQ(pair.driver.condition(), (LaserCondition{State::Streaming, ""}));
  EXPECT_EQ(pair.driver.identity(), "UTM-30LX, firmware 1.0, serial H1");
  for (std::size_t i = 0; i < pair.readings.size(); ++i) {
    ASSERT_EQ(pair.readings[i].ranges_m.size(), 361u);
    EXPECT_NEAR(pair.readings[i].ranges_m[180], 1.0, 0.0015);
    if (i == 0) continue;
    EXPECT_GT(pair.readings[i].first_beam, pair.readings[i - 1].first_beam);
  }
}

TEST(LaserDriver, WaitsForASensorThatIsNotThereYet) {
  Pair pair;
  pair.server.unplug();
  ASSERT_TRUE(pair.step_until(State::Lost));
  EXPECT_EQ(
      pair.driver.condition().reason,
      pair.config.device + ": connection refused: is the device (or the simulator) running, and is the port right?");
  pair.server.listen();
  EXPECT_TRUE(pair.step_until_scans(1));
}

TEST(LaserDriver, ComesBackAfterTheLaserWasUnplugged) {  // fault S1
  Pair pair;
  ASSERT_TRUE(pair.step_until_scans(3));
  pair.server.unplug();
  ASSERT_TRUE(pair.step_until(State::Lost));
  EXPECT_EQ(pair.driver.condition().reason, pair.config.device + ": closed by the other side");
  pair.server.listen();
  EXPECT_TRUE(pair.step_until_scans(3));
}

TEST(LaserDriver, ReconnectsToASensorThatFellSilent) {
  Pair pair;
  ASSERT_TRUE(pair.step_until_scans(1));
  pair.server.mute = true;
  ASSERT_TRUE(pair.step_until(State::Lost));
  EXPECT_NE(pair.driver.condition().reason.find("no scan for 1"), std::string::npos) << pair.driver.condition().reason;
  pair.server.mute = false;
  EXPECT_TRUE(pair.step_until_scans(1));
}

TEST(LaserDriver, FindsItsWayThroughGarbageOnTheLine) {
  Pair pair;
  pair.server.greeting = std::string(5000, '\xFF') + "\n99b\n\n" + std::string(10, '\0') + "MD00\n";
  EXPECT_TRUE(pair.step_until_scans(1)) << pair.driver.condition().reason;
  EXPECT_GT(pair.driver.damaged(), 0u);
}

TEST(LaserDriver, DarkensTheLaserWhenItStops) {
  Pair pair;
  ASSERT_TRUE(pair.step_until_scans(1));
  pair.driver.stop();
  for (int i = 0; i < 3; ++i) pair.server.step();
  EXPECT_TRUE(pair.server.sensor.heard.ends_with("MD QT")) << pair.server.sensor.heard;
}

TEST(LaserDriver, RefusesADeviceThatIsNone) {
  SteadyClock clock;
  LaserConfig config;
  config.device = "COM3";
  EXPECT_THROW((LaserDriver{config, clock, clock}), ConfigError);
}

}  // namespace
}  // namespace tandem
