#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "robot/pioneer/gated_base.hpp"
#include "services/simulator/core/simulation.hpp"
#include "tests/support/ascii_map.hpp"

namespace tandem {

/// Driver and gate on a simulated Pioneer in a simulated hall, byte for byte, in time of its own: the world goes in
/// steps of 25 ms, the base cycles and is commanded 20 times a second, the laser scans ten times.
///
/// All is well at first; a test breaks one thing, and looks at the wheels.
class SimulatedBase {
 public:
  static constexpr Duration kStep = std::chrono::milliseconds{25};
  static constexpr int kBeams = 271;

  /// How the hall is, and the robot in it.
  struct Setup {
    BaseConfig config{};
    std::vector<safety::HardZone> zones{};
    Pose2 start{3.5, 5.5, 0.0};
    std::string model = "p2at";
    Duration watchdog = std::chrono::milliseconds{500};
    std::uint64_t seed = 1;
  };

  SimulatedBase() : SimulatedBase(Setup{}) {}
  explicit SimulatedBase(const Setup& setup)
      : base(setup.config, setup.zones, 1),
        session(session_config(setup.config)),
        world(options_of(setup), hall(), scene_of(setup), nullptr, now) {
    input().people.age_s = 0.0;
    input().link.silent_s = 0.0;
    session.link_opened(now);
  }

  /// Drives until it goes as fast as it is told.
  void reach_cruise() {
    run(12.0);
    ASSERT_NEAR(forward_mps(), command.forward_mps, 0.02) << "it must drive before anything can stop it";
  }
  void run(double duration_s) {
    for (const Time end = now + from_seconds(duration_s); now < end;) step();
  }
  /// Runs until `condition` holds; how long that took, or infinite after `longest_s` [s].
  template <typename Condition>
  double time_until(Condition condition, double longest_s = 10.0) {
    const Time begin = now;
    while (!condition()) {
      if (to_seconds(now - begin) > longest_s) return std::numeric_limits<double>::infinity();
      step();
    }
    return to_seconds(now - begin);
  }
  /// Time until the controller brakes [s]: its wheels lose speed by more than noise.
  double time_to_braking() {
    const double cruise = wheel_mps();
    if (cruise == 0.0) return 0.0;
    return time_until([&] { return wheel_mps() < cruise - 0.005; });
  }
  double time_to_standstill() {
    return time_until([&] { return stands(); });
  }

  void step() {
    now += kStep;
    ++steps_;
    world.step(to_seconds(kStep), now);
    if (const auto report = world.base_report(now); !report.empty()) to_host(report);
    if (hosted) exchange();
    if (hosted && (steps_ % 2 == 0 || base.is_urgent())) cycle();
    way_m += wheel_mps() * to_seconds(kStep);
  }

  /// The faster of the two wheels, whichever way it turns.
  [[nodiscard]] double wheel_mps() const {
    const auto wheels = world.wheels();
    return std::max(std::abs(wheels.left_mps), std::abs(wheels.right_mps));
  }
  [[nodiscard]] bool stands() const { return wheel_mps() == 0.0; }
  [[nodiscard]] double forward_mps() const { return world.robot().forward_mps; }
  [[nodiscard]] Pose2 map_from_base() const { return world.robot().map_from_body; }
  [[nodiscard]] bool holds(safety::Cause cause) const { return decision.causes.test(index_of(cause)); }
  [[nodiscard]] safety::GateInput& input() { return base.input(); }
  [[nodiscard]] simulator::PioneerFirmware& firmware() { return world.firmware(); }
  [[nodiscard]] simulator::ControllerFaults& faults() { return firmware().faults(); }
  [[nodiscard]] std::string_view resume() { return base.gate().take_resume(1.0, now); }

