#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "robot/safety/core/command_monitor.hpp"
#include "robot/safety/core/gate_config.hpp"
#include "robot/safety/core/hard_zones.hpp"
#include "robot/safety/core/link_monitor.hpp"
#include "robot/safety/core/motion_monitor.hpp"
#include "robot/safety/core/odometry_trail.hpp"
#include "robot/safety/core/scan_monitor.hpp"
#include "robot/safety/core/speed_limits.hpp"
#include "robot/safety/core/stop_rules.hpp"
#include "robot/safety/core/stop_state.hpp"

namespace tandem::safety {

/// What localization says.
struct PoseInput {
  std::optional<double> age_s;  ///< since it came; none if there never was a pose
  bool lost = false;
  Pose2 map_from_base{};  ///< at `stamp`
  Time stamp{};
};

/// Everything the gate looks at in one cycle, besides the commands and scans it was given.
struct GateInput {
  BaseInput base;
  PeopleInput people;
  PoseInput pose;
  LinkInput link;
  bool other_base = false;  ///< another base service says that it is this robot's
  bool other_map = false;   ///< the host's map is not, or not yet, the one that the zones belong to
};

struct GateDecision {
  Motion motion;                 ///< what the wheels are told
  double speed_limit_mps = 0.0;  ///< whatever is asked for
  Causes causes;                 ///< why it stands, or stood until somebody resumes; none while free to move
  bool latched = false;
  double resume_in_s = 0.0;
  bool battery_warning = false;
  bool battery_return = false;  ///< low enough to go home at once
  Motion wanted;                ///< what was asked for
};

/// The last thing before the wheels: whatever is asked, they are told no more than is safe by the robot's own scan.
///
/// Values in, values out; knows no clock, no bus and no device. A cycle allocates nothing. See docs/safety.md.
class SafetyGate {
 public:
  /// `zones` are those of the map that poses are on.
  explicit SafetyGate(const GateConfig& config, std::vector<HardZone> zones = {});
  SafetyGate(const SafetyGate&) = delete;  // its parts share one config
  SafetyGate& operator=(const SafetyGate&) = delete;

  void take_command(const CommandSample& command, Time now) { commands_.take(command, now); }
  void take_scan(const ScanView& scan, const Pose2& odom_from_base, Time now) {
    scans_.take(scan, odom_from_base, now);
  }
  /// Somebody pressed STOP, or (not latched) asked for a pause.
  void take_stop(bool latched) { requested_.set(index_of(latched ? Cause::StopRequested : Cause::PauseRequested)); }
  /// This service died while the motors were on, or was frozen: nothing moves before somebody resumes.
  void take_service_failure() { requested_.set(index_of(Cause::ServiceFailed)); }
  /// Empty if granted, else why not.
  [[nodiscard]] std::string_view take_resume(double held_s, Time now) { return stops_.resume(held_s, now); }

  /// Decides for one cycle, 20 times a second and whenever the base reports a contact.
  [[nodiscard]] GateDecision step(const GateInput& input, Time now);

  [[nodiscard]] std::uint64_t rejected_commands() const { return commands_.rejected(); }

 private:
  [[nodiscard]] Causes causes_of(const GateInput& input, Time now);
  [[nodiscard]] Motion ramped(const Motion& wanted, double limit_mps, bool motors_enabled, Time now) const;
  [[nodiscard]] Motion without_reverse(Motion wanted) const;
  [[nodiscard]] Motion away_from_contact(Motion wanted, const BaseInput& base) const;
  [[nodiscard]] bool is_operated() const { return commands_.kind() == CommanderKind::Operator; }
  [[nodiscard]] bool has_pose(const PoseInput& pose) const;
  [[nodiscard]] PathLimit limited_by_way(const GateInput& input, const Motion& candidate, Time now,
                                         Causes& causes) const;

  const GateConfig config_;
  const Hull hull_;
  const std::vector<HardZone> zones_;
  CommandMonitor commands_;
  ScanMonitor scans_;
  MotionMonitor motion_;
  LinkMonitor link_;
  StopState stops_;
  OdometryTrail trail_;
  Causes requested_;  ///< momentary causes, until the next cycle
  Motion last_;
  Time last_time_{};
};

}  // namespace tandem::safety
