#pragma once

#include <string>
#include <vector>

#include "robot/pioneer/base_config.hpp"
#include "robot/pioneer/core/odometry.hpp"
#include "robot/pioneer/core/session.hpp"
#include "robot/safety/core/safety_gate.hpp"

namespace tandem {

/// What the controller is set to, by the limits of the gate.
[[nodiscard]] pioneer::SessionConfig session_config(const BaseConfig& config);

/// The base without its device and without the bus: what the controller says goes in, the gate decides, and the session
/// is told. Everything that stands between a command and the wheels, so that tests drive it in their own time.
class GatedBase {
 public:
  GatedBase(const BaseConfig& config, std::vector<safety::HardZone> zones, std::uint32_t first_epoch);

  /// Takes what happened on the link.
  void take(const pioneer::SessionEvent& event);
  /// Asks the gate, and has `session` send what it lets through. Twenty times a second, and at once when is_urgent().
  safety::GateDecision cycle(pioneer::Session& session, Time now);

  /// Commands, scans and requests go in here.
  [[nodiscard]] safety::SafetyGate& gate() { return gate_; }
  /// What the gate looks at; all but the base's own part is filled in from outside.
  [[nodiscard]] safety::GateInput& input() { return input_; }
  [[nodiscard]] const safety::GateInput& input() const { return input_; }
  [[nodiscard]] const pioneer::Odometry& odometry() const { return odometry_; }
  [[nodiscard]] const pioneer::RobotParameters& parameters() const { return parameters_; }
  /// Subclass of the robot that answered; empty before the first did.
  [[nodiscard]] const std::string& model() const { return model_; }
  /// How old the odometry is when the first byte of its packet arrives.
  [[nodiscard]] Duration kinematics_delay() const { return kinematics_delay_; }
  /// Why this robot cannot be driven, with the remedy; empty if it can.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// Something happened that cannot wait for the next cycle.
  [[nodiscard]] bool is_urgent() const { return urgent_; }

 private:
  void take_identity(const pioneer::Identity& identity);
  void take_status(const pioneer::StatusReceived& status);

  BaseConfig config_;
  safety::SafetyGate gate_;
  safety::GateInput input_;
  pioneer::Odometry odometry_;
  pioneer::RobotParameters parameters_;
  std::string model_;
  std::string refusal_;
  Duration kinematics_delay_{};
  bool urgent_ = false;
};

}  // namespace tandem
