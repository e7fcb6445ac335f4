#include "robot/laser/laser_messages.hpp"

namespace tandem {

msg::LaserScan to_message(const LaserReading& reading, const std::string& robot, const Pose2& base_from_laser,
                          std::uint64_t sequence_number) {
  msg::LaserScan message;
  message.robot(robot);
  message.stamp_ns(to_stamp_ns(reading.first_beam));
  message.sequence_number(sequence_number);
  message.base_from_laser().x(base_from_laser.x);
  message.base_from_laser().y(base_from_laser.y);
  message.base_from_laser().heading(base_from_laser.heading);
  message.angle_min_rad(reading.angle_min_rad);
  message.angle_increment_rad(reading.angle_increment_rad);
  message.scan_period_s(reading.scan_period_s);
  message.beam_interval_s(reading.beam_interval_s);
  message.range_min_m(reading.range_min_m);
  message.range_max_m(reading.range_max_m);
  message.ranges_m(reading.ranges_m);
  message.intensities(reading.intensities);
  return message;
}

LaserReading from_message(const msg::LaserScan& message) {
  return {.first_beam = from_stamp_ns(message.stamp_ns()),
          .angle_min_rad = message.angle_min_rad(),
          .angle_increment_rad = message.angle_increment_rad(),
          .scan_period_s = message.scan_period_s(),
          .beam_interval_s = message.beam_interval_s(),
          .range_min_m = message.range_min_m(),
          .range_max_m = message.range_max_m(),
          .ranges_m = message.ranges_m(),
          .intensities = message.intensities()};
}

}  // namespace tandem
