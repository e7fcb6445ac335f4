#include "tests/idl/samples.hpp"

namespace tandem::test {

template <>
msg::LinkStatus filled() {
  msg::LinkStatus message;
  message.host("host-1");
  message.stamp_ns(1700000000000000002);
  message.peer("peer-3");
  message.up(true);
  message.one_way(true);
  message.heard_age_s(4.5);
  message.round_trip_s(5.5);
  message.loss(6.5);
  message.clock_offset_s(7.5);
  return message;
}

template <>
msg::LinkHeartbeat filled() {
  msg::LinkHeartbeat message;
  message.host("host-1");
  message.role("role-2");
  message.sequence_number(3);
  message.sent_ns(1700000000000000004);
  message.heard_host("heard-host-5");
  message.heard_sequence_number(6);
  message.heard_sent_ns(1700000000000000007);
  message.held_ns(1700000000000000008);
  message.contract_hash("contract-hash-9");
  return message;
}

template <>
msg::ServiceHealth filled() {
  msg::ServiceHealth message;
  message.host("host-1");
  message.service("service-2");
  message.stamp_ns(1700000000000000003);
  message.robot("robot-4");
  message.version("version-5");
  message.contract_hash("contract-hash-6");
  message.process_id(7);
  message.state(msg::HEALTH_OK);
  message.reason("reason-8");
  return message;
}

template <>
msg::Clock filled() {
  msg::Clock message;
  message.stamp_ns(1700000000000000001);
  message.rate(2.5);
  message.epoch(3);
  return message;
}

template <>
msg::GroundTruth filled() {
  msg::GroundTruth message;
  message.stamp_ns(1700000000000000001);
  message.robots().resize(1);
  message.robots()[0].id("id-2");
  message.robots()[0].map_from_agent().x(3.5);
  message.robots()[0].map_from_agent().y(4.5);
  message.robots()[0].map_from_agent().heading(5.5);
  message.robots()[0].velocity().forward_mps(6.5);
  message.robots()[0].velocity().left_mps(7.5);
  message.robots()[0].velocity().turn_rate_radps(8.5);
  message.people().resize(1);
  message.people()[0].id("id-9");
  message.people()[0].map_from_agent().x(10.5);
  message.people()[0].map_from_agent().y(11.5);
  message.people()[0].map_from_agent().heading(12.5);
  message.people()[0].velocity().forward_mps(13.5);
  message.people()[0].velocity().left_mps(14.5);
  message.people()[0].velocity().turn_rate_radps(15.5);
  message.objects().resize(1);
  message.objects()[0].id("id-16");
  message.objects()[0].position_in_map().x(17.5);
  message.objects()[0].position_in_map().y(18.5);
  message.objects()[0].seen_by_person(true);
  message.left_wheel_mps(19.5);
  message.right_wheel_mps(20.5);
  message.collisions(21);
  return message;
}

}  // namespace tandem::test
