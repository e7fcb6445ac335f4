#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/pioneer/core/packet.hpp"

namespace tandem::pioneer {

/// One sonar reading of a standard packet, in robot units.
struct SonarEcho {
  std::uint8_t number = 0;
  std::uint16_t range = 0;

  friend bool operator==(const SonarEcho&, const SonarEcho&) = default;
};

/// Bits of Sip::flags.
namespace sip_flag {
inline constexpr std::uint16_t kMotorsEnabled = 1u << 0;
inline constexpr std::uint16_t kSonarArray1 = 1u << 1;
inline constexpr std::uint16_t kSonarArray2 = 1u << 2;
inline constexpr std::uint16_t kStopPressed = 1u << 5;
}  // namespace sip_flag

/// The standard information packet, in the robot's own units (RobotParameters turns them into metres).
struct Sip {
  bool moving = false;       ///< packet type 0x33; do not rely on it
  std::uint16_t x = 0;       ///< low 15 bits: a modulo counter
  std::uint16_t y = 0;       ///< low 15 bits: a modulo counter
  std::int16_t heading = 0;  ///< 4096 per turn, either -2048..2047 or 0..4095
  std::int16_t left_velocity = 0;
  std::int16_t right_velocity = 0;
  std::uint8_t battery = 0;  ///< [0.1 V], saturates at 25.5 V
  bool left_stalled = false;
  bool right_stalled = false;
  std::uint8_t rear_bumpers = 0;   ///< bit i: segment i + 1 pressed
  std::uint8_t front_bumpers = 0;  ///< bit i: segment i + 1 pressed
  std::int16_t control = 0;
  std::uint16_t flags = 0;
  std::uint8_t compass = 0;
  std::vector<SonarEcho> sonar;  ///< those measured since the last packet only

  // Each of these is there only if all before it are: old robots end early.
  std::optional<std::uint8_t> gripper_state;
  std::optional<std::uint8_t> analog_port;
  std::optional<std::uint8_t> analog;
  std::optional<std::uint8_t> digital_in;
  std::optional<std::uint8_t> digital_out;
  std::optional<std::uint16_t> battery_x10;  ///< [0.1 V]
  std::optional<std::uint8_t> charge_state;
  std::optional<std::int16_t> turn_rate_x10;  ///< [0.1 deg/s]
  std::optional<std::uint16_t> fault_flags;
  std::optional<std::int16_t> lateral_velocity;
  std::optional<std::int8_t> temperature_c;    ///< -127, -128: none
  std::optional<std::int8_t> state_of_charge;  ///< percent, 0: not available
  std::optional<std::uint32_t> controller_time_us;
  std::optional<std::uint32_t> flags3;

  [[nodiscard]] bool motors_enabled() const { return (flags & sip_flag::kMotorsEnabled) != 0; }
  [[nodiscard]] bool stop_pressed() const { return (flags & sip_flag::kStopPressed) != 0; }
  [[nodiscard]] double battery_v() const { return 0.1 * (battery_x10.value_or(0) > 0 ? *battery_x10 : battery); }

  friend bool operator==(const Sip&, const Sip&) = default;
};

/// At most 32 sonar echoes fit with all optional fields.
[[nodiscard]] Packet encode_sip(const Sip& sip);
/// None if `packet` is not a standard packet or ends before the sonar block does.
[[nodiscard]] std::optional<Sip> decode_sip(const Packet& packet);

}  // namespace tandem::pioneer