  /// Unplugs the cable, or plugs it in again.
  void plug(bool in) {
    plugged = in;
    in ? session.link_opened(now) : session.link_closed();
  }
  void send_command(const safety::Motion& motion, std::uint8_t commander = 1) {
    base.gate().take_command(
        {.commander = {commander}, .kind = kind, .sequence_number = ++command_number_, .motion = motion}, now);
  }
  void send_scan() {
    base.gate().take_scan({.sequence_number = ++scan_number_,
                           .stamp = now,
                           .base_from_laser = {0.16, 0.0, 0.0},
                           .angle_min_rad = kFirstAngle,
                           .angle_increment_rad = kIncrement,
                           .range_min_m = 0.02,
                           .range_max_m = 30.0,
                           .ranges_m = ranges},
                          input().base.odom_from_base, now);
  }

  Time now{std::chrono::seconds{1'000'000}};
  GatedBase base;
  pioneer::Session session;
  simulator::Simulation world;
  safety::GateDecision decision;
  safety::Causes seen;                        ///< all that have held since a test cleared it
  std::vector<pioneer::SessionEvent> events;  ///< of the session, all since the start
  safety::Motion command{0.5, 0.0};
  safety::CommanderKind kind = safety::CommanderKind::Program;
  std::vector<float> ranges;
  double way_m = 0.0;  ///< that the faster wheel has turned
  bool hosted = true;  ///< the base's process runs
  bool plugged = true;
  bool commanding = true;
  bool localizing = true;
  /// What reaches the gate in place of a good scan; none: no scan.
  std::function<bool(std::vector<float>&)> spoil_scan = [](auto&) { return true; };
  /// What reaches the driver in place of what the controller sent.
  std::function<pioneer::Bytes(pioneer::Bytes)> spoil_bytes = [](pioneer::Bytes bytes) { return bytes; };

 private:
  static constexpr double kFirstAngle = -0.75 * std::numbers::pi;
  static constexpr double kIncrement = 1.5 * std::numbers::pi / (kBeams - 1);

  static simulator::Place hall() {
    std::vector<std::string> rows(11, "#" + std::string(38, '.') + "#");
    rows.front() = rows.back() = std::string(40, '#');
    return simulator::Place{test::ascii_map(rows)};
  }
  static simulator::SimulationOptions options_of(const Setup& setup) {
    simulator::SimulationOptions options;
    options.firmware.parameters = *pioneer::robot_parameters(setup.model);
    options.firmware.identity.subclass = setup.model;
    options.firmware.watchdog = setup.watchdog;
    options.seed = setup.seed;
    return options;
  }
  static simulator::Scene scene_of(const Setup& setup) {
    simulator::Scene scene{};
    scene.robot_start = setup.start;
    return scene;
  }

  void to_host(const pioneer::Bytes& bytes) {
    if (plugged) session.receive(spoil_bytes(bytes), now);
  }
  void exchange() {
    const pioneer::Bytes bytes = session.take_output();
    if (plugged && !bytes.empty()) to_host(world.base_receive(bytes, now));
    for (const auto& event : session.take_events()) {
      base.take(event);
      events.push_back(event);
      if (std::holds_alternative<pioneer::GaveUp>(event)) session.link_opened(now);  // as the shell does, in a while
    }
  }
  void cycle() {
    if (commanding) send_command(command);
    if (steps_ % 4 == 0) scan();
    if (localizing) input().pose = {.age_s = 0.0, .lost = false, .map_from_base = map_from_base(), .stamp = now};
    decision = base.cycle(session, now);
    seen |= decision.causes;
    exchange();
  }
  void scan() {
    std::vector<simulator::Beam> beams(kBeams);
    for (int i = 0; i < kBeams; ++i) beams[static_cast<std::size_t>(i)].angle_rad = kFirstAngle + i * kIncrement;
    std::vector<float> measured;
    for (const double range : world.scan(beams)) measured.push_back(static_cast<float>(range));
    if (!spoil_scan(measured)) return;
    ranges = std::move(measured);
    send_scan();
  }

  std::uint64_t command_number_ = 0;
  std::uint64_t scan_number_ = 0;
  int steps_ = 0;
};

}  // namespace tandem
