// `tandem teleop` as a process at a terminal of its own; at the other end the base's service, and the wheels of a
// simulated robot on a pseudo terminal.
#include <gtest/gtest.h>

#include <cmath>

#include "robot/pioneer/base_service.hpp"
#include "services/simulator/wire/base_server.hpp"
#include "tests/services/cli/on_terminal.hpp"
#include "tests/support/ascii_map.hpp"
#include "tests/support/domain_lease.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tandem::cli {
namespace {

using test::expect_restored;

/// A robot in a hall, with its base's service and a laser that sees far; all of it moves in step().
class Robot {
 public:
  Robot()
      : world_(options(), simulator::Place{test::ascii_map(hall())}, scene(), nullptr, clock_.now()),
        server_("", 0, port_ / "pioneer"),
        bus_(bus::host_domain(site(), "base")),
        service_(config(), {}, site(), bus_, clock_, clock_),
        scans_(bus_.writer(topic::kScan)),
        last_(clock_.now()) {}

  void step() {
    const Time now = clock_.now();
    world_.step(to_seconds(now - last_), now);
    last_ = now;
    server_.receive(world_, now);
    server_.report(world_, now);
    scan(now);
    service_.step();
  }
  /// Steps until `condition` holds, ten seconds at most.
  template <typename Condition>
  bool runs_until(Condition condition) {
    const Time latest = clock_.now() + std::chrono::seconds{10};
    while (!condition() && clock_.now() < latest) step();
    return condition();
  }
  [[nodiscard]] double wheel_mps() const {
    const auto wheels = world_.wheels();
    return std::max(std::abs(wheels.left_mps), std::abs(wheels.right_mps));
  }
  [[nodiscard]] bus::Bus& bus() { return bus_; }
  [[nodiscard]] SiteConfig site() const {
    SiteConfig site;
    site.host_domain = domain_[0];
    return site;
  }
  [[nodiscard]] std::vector<std::string> words() const {
    return {"teleop", "--domain", std::to_string(domain_[0]), "--speed", "0.25"};
  }

 private:
  static std::vector<std::string> hall() {
    std::vector<std::string> rows(11, "#" + std::string(38, '.') + "#");
    rows.front() = rows.back() = std::string(40, '#');
    return rows;
  }
  static simulator::Scene scene() {
    simulator::Scene scene{};
    scene.robot_start = {3.5, 5.5, 0.0};
    return scene;
  }
  static simulator::SimulationOptions options() {
    simulator::SimulationOptions options;
    options.firmware.parameters = *pioneer::robot_parameters("p2at");
    options.firmware.watchdog = std::chrono::milliseconds{500};
    return options;
  }
  [[nodiscard]] BaseConfig config() const {
    BaseConfig config;
    config.device = port_ / "pioneer";
    config.gate.require_link = false;
    config.gate.healthy_s = 0.0;
    config.gate.warning_s = 0.5;
    return config;
  }
  void scan(Time now) {
    msg::LaserScan scan;
    scan.robot(site().robot);
    scan.sequence_number(++scan_number_);
    scan.stamp_ns(to_stamp_ns(now));
    scan.angle_min_rad(-1.5);
    scan.angle_increment_rad(0.0166);
    scan.range_max_m(30.0);
    scan.ranges_m(std::vector<float>(181, 8.0F));
    scan.ranges_m()[90] = 7.0F + 0.01F * static_cast<float>(scan_number_ % 10);
    scans_.write(scan);
  }

  test::DomainLease domain_{1};
  test::TemporaryFolder port_;
  SteadyClock clock_;
  simulator::Simulation world_;
  simulator::BaseServer server_;
  bus::Bus bus_;
  BaseService service_;
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  std::uint64_t scan_number_ = 0;
  Time last_;
};

/// Holds `w` until the wheels turn fast.
void drive_off(Robot& robot, test::OnTerminal& terminal) {
  ASSERT_TRUE(robot.runs_until([&] { return terminal.drawn().find("free to move") != std::string::npos; }))
      << terminal.drawn();
  ASSERT_TRUE(robot.runs_until([&] {
    terminal.press('w');
    return robot.wheel_mps() > 0.2;
  }));
}
bool comes_to_a_stand(Robot& robot) {
  return robot.runs_until([&] { return robot.wheel_mps() == 0.0; });
}

TEST(TeleopCommand, DrivesWhileAKeyIsHeldAndStandsOnceItIsLetGo) {
  Robot robot;
  test::OnTerminal terminal{robot.words()};
  drive_off(robot, terminal);
  EXPECT_FALSE(terminal.is_as_before());
  EXPECT_TRUE(comes_to_a_stand(robot)) << "nobody presses anything";
  EXPECT_NE(terminal.drawn().find("motors on, battery 12.8 V"), std::string::npos);
  terminal.press('x');
  EXPECT_EQ(terminal.exit_code(), 0);
  expect_restored(terminal);
}

TEST(TeleopCommand, EverySignalThatEndsItLeavesTheRobotStandingAndTheTerminalAsItWas) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Robot robot;
    test::OnTerminal terminal{robot.words()};
    drive_off(robot, terminal);
    terminal.send_signal(signal);
    EXPECT_EQ(terminal.exit_code(), 0);
    expect_restored(terminal);
    EXPECT_TRUE(comes_to_a_stand(robot));
  }
}

TEST(TeleopCommand, GivesWayToWhoeverElseCommandsAndNeverFights) {
  Robot robot;
  test::OnTerminal terminal{robot.words()};
  drive_off(robot, terminal);
  auto commands = robot.bus().writer(topic::kVelocityCommand);
  msg::VelocityCommand command;
  command.robot(robot.site().robot);
  command.commander("navigator");
  const auto navigate = [&] {
    command.sequence_number(command.sequence_number() + 1);
    command.forward_mps(0.2);
    commands.write(command);
  };
  EXPECT_TRUE(robot.runs_until([&] {
    navigate();
    terminal.press('w');
    return terminal.drawn().find("\"navigator\" is driving the robot") != std::string::npos;
  }));
  EXPECT_EQ(terminal.exit_code(), 1);
  expect_restored(terminal);

  test::OnTerminal second{robot.words()};
  EXPECT_TRUE(robot.runs_until([&] {
    navigate();
    return second.drawn().find("\"navigator\" is driving the robot") != std::string::npos;
  })) << "nor does it begin";
  EXPECT_EQ(second.exit_code(), 1);
  EXPECT_EQ(second.drawn().find("hold a key"), std::string::npos);
}

TEST(TeleopCommand, RefusesWhileASearchIsRunning) {
  Robot robot;
  auto sessions = robot.bus().writer(topic::kSession);
  msg::SessionState session;
  session.robot(robot.site().robot);
  session.phase(msg::SESSION_RUNNING);
  sessions.write(session);
  test::OnTerminal terminal{robot.words()};
  EXPECT_TRUE(robot.runs_until([&] { return terminal.drawn().find("end the session first") != std::string::npos; }));
  EXPECT_EQ(terminal.exit_code(), 1);
}

TEST(TeleopCommand, NeedsATerminal) {
  EXPECT_EQ(WEXITSTATUS(std::system(TANDEM_BINARY_DIR "/bin/tandem teleop < /dev/null > /dev/null 2>&1")), 2);
}

}  // namespace
}  // namespace tandem::cli
