#include "services/simulator/core/pioneer_firmware.hpp"

#include <algorithm>
#include <cmath>

#include "robot/pioneer/core/config_packet.hpp"

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

/// The low 15 bits of a counter that counts `way_m`.
std::uint16_t counter(double way_m, double metres_per_count) {
  return static_cast<std::uint16_t>(static_cast<std::int64_t>(std::floor(way_m / metres_per_count)) & 0x7FFF);
}

std::uint16_t milli(double value) {
  return static_cast<std::uint16_t>(std::lround(value * 1000.0));
}
std::uint16_t degrees(double value_rad) {
  return static_cast<std::uint16_t>(std::lround(to_degrees(value_rad)));
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
      told_.forward_mps = std::clamp(value_si, -max_speed_mps_, max_speed_mps_);
      break;
    case Command::TurnRate:
      told_.turn_rate_radps = std::clamp(from_degrees(value), -max_turn_rate_radps_, max_turn_rate_radps_);
      break;
    case Command::WheelVelocities: {
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
      told_ = {};
      break;
    case Command::EmergencyStop:
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
      break;
    case Command::Sonar:
      sonar_on_ = (value & 1) != 0;
      break;
    case Command::Config:
      return config_packet();
    case Command::BatteryTest:
      tested_battery_v_ = value > 0 ? std::optional{0.1 * value} : std::nullopt;
      break;
    default:  // PULSE, a second OPEN, and all that this robot does not have
      break;
  }
  return {};
}

void PioneerFirmware::close() {
  open_ = false;
  motors_on_ = false;
  next_sync_ = 0;
  told_ = {};
}

BodySpeed PioneerFirmware::drive(double dt_s, Time now) {
  if (!motors_on_) return speed_ = {};
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
  } else if (!faults_.encoders_dead) {
    odom_from_base_ = odom_from_base_ * wheel_motion;
  }
}

void PioneerFirmware::stall(bool left, bool right, Time now) {
  stalled_until_ = now + options_.stall_time;
  left_stalled_ = left;
  right_stalled_ = right;
  speed_ = {};
}

Bytes PioneerFirmware::report(std::vector<pioneer::SonarEcho> echoes, Time now) {
  next_report_ += options_.sip_cycle;
  if (next_report_ <= now) next_report_ = now + options_.sip_cycle;
  const auto& parameters = options_.parameters;
  const WheelSpeeds wheels = faults_.encoders_dead ? WheelSpeeds{} : wheels_of(speed_, half_track_m());
  const Pose2 counted{odom_from_base_.x + faults_.odometry_offset.x, odom_from_base_.y + faults_.odometry_offset.y,
                      wrap_to_pi(odom_from_base_.heading + faults_.odometry_offset.heading)};
  const double battery_v = tested_battery_v_.value_or(faults_.battery_v.value_or(options_.battery_v));
  pioneer::Sip sip;
  sip.moving = wheels != WheelSpeeds{};
  sip.x = counter(counted.x, parameters.metres_per_count);
  sip.y = counter(counted.y, parameters.metres_per_count);
  sip.heading = static_cast<std::int16_t>(std::lround(counted.heading / parameters.radians_per_count));
  sip.left_velocity = static_cast<std::int16_t>(std::lround(wheels.left_mps / parameters.mps_per_count));
  sip.right_velocity = static_cast<std::int16_t>(std::lround(wheels.right_mps / parameters.mps_per_count));
  sip.battery = static_cast<std::uint8_t>(std::clamp(std::lround(battery_v * 10.0), 0L, 255L));
  sip.left_stalled = is_stalled(now) && left_stalled_;
  sip.right_stalled = is_stalled(now) && right_stalled_;
  constexpr std::uint8_t kMiddleSegment = 1u << 2;
  sip.front_bumpers = faults_.front_bumpers | (contact_.front ? kMiddleSegment : std::uint8_t{0});
  sip.rear_bumpers = faults_.rear_bumpers | (contact_.rear ? kMiddleSegment : std::uint8_t{0});
  sip.control = sip.heading;
  sip.flags = static_cast<std::uint16_t>(
      (motors_on_ ? pioneer::sip_flag::kMotorsEnabled : 0) | (sonar_on_ ? pioneer::sip_flag::kSonarArray1 : 0) |
      (sonar_on_ ? pioneer::sip_flag::kSonarArray2 : 0) | (stop_pressed_ ? pioneer::sip_flag::kStopPressed : 0));
  sip.sonar = std::move(echoes);
  sip.gripper_state = 0;
  sip.analog_port = 0;
  sip.analog = 0;
  sip.digital_in = 0;
  sip.digital_out = 0;
  return pioneer::framed(pioneer::encode_sip(sip));
}

Bytes PioneerFirmware::config_packet() const {
  const auto& parameters = options_.parameters;
  pioneer::ConfigPacket config;
  config.type = options_.identity.robot_class;
  config.subtype = options_.identity.subclass;
  config.serial_number = "SIM0001";
  config.four_motors = parameters.skid_steer ? 1 : 0;
  config.top_turn_rate = degrees(parameters.max_turn_rate_radps);
  config.top_speed = milli(parameters.max_speed_mps);
  config.top_turn_acceleration = 300;
  config.top_acceleration = 2000;
  config.max_pwm = 500;
  config.name = options_.identity.name;
  config.sip_cycle_ms =
      static_cast<std::uint8_t>(std::min<std::int64_t>(options_.sip_cycle / std::chrono::milliseconds{1}, 255));
  config.front_sonar = 1;
  config.rear_sonar = 1;
  config.low_battery = 110;
  config.watchdog_ms = static_cast<std::uint16_t>(options_.watchdog / std::chrono::milliseconds{1});
  config.stall_pwm = 200;
  config.stall_count_ms = static_cast<std::uint16_t>(options_.stall_time / std::chrono::milliseconds{1});
  config.max_turn_rate = degrees(max_turn_rate_radps_);
  config.max_speed = milli(max_speed_mps_);
  config.turn_acceleration = degrees(turn_acceleration_radps2_);
  config.turn_deceleration = degrees(turn_deceleration_radps2_);
  config.acceleration = milli(acceleration_mps2_);
  config.deceleration = milli(deceleration_mps2_);
  config.front_bumpers = 5;
  config.rear_bumpers = 5;
  config.sonar_cycle = 40;
  config.shutdown_voltage = 105;
  config.firmware_version = "1.0";
  return pioneer::framed(pioneer::encode_config(config));
}

void PioneerFirmware::press_stop(bool pressed) {
  stop_pressed_ = pressed;
  if (pressed) motors_on_ = false;
}

void PioneerFirmware::power_cycle(Time now) {
  *this = PioneerFirmware{options_, now};
}

}  // namespace tandem::simulator
