#include "robot/pioneer/core/config_packet.hpp"

#include "robot/pioneer/core/fields.hpp"

namespace tandem::pioneer {
namespace {

/// Every field in the order of the wire.
template <typename AnyConfig, typename Visitor>
void visit_fields(AnyConfig& config, Visitor& visit) {
  visit(config.type);
  visit(config.subtype);
  visit(config.serial_number);
  visit(config.four_motors);
  visit(config.top_turn_rate);
  visit(config.top_speed);
  visit(config.top_turn_acceleration);
  visit(config.top_acceleration);
  visit(config.max_pwm);
  visit(config.name);
  visit(config.sip_cycle_ms);
  visit(config.host_baud);
  visit(config.aux1_baud);
  visit(config.has_gripper);
  visit(config.front_sonar);
  visit(config.rear_sonar);
  visit(config.low_battery);
  visit(config.rev_count);
  visit(config.watchdog_ms);
  visit(config.alternate_sips);
  visit(config.stall_pwm);
  visit(config.stall_count_ms);
  visit(config.joystick_speed);
  visit(config.joystick_turn_rate);
  visit(config.max_turn_rate);
  visit(config.max_speed);
  visit(config.turn_acceleration);
  visit(config.turn_deceleration);
  visit(config.turn_kp);
  visit(config.turn_kv);
  visit(config.turn_ki);
  visit(config.acceleration);
  visit(config.deceleration);
  visit(config.kp);
  visit(config.kv);
  visit(config.ki);
  visit(config.front_bumpers);
  visit(config.rear_bumpers);
  visit(config.charger_type);
  visit(config.sonar_cycle);
  visit(config.autobaud);
  visit(config.has_gyro);
  visit(config.drift_factor);
  visit(config.aux2_baud);
  visit(config.aux3_baud);
  visit(config.ticks_per_mm);
  visit(config.shutdown_voltage);
  visit(config.firmware_version);
  visit(config.gyro_clockwise);
  visit(config.gyro_counter_clockwise);
  visit(config.kinematics_delay_ms);
  visit(config.lateral_top_speed);
  visit(config.lateral_top_acceleration);
  visit(config.lateral_max_speed);
  visit(config.lateral_acceleration);
  visit(config.lateral_deceleration);
  visit(config.charge_threshold);
  visit(config.power_board_port);
  visit(config.gyro_rate_limit);
  visit(config.shutdown_temperature_c);
  visit(config.power_bits);
  visit(config.battery_type);
  visit(config.low_state_of_charge);
  visit(config.shutdown_state_of_charge);
  visit(config.bootloader_version);
  visit(config.config_flags);
  visit(config.gyro_firmware);
}

}  // namespace

Packet encode_config(const ConfigPacket& config) {
  Packet packet{packet_type::kConfig, {}};
  FieldWriter write{packet.body};
  visit_fields(config, write);
  return packet;
}

std::optional<ConfigPacket> decode_config(const Packet& packet) {
  if (packet.number != packet_type::kConfig) return std::nullopt;
  ConfigPacket config;
  FieldReader read{packet.body};
  visit_fields(config, read);
  return config;
}

}  // namespace tandem::pioneer
