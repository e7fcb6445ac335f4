#include "services/simulator/core/pioneer_firmware.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::simulator {
namespace {

using pioneer::Bytes;
using pioneer::Command;

constexpr int kHandshakeDone = 3;
constexpr std::uint8_t kRotate = 9;  ///< Old duplicate of RVEL.

void append(Bytes& all, const Bytes& more) {
  all.insert(all.end(), more.begin(), more.end());
}

Bytes sync_reply(std::uint8_t type) {
  return pioneer::framed(pioneer::Packet{type, {}, {}});
}

}  // namespace

PioneerFirmware::PioneerFirmware(FirmwareOptions options, Time now)
    : options_(std::move(options)),
      last_packet_(now),
      next_report_(now),
      stalled_until_(now),
      max_speed_mps_(options_.parameters.max_speed_mps),
      max_turn_rate_radps_(options_.parameters.max_turn_rate_radps) {}

Bytes PioneerFirmware::receive(std::span<const std::uint8_t> bytes, Time now) {
  Bytes answers;
  receiver_.push(bytes, now);
  while (const auto packet = receiver_.next()) {
    last_packet_ = now;
    if (!open_) {
      append(answers, synchronize(*packet, now));
    } else if (const auto command = pioneer::decode_command(*packet)) {
      append(answers, obey(*command));
    }
  }
  return answers;
}

Bytes PioneerFirmware::synchronize(const pioneer::Packet& packet, Time now) {
  if (packet.number == 0 && packet.body.empty()) {
    next_sync_ = 1;
    return sync_reply(pioneer::packet_type::kSync0);
  }
  if (packet.number > 2) return {};  // an idle controller ignores what is no handshake
  if (next_sync_ == kHandshakeDone && packet.number == static_cast<std::uint8_t>(Command::Open)) {
    open_ = true;
    next_report_ = now + options_.sip_cycle;
    return {};
  }
  if (!packet.body.empty()) return {};  // CLOSE with an argument: there is nothing to close
  if (packet.number != next_sync_) {
    next_sync_ = 0;
    return sync_reply(pioneer::packet_type::kSyncCounterOff);
  }
  ++next_sync_;
  if (packet.number == 1) return sync_reply(pioneer::packet_type::kSync1);
  return pioneer::framed(pioneer::encode_identity(options_.identity));
}

Bytes PioneerFirmware::obey(const pioneer::HostCommand& command) {
  const int value = command.integer_or(0);
  const double value_si = value / 1000.0;
  const auto number = command.number == kRotate ? Command::TurnRate : static_cast<Command>(command.number);
  switch (number) {
    case Command::Close:
      close();
      break;
    case Command::Enable:
      motors_on_ = value != 0 && !stop_pressed_;
      break;
    case Command::Velocity:
      way_to_go_m_.reset();
      told_.forward_mps = std::clamp(value_si, -max_speed_mps_, max_speed_mps_);
      break;
    case Command::TurnRate:
      heading_setpoint_.reset();
      told_.turn_rate_radps = std::clamp(from_degrees(value), -max_turn_rate_radps_, max_turn_rate_radps_);
      break;
    case Command::Move:
      way_to_go_m_ = value_si;
      break;
    case Command::Heading:
      heading_setpoint_ = from_degrees(value);
      break;
    case Command::DeltaHeading:
      heading_setpoint_ = wrap_to_pi(odom_from_base_.heading + from_degrees(value));
      break;
    case Command::DeltaHeadingFromSetpoint:
      heading_setpoint_ = wrap_to_pi(heading_setpoint_.value_or(odom_from_base_.heading) + from_degrees(value));
      break;
    case Command::WheelVelocities: {
      forget_goals();
      const double unit_mps = options_.parameters.wheel_speed_step_mmps / 1000.0;
      const std::uint16_t both = command.packed_bytes();
      const auto left = static_cast<std::int8_t>(both >> 8u);
      const auto right = static_cast<std::int8_t>(both & 0xFFu);
      const BodySpeed asked = body_of({left * unit_mps, right * unit_mps}, half_track_m());
      told_ = {std::clamp(asked.forward_mps, -max_speed_mps_, max_speed_mps_),
               std::clamp(asked.turn_rate_radps, -max_turn_rate_radps_, max_turn_rate_radps_)};
      break;
    }
    case Command::Stop:
      forget_goals();
      told_ = {};
      break;
    case Command::EmergencyStop:
    case Command::QuickStop:
      forget_goals();
      told_ = {};
      speed_ = {};
      break;
    case Command::SetTranslationalAcceleration:
      if (value != 0) (value > 0 ? acceleration_mps2_ : deceleration_mps2_) = std::abs(value_si);
      break;
    case Command::SetTurnAcceleration:
      if (value != 0)
        (value > 0 ? turn_acceleration_radps2_ : turn_deceleration_radps2_) = from_degrees(std::abs(value));
      break;
    case Command::SetMaxSpeed:
      max_speed_mps_ = std::min(std::abs(value_si), options_.parameters.max_speed_mps);
      break;
    case Command::SetMaxTurnRate:
      max_turn_rate_radps_ = std::min(from_degrees(std::abs(value)), options_.parameters.max_turn_rate_radps);
      break;
    case Command::SetOrigin:
      odom_from_base_ = {};
      heading_setpoint_.reset();
      break;
    case Command::Sonar:
      sonar_on_ = (value & 1) != 0;
      break;
    case Command::Config:
      return config_packet();
    case Command::Encoder:
      return start(encoder_stream_, value, encoder_packet());
    case Command::IoRequest:
      return start(io_stream_, value, io_packet());
    case Command::Gyro:
      gyro_on_ = options_.has_gyro && value == 1;
      break;
    case Command::DigitalOut: {
      const std::uint16_t both = command.packed_bytes();
      const auto mask = static_cast<std::uint8_t>(both >> 8u);
      digital_out_ = static_cast<std::uint8_t>((digital_out_ & ~mask) | (both & mask));
      break;
    }
    case Command::AnalogSelect:
      analog_port_ = static_cast<std::uint8_t>(value);
      break;
    case Command::BatteryTest:
      tested_battery_v_ = value > 0 ? std::optional{0.1 * value} : std::nullopt;
      break;
    default:  // PULSE, a second OPEN, and all that this robot does not have
      break;
  }
  return {};
}

