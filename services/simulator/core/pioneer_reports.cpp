#include <algorithm>
#include <cmath>

#include "robot/pioneer/core/config_packet.hpp"
#include "robot/pioneer/core/extra_packets.hpp"
#include "services/simulator/core/pioneer_firmware.hpp"

namespace tandem::simulator {
namespace {

using pioneer::Bytes;

constexpr std::uint16_t kTicksPerMm = 128;
constexpr std::uint8_t kMiddleSegment = 1u << 2;

void append(Bytes& all, const Bytes& more) {
  all.insert(all.end(), more.begin(), more.end());
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

/// The ticks of a wheel that went `way_m`: 32 bits that wrap.
std::int32_t ticks(double way_m) {
  return static_cast<std::int32_t>(static_cast<std::int64_t>(std::floor(way_m * 1000.0 * kTicksPerMm)));
}

}  // namespace

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
  sip.front_bumpers = faults_.front_bumpers | (contact_.front ? kMiddleSegment : std::uint8_t{0});
  sip.rear_bumpers = faults_.rear_bumpers | (contact_.rear ? kMiddleSegment : std::uint8_t{0});
  const double setpoint = heading_setpoint_.value_or(counted.heading);
  sip.control = static_cast<std::int16_t>(std::lround(setpoint / parameters.radians_per_count));
  sip.flags = static_cast<std::uint16_t>(
      (motors_on_ ? pioneer::sip_flag::kMotorsEnabled : 0) | (sonar_on_ ? pioneer::sip_flag::kSonarArray1 : 0) |
      (sonar_on_ ? pioneer::sip_flag::kSonarArray2 : 0) | (stop_pressed_ ? pioneer::sip_flag::kStopPressed : 0));
  sip.sonar = std::move(echoes);
  sip.gripper_state = 0;
  sip.analog_port = analog_port_;
  sip.analog = 0;
  sip.digital_in = faults_.digital_in;
  sip.digital_out = digital_out_;
  if (options_.extended_sips) {
    sip.battery_x10 = static_cast<std::uint16_t>(std::lround(battery_v * 10.0));
    sip.charge_state = 0;
    sip.turn_rate_x10 =
        static_cast<std::int16_t>(faults_.encoders_dead ? 0L : std::lround(10.0 * to_degrees(speed_.turn_rate_radps)));
    sip.fault_flags = 0;
    sip.lateral_velocity = 0;
    constexpr std::int8_t kNone = -127;
    sip.temperature_c = kNone;
    sip.state_of_charge = 0;
  }
  Bytes all = pioneer::framed(pioneer::encode_sip(sip));
  append(all, encoder_stream_ ? encoder_packet() : Bytes{});
  append(all, io_stream_ ? io_packet() : Bytes{});
  append(all, gyro_on_ ? gyro_packet() : Bytes{});
  return all;
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
  config.has_gyro = options_.has_gyro ? 1 : 0;
  config.ticks_per_mm = kTicksPerMm;
  config.kinematics_delay_ms = options_.kinematics_delay_ms;
  config.firmware_version = "1.0";
  return pioneer::framed(pioneer::encode_config(config));
}

Bytes PioneerFirmware::encoder_packet() const {
  return pioneer::framed(pioneer::encode_encoders({ticks(left_way_m_), ticks(right_way_m_)}));
}

Bytes PioneerFirmware::io_packet() const {
  const auto segments = [](std::uint8_t own, bool touched) {
    return static_cast<std::uint8_t>(own | (touched ? kMiddleSegment : 0));
  };
  return pioneer::framed(pioneer::encode_io({{faults_.digital_in, segments(faults_.front_bumpers, contact_.front),
                                              segments(faults_.rear_bumpers, contact_.rear), 0},
                                             {digital_out_, 0, 0, 0},
                                             std::vector<std::uint16_t>(9, 0)}));
}

Bytes PioneerFirmware::gyro_packet() const {
  constexpr double kDegreesPerSecond = 5.0 / 1023.0 * 300.0 / 2.5 * 1.626;  // of one count
  constexpr double kAtRest = 510.0;                                         // none is exactly in the middle
  const double counts = kAtRest - to_degrees(speed_.turn_rate_radps) / kDegreesPerSecond;
  const pioneer::GyroReading reading{static_cast<std::uint16_t>(std::clamp(std::lround(counts), 0L, 1023L)), 30};
  const auto count = static_cast<std::size_t>(options_.sip_cycle / std::chrono::milliseconds{25});
  return pioneer::framed(pioneer::encode_gyro(std::vector<pioneer::GyroReading>(count, reading)));
}

}  // namespace tandem::simulator
