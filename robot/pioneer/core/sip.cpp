#include "robot/pioneer/core/sip.hpp"

#include <cassert>

#include "robot/pioneer/core/fields.hpp"

namespace tandem::pioneer {
namespace {

/// Every field behind the sonar block, in order.
template <typename AnySip, typename Visitor>
void visit_optional_fields(AnySip& sip, Visitor& visit) {
  visit(sip.gripper_state);
  visit(sip.analog_port);
  visit(sip.analog);
  visit(sip.digital_in);
  visit(sip.digital_out);
  visit(sip.battery_x10);
  visit(sip.charge_state);
  visit(sip.turn_rate_x10);
  visit(sip.fault_flags);
  visit(sip.lateral_velocity);
  visit(sip.temperature_c);
  visit(sip.state_of_charge);
  visit(sip.controller_time_us);
  visit(sip.flags3);
}

std::uint8_t stall_byte(bool stalled, std::uint8_t bumpers) {
  return static_cast<std::uint8_t>((bumpers << 1u) | (stalled ? 1u : 0u));
}

}  // namespace

Packet encode_sip(const Sip& sip) {
  assert(sip.sonar.size() <= 48);
  Packet packet{sip.moving ? packet_type::kSipMoving : packet_type::kSipStopped, {}};
  FieldWriter write{packet.body};
  write(sip.x);
  write(sip.y);
  write(sip.heading);
  write(sip.left_velocity);
  write(sip.right_velocity);
  write(sip.battery);
  write(stall_byte(sip.left_stalled, sip.rear_bumpers));
  write(stall_byte(sip.right_stalled, sip.front_bumpers));
  write(sip.control);
  write(sip.flags);
  write(sip.compass);
  write(static_cast<std::uint8_t>(sip.sonar.size()));
  for (const SonarEcho& echo : sip.sonar) {
    write(echo.number);
    write(echo.range);
  }
  visit_optional_fields(sip, write);
  return packet;
}

std::optional<Sip> decode_sip(const Packet& packet) {
  if (!packet_type::is_sip(packet.number)) return std::nullopt;
  Sip sip;
  sip.moving = packet.number == packet_type::kSipMoving;
  FieldReader read{packet.body};
  std::uint8_t left = 0;
  std::uint8_t right = 0;
  std::uint8_t sonar_count = 0;
  read(sip.x);
  read(sip.y);
  read(sip.heading);
  read(sip.left_velocity);
  read(sip.right_velocity);
  read(sip.battery);
  read(left);
  read(right);
  read(sip.control);
  read(sip.flags);
  read(sip.compass);
  read(sonar_count);
  for (int i = 0; i < sonar_count && !read.ended(); ++i) {
    SonarEcho echo;
    read(echo.number);
    read(echo.range);
    sip.sonar.push_back(echo);
  }
  if (read.ended()) return std::nullopt;
  sip.left_stalled = (left & 1u) != 0;
  sip.right_stalled = (right & 1u) != 0;
  sip.rear_bumpers = static_cast<std::uint8_t>(left >> 1u);
  sip.front_bumpers = static_cast<std::uint8_t>(right >> 1u);
  visit_optional_fields(sip, read);
  return sip;
}

}  // namespace tandem::pioneer
