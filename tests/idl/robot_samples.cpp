#include "tests/idl/samples.hpp"

namespace tandem::test {

template <>
msg::Odometry filled() {
  msg::Odometry message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.epoch(3);
  message.odom_from_base().x(4.5);
  message.odom_from_base().y(5.5);
  message.odom_from_base().heading(6.5);
  message.velocity().forward_mps(7.5);
  message.velocity().left_mps(8.5);
  message.velocity().turn_rate_radps(9.5);
  message.covariance({10.5, 11.5, 12.5, 13.5, 14.5, 15.5, 16.5, 17.5, 18.5});
  return message;
}

template <>
msg::BaseStatus filled() {
  msg::BaseStatus message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.connected(true);
  message.motors_enabled(true);
  message.estop_pressed(true);
  message.left_stalled(true);
  message.right_stalled(true);
  message.front_bumpers(3);
  message.rear_bumpers(4);
  message.battery_v(5.5);
  message.speed_limit_mps(6.5);
  message.stop_reasons({msg::STOP_NOT_ENABLED, msg::STOP_NOT_ENABLED});
  message.latched(true);
  message.resume_in_s(7.5);
  message.model("model-8");
  message.watchdog_ms(9);
  return message;
}

template <>
msg::SonarRanges filled() {
  msg::SonarRanges message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.readings().resize(1);
  message.readings()[0].index(3);
  message.readings()[0].range_m(4.5);
  return message;
}

template <>
msg::VelocityCommand filled() {
  msg::VelocityCommand message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.sequence_number(3);
  message.commander("commander-4");
  message.forward_mps(5.5);
  message.turn_rate_radps(6.5);
  return message;
}

template <>
msg::StopRequest filled() {
  msg::StopRequest message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.who("who-4");
  message.latched(true);
  return message;
}

template <>
msg::ResumeRequest filled() {
  msg::ResumeRequest message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.who("who-4");
  message.held_ms(5);
  return message;
}

template <>
msg::LaserScan filled() {
  msg::LaserScan message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.sequence_number(3);
  message.base_from_laser().x(4.5);
  message.base_from_laser().y(5.5);
  message.base_from_laser().heading(6.5);
  message.angle_min_rad(7.5);
  message.angle_increment_rad(8.5);
  message.scan_period_s(9.5);
  message.beam_interval_s(10.5);
  message.range_min_m(11.5);
  message.range_max_m(12.5);
  message.ranges_m({13.5F, 14.5F});
  message.intensities({15.5F, 16.5F});
  return message;
}

template <>
msg::CameraImage filled() {
  msg::CameraImage message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.width_px(3);
  message.height_px(4);
  message.jpeg({5, 6});
  return message;
}

template <>
msg::ObjectDetection filled() {
  msg::ObjectDetection message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.detected_by("detected-by-4");
  message.point_in_map().x(5.5);
  message.point_in_map().y(6.5);
  message.covariance_m2({7.5, 8.5, 9.5, 10.5});
  message.confidence(11.5);
  message.jpeg({12, 13});
  return message;
}

template <>
msg::TeammateState filled() {
  msg::TeammateState message;
  message.agent("agent-1");
  message.robot("robot-2");
  message.stamp_ns(1700000000000000003);
  message.map_from_agent().x(4.5);
  message.map_from_agent().y(5.5);
  message.map_from_agent().heading(6.5);
  message.covariance({7.5, 8.5, 9.5, 10.5, 11.5, 12.5, 13.5, 14.5, 15.5});
  message.velocity().forward_mps(16.5);
  message.velocity().left_mps(17.5);
  message.velocity().turn_rate_radps(18.5);
  message.source(msg::SOURCE_MESSAGE);
  message.state(msg::TRACK_LOST);
  message.age_s(19.5);
  return message;
}

template <>
msg::TrackedPeople filled() {
  msg::TrackedPeople message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.map_from_base().x(3.5);
  message.map_from_base().y(4.5);
  message.map_from_base().heading(5.5);
  message.people().resize(1);
  message.people()[0].track_id(6);
  message.people()[0].position_in_map().x(7.5);
  message.people()[0].position_in_map().y(8.5);
  message.people()[0].velocity_in_map_mps().x(9.5);
  message.people()[0].velocity_in_map_mps().y(10.5);
  message.people()[0].standard_deviation_m(11.5);
  return message;
}

template <>
msg::OccupancyGrid filled() {
  msg::OccupancyGrid message;
  message.map_id("map-id-1");
  message.sha256("sha256-2");
  message.resolution_m(3.5);
  message.width(4);
  message.height(5);
  message.map_from_grid().x(6.5);
  message.map_from_grid().y(7.5);
  message.map_from_grid().heading(8.5);
  message.cells({9, 10});
  return message;
}

template <>
msg::MapHolding filled() {
  msg::MapHolding message;
  message.host("host-1");
  message.sha256("sha256-2");
  return message;
}

template <>
msg::CompressedMap filled() {
  msg::CompressedMap message;
  message.map_id("map-id-1");
  message.sha256("sha256-2");
  message.resolution_m(3.5);
  message.width(4);
  message.height(5);
  message.map_from_grid().x(6.5);
  message.map_from_grid().y(7.5);
  message.map_from_grid().heading(8.5);
  message.zstd_cells({9, 10});
  return message;
}

template <>
msg::RobotPose filled() {
  msg::RobotPose message;
  message.robot("robot-1");
  message.stamp_ns(1700000000000000002);
  message.odometry_epoch(3);
  message.map_from_base().x(4.5);
  message.map_from_base().y(5.5);
  message.map_from_base().heading(6.5);
  message.covariance({7.5, 8.5, 9.5, 10.5, 11.5, 12.5, 13.5, 14.5, 15.5});
  message.agreement(16.5);
  message.status(msg::LOCALIZATION_UNCERTAIN);
  message.hypotheses().resize(1);
  message.hypotheses()[0].map_from_base().x(17.5);
  message.hypotheses()[0].map_from_base().y(18.5);
  message.hypotheses()[0].map_from_base().heading(19.5);
  message.hypotheses()[0].weight(20.5);
  return message;
}

template <>
msg::PoseHint filled() {
  msg::PoseHint message;
  message.robot("robot-1");
  message.id("id-2");
  message.stamp_ns(1700000000000000003);
  message.who("who-4");
  message.map_from_base().x(5.5);
  message.map_from_base().y(6.5);
  message.map_from_base().heading(7.5);
  message.heading_known(true);
  message.standard_deviation_m(8.5);
  return message;
}

}  // namespace tandem::test
