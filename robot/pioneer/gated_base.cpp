#include "robot/pioneer/gated_base.hpp"

#include <cmath>
#include <utility>

#include "services/common/angle.hpp"

namespace tandem {
namespace {

constexpr Duration kFrozen = std::chrono::seconds{1};

}  // namespace

pioneer::SessionConfig session_config(const BaseConfig& config) {
  const auto rounded = [](double value) { return static_cast<int>(std::lround(value)); };
  const auto& gate = config.gate;
  return {.max_speed_mmps = rounded(1000.0 * gate.max_speed_mps),
          .max_turn_rate_degps = rounded(to_degrees(gate.max_turn_rate_radps)),
          .acceleration_mmps2 = rounded(1000.0 * gate.acceleration_mps2),
          .deceleration_mmps2 = rounded(1000.0 * gate.deceleration_mps2),
          .turn_acceleration_degps2 = rounded(to_degrees(gate.turn_acceleration_radps2)),
          .sonar = config.sonar};
}

GatedBase::GatedBase(const BaseConfig& config, std::vector<safety::HardZone> zones, std::uint32_t first_epoch)
    : config_(config), gate_(config.gate, std::move(zones)), odometry_(config.odometry, first_epoch, config.wheels) {}

void GatedBase::take(const pioneer::SessionEvent& event) {
  if (const auto* identified = std::get_if<pioneer::Identified>(&event)) take_identity(identified->identity);
  if (const auto* status = std::get_if<pioneer::StatusReceived>(&event)) take_status(*status);
  if (const auto* gyro = std::get_if<pioneer::GyroReceived>(&event)) odometry_.take(gyro->readings);
  if (const auto* configured = std::get_if<pioneer::Configured>(&event)) {
    input_.base.watchdog_s = configured->config.watchdog_ms / 1000.0;
    input_.base.deceleration_mps2 = configured->config.deceleration / 1000.0;
    kinematics_delay_ = std::chrono::milliseconds{configured->config.kinematics_delay_ms};
  }
  if (const auto* gap = std::get_if<pioneer::Gap>(&event); gap != nullptr && gap->silent > kFrozen) {
    gate_.take_service_failure();
  }
}

void GatedBase::take_identity(const pioneer::Identity& identity) {
  const auto* known = pioneer::robot_parameters(identity.subclass);
  const bool calibrated = config_.metres_per_count > 0.0 && config_.half_track_per_m > 0.0;
  refusal_.clear();
  if (known == nullptr && !calibrated) {
    refusal_ = "unknown robot model \"" + identity.subclass +
               "\": calibrate it and set metres_per_count and half_track_per_m in base.toml";
    return;
  }
  parameters_ = known != nullptr ? *known : pioneer::RobotParameters{};
  if (config_.metres_per_count > 0.0) parameters_.metres_per_count = config_.metres_per_count;
  if (config_.half_track_per_m > 0.0) parameters_.half_track_per_m = config_.half_track_per_m;
  model_ = identity.subclass;
  odometry_.restart(parameters_);
  input_.base.watchdog_s = input_.base.deceleration_mps2 = 0.0;  // until it says
}

void GatedBase::take_status(const pioneer::StatusReceived& status) {
  const auto& sip = status.sip;
  const auto& odometry = odometry_.take(sip, status.first_byte);
  auto& base = input_.base;
  base.estop_pressed = sip.stop_pressed() || (sip.digital_in.value_or(0) & config_.stop_inputs) != 0;
  urgent_ = urgent_ || sip.left_stalled || sip.right_stalled || sip.front_bumpers != 0 || sip.rear_bumpers != 0 ||
            base.estop_pressed || odometry.jumped;
  base.motors_enabled = sip.motors_enabled();
  base.left_stalled = sip.left_stalled;
  base.right_stalled = sip.right_stalled;
  base.front_bumpers = sip.front_bumpers;
  base.rear_bumpers = sip.rear_bumpers;
  base.battery_v = sip.battery_v();
  base.odom_from_base = odometry.odom_from_base;
  base.odometry_epoch = odometry.epoch;
  base.odometry_jumped = base.odometry_jumped || odometry.jumped;
  base.measured = {odometry.velocity.forward_mps, odometry.velocity.turn_rate_radps};
}

safety::GateDecision GatedBase::cycle(pioneer::Session& session, Time now) {
  urgent_ = false;
  input_.base.connected = session.is_running();
  if (!input_.base.connected) input_.base.motors_enabled = false;
  const safety::GateDecision decision = gate_.step(input_, now);
  input_.base.odometry_jumped = false;
  session.drive(decision.motion.forward_mps, decision.motion.turn_rate_radps);
  session.step(now);
  return decision;
}

}  // namespace tandem
