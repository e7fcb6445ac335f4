#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "robot/safety/core/safety_gate.hpp"

namespace tandem::safety {

/// A gate in a healthy world: 20 cycles a second, ten scans a second, a commander, everybody far away. A test breaks
/// one thing in it.
class GateWorld {
 public:
  static constexpr int kBeams = 181;

  explicit GateWorld(const GateConfig& config = {}, std::vector<HardZone> zones = {})
      : config_(config), gate_(config, std::move(zones)) {
    input.base.connected = true;
    input.base.motors_enabled = true;
    input.base.battery_v = 12.5;
    input.base.watchdog_s = 0.5;
    input.base.deceleration_mps2 = 0.6;
    input.people.age_s = 0.0;
    input.pose.age_s = 0.0;
    input.link.silent_s = 0.0;
    ranges.assign(kBeams, 8.0F);
    ranges[0] = 7.9F;
  }

  /// One cycle of 50 ms.
  GateDecision cycle() {
    now += std::chrono::milliseconds{50};
    ++cycles_;
    if (scanning && cycles_ % 2 == 0) {
      ranges[1] = 7.0F + 0.001F * static_cast<float>(cycles_ % 100);  // no two scans are alike
      send_scan();
    }
    if (commanding) send_command(command);
    // The base follows at once, and odometry with it.
    if (wheels_turn) {
      input.base.measured = last.motion;
      const double heading = input.base.odom_from_base.heading;
      input.base.odom_from_base.x += 0.05 * last.motion.forward_mps * std::cos(heading);
      input.base.odom_from_base.y += 0.05 * last.motion.forward_mps * std::sin(heading);
    }
    if (follow_with_pose) input.pose = {.age_s = 0.0, .map_from_base = input.base.odom_from_base, .stamp = now};
    last = gate_.step(input, now);
    return last;
  }
  GateDecision run(double duration_s) {
    for (int i = 0; i < static_cast<int>(std::lround(duration_s * 20.0)); ++i) cycle();
    return last;
  }
  /// Healthy for so long that it drives as fast as it was told.
  void reach_cruise() { run(10.0); }

  void send_scan() {
    gate_.take_scan({.sequence_number = ++scan_number_,
                     .stamp = now,
                     .base_from_laser = {0.16, 0.0, 0.0},
                     .angle_min_rad = -std::numbers::pi / 2.0,
                     .angle_increment_rad = std::numbers::pi / (kBeams - 1),
                     .range_min_m = 0.02,
                     .range_max_m = 30.0,
                     .ranges_m = ranges},
                    input.base.odom_from_base, now);
  }
  void send_command(const Motion& motion, std::uint8_t commander = 1) {
    gate_.take_command({.commander = {commander}, .kind = kind, .sequence_number = ++command_number_, .motion = motion},
                       now);
  }
  /// A wall across the way, `ahead_m` before the hull's front.
  void put_wall_ahead(double ahead_m) {
    for (int i = 0; i < kBeams; ++i) {
      const double angle = -std::numbers::pi / 2.0 + i * std::numbers::pi / (kBeams - 1);
      const double range = (ahead_m + 0.313 - 0.16) / std::max(std::cos(angle), 1e-3);
      ranges[static_cast<std::size_t>(i)] = static_cast<float>(std::min(range, 8.0));
    }
  }
  void put_person(double x, double y) {
    people_ = {Eigen::Vector2d{x, y}};
    input.people.in_base = people_;
  }

  SafetyGate& gate() { return gate_; }

  GateInput input;
  std::vector<float> ranges;
  Motion command{0.5, 0.0};
  CommanderKind kind = CommanderKind::Program;
  bool scanning = true;
  bool commanding = true;
  bool wheels_turn = true;
  bool follow_with_pose = false;  ///< localization says where odometry is
  Time now{std::chrono::seconds{1'000'000}};
  GateDecision last;

 private:
  GateConfig config_;
  SafetyGate gate_;
  std::array<Eigen::Vector2d, 1> people_{};
  std::uint64_t scan_number_ = 0;
  std::uint64_t command_number_ = 0;
  int cycles_ = 0;
};

}  // namespace tandem::safety