Bytes PioneerFirmware::start(bool& stream, int value, const Bytes& one) const {
  stream = value >= 2;
  return value == 1 ? one : Bytes{};
}

void PioneerFirmware::forget_goals() {
  way_to_go_m_.reset();
  heading_setpoint_.reset();
}

void PioneerFirmware::steer_to_goals() {
  if (way_to_go_m_) {
    const double stopping_mps = std::sqrt(2.0 * deceleration_mps2_ * std::abs(*way_to_go_m_));
    told_.forward_mps = std::copysign(std::min(max_speed_mps_, stopping_mps), *way_to_go_m_);
  }
  if (heading_setpoint_) {
    constexpr double kGain = 2.0;  // [1/s]
    const double left_rad = turn_between(odom_from_base_.heading, *heading_setpoint_);
    told_.turn_rate_radps = std::clamp(kGain * left_rad, -max_turn_rate_radps_, max_turn_rate_radps_);
  }
}

void PioneerFirmware::close() {
  open_ = false;
  encoder_stream_ = io_stream_ = gyro_on_ = false;
  forget_goals();
  motors_on_ = false;
  next_sync_ = 0;
  told_ = {};
}

BodySpeed PioneerFirmware::drive(double dt_s, Time now) {
  if (!motors_on_) return speed_ = {};
  steer_to_goals();
  const bool silent = now - last_packet_ > options_.watchdog;
  // What was told last is only put aside: packets, or the end of the stall, bring it back.
  BodySpeed target = silent || is_stalled(now) ? BodySpeed{} : told_;
  if ((faults_.left_blocked || faults_.right_blocked) && target != BodySpeed{}) {
    stall(faults_.left_blocked, faults_.right_blocked, now);
    target = {};
  }
  speed_.forward_mps =
      ramped(speed_.forward_mps, target.forward_mps, acceleration_mps2_ * dt_s, deceleration_mps2_ * dt_s);
  speed_.turn_rate_radps = ramped(speed_.turn_rate_radps, target.turn_rate_radps, turn_acceleration_radps2_ * dt_s,
                                  turn_deceleration_radps2_ * dt_s);
  return speed_;
}

void PioneerFirmware::settle(const Pose2& wheel_motion, const Moved& moved, Time now) {
  contact_ = moved.contact;
  if (moved.blocked) {
    stall(true, true, now);
    return;
  }
  const double turning_m = wheel_motion.heading * half_track_m();
  const double way_m = std::copysign(std::hypot(wheel_motion.x, wheel_motion.y), wheel_motion.x);
  if (way_to_go_m_) *way_to_go_m_ -= way_m;
  if (faults_.encoders_dead) return;
  odom_from_base_ = odom_from_base_ * wheel_motion;
  left_way_m_ += way_m - turning_m;
  right_way_m_ += way_m + turning_m;
}

void PioneerFirmware::stall(bool left, bool right, Time now) {
  stalled_until_ = now + options_.stall_time;
  left_stalled_ = left;
  right_stalled_ = right;
  speed_ = {};
}

void PioneerFirmware::press_stop(bool pressed) {
  stop_pressed_ = pressed;
  if (pressed) motors_on_ = false;
}

void PioneerFirmware::power_cycle(Time now) {
  *this = PioneerFirmware{options_, now};
}

}  // namespace tandem::simulator
