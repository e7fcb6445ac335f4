#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/pioneer/core/packet.hpp"

namespace tandem::pioneer {

/// The controller's own parameters (CONFIGpac). 0 or empty means unknown, never a limit of zero: short packets are
/// normal.
struct ConfigPacket {
  std::string type;
  std::string subtype;
  std::string serial_number;
  std::uint8_t four_motors = 0;
  std::uint16_t top_turn_rate = 0;          ///< [deg/s]
  std::uint16_t top_speed = 0;              ///< [mm/s]
  std::uint16_t top_turn_acceleration = 0;  ///< [deg/s^2]
  std::uint16_t top_acceleration = 0;       ///< [mm/s^2]
  std::uint16_t max_pwm = 0;
  std::string name;
  std::uint8_t sip_cycle_ms = 0;
  std::uint8_t host_baud = 0;
  std::uint8_t aux1_baud = 0;
  std::uint16_t has_gripper = 0;
  std::uint16_t front_sonar = 0;
  std::uint8_t rear_sonar = 0;
  std::uint16_t low_battery = 0;  ///< [0.1 V]
  std::uint16_t rev_count = 0;
  std::uint16_t watchdog_ms = 0;
  std::uint8_t alternate_sips = 0;
  std::uint16_t stall_pwm = 0;
  std::uint16_t stall_count_ms = 0;
  std::uint16_t joystick_speed = 0;
  std::uint16_t joystick_turn_rate = 0;
  std::uint16_t max_turn_rate = 0;      ///< [deg/s]
  std::uint16_t max_speed = 0;          ///< [mm/s]
  std::uint16_t turn_acceleration = 0;  ///< [deg/s^2]
  std::uint16_t turn_deceleration = 0;  ///< [deg/s^2]
  std::uint16_t turn_kp = 0;
  std::uint16_t turn_kv = 0;
  std::uint16_t turn_ki = 0;
  std::uint16_t acceleration = 0;  ///< [mm/s^2]
  std::uint16_t deceleration = 0;  ///< [mm/s^2]
  std::uint16_t kp = 0;
  std::uint16_t kv = 0;
  std::uint16_t ki = 0;
  std::uint8_t front_bumpers = 0;
  std::uint8_t rear_bumpers = 0;
  std::uint8_t charger_type = 0;
  std::uint8_t sonar_cycle = 0;
  std::uint8_t autobaud = 0;
  std::uint8_t has_gyro = 0;
  std::int16_t drift_factor = 0;
  std::uint8_t aux2_baud = 0;
  std::uint8_t aux3_baud = 0;
  std::uint16_t ticks_per_mm = 0;
  std::uint16_t shutdown_voltage = 0;  ///< [0.1 V]
  std::string firmware_version;
  std::uint16_t gyro_clockwise = 0;
  std::uint16_t gyro_counter_clockwise = 0;
  std::uint8_t kinematics_delay_ms = 0;  ///< Age of the odometry when it is sent.

  // Lateral and newer robots only.
  std::uint16_t lateral_top_speed = 0;
  std::uint16_t lateral_top_acceleration = 0;
  std::uint16_t lateral_max_speed = 0;
  std::uint16_t lateral_acceleration = 0;
  std::uint16_t lateral_deceleration = 0;
  std::uint16_t charge_threshold = 0;
  std::uint8_t power_board_port = 0;
  std::uint16_t gyro_rate_limit = 0;
  std::int8_t shutdown_temperature_c = 0;
  std::uint16_t power_bits = 0;
  std::uint8_t battery_type = 0;
  std::uint16_t low_state_of_charge = 0;
  std::uint16_t shutdown_state_of_charge = 0;
  std::string bootloader_version;
  std::uint32_t config_flags = 0;
  std::int16_t gyro_firmware = 0;

  friend bool operator==(const ConfigPacket&, const ConfigPacket&) = default;
};

[[nodiscard]] Packet encode_config(const ConfigPacket& config);
/// None if `packet` is of another type. Fields behind its end stay 0.
[[nodiscard]] std::optional<ConfigPacket> decode_config(const Packet& packet);

}  // namespace tandem::pioneer
