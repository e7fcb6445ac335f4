#include "services/recorder/carmen_import.hpp"

#include <algorithm>
#include <cmath>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/common/time.hpp"
#include "services/recorder/core/schemas.hpp"

namespace tandem::recorder {
namespace {

std::int64_t stamp_of(double time_s) {
  return static_cast<std::int64_t>(std::llround(time_s * 1e9));
}

std::vector<std::uint8_t> encoded(const carmen::Odometry& odometry, const std::string& robot) {
  msg::Odometry message;
  message.robot(robot);
  message.stamp_ns(stamp_of(odometry.time_s));
  message.odom_from_base().x(odometry.odom_from_base.x);
  message.odom_from_base().y(odometry.odom_from_base.y);
  message.odom_from_base().heading(odometry.odom_from_base.heading);
  message.velocity().forward_mps(odometry.velocity.forward_mps);
  message.velocity().turn_rate_radps(odometry.velocity.turn_rate_radps);
  return bus::encode<msg::OdometryPubSubType>(message);
}

std::vector<std::uint8_t> encoded(const carmen::Scan& scan, const std::string& robot, std::uint64_t number) {
  msg::LaserScan message;
  message.robot(robot);
  message.stamp_ns(stamp_of(scan.time_s));
  message.sequence_number(number);
  message.angle_min_rad(scan.angle_min_rad);
  message.angle_increment_rad(scan.angle_increment_rad);
  message.range_min_m(scan.range_min_m);
  message.range_max_m(scan.range_max_m);
  message.base_from_laser().x(scan.base_from_laser.x);
  message.base_from_laser().y(scan.base_from_laser.y);
  message.base_from_laser().heading(scan.base_from_laser.heading);
  message.ranges_m(scan.ranges_m);
  return bus::encode<msg::LaserScanPubSubType>(message);
}

}  // namespace

void write_carmen(const std::vector<carmen::Event>& events, const std::string& robot, mcap::Writer& writer) {
  mcap::ChannelTable channels{writer};
  const auto channel_of = [&](std::string_view topic, const std::string& type) {
    return channels.channel_of(std::string{topic}, type, idl_of(type));
  };
  const std::uint16_t odometry_channel = channel_of(topic::kOdometry.name, "tandem::msg::Odometry");
  const std::uint16_t scan_channel = channel_of(topic::kScan.name, "tandem::msg::LaserScan");

  std::uint64_t log_time = 0;
  std::uint64_t scans = 0;
  for (const carmen::Event& event : events) {
    const double time_s = std::visit([](const auto& one) { return one.time_s; }, event);
    const auto stamp = static_cast<std::uint64_t>(std::max<std::int64_t>(stamp_of(time_s), 0));
    log_time = std::max(log_time, stamp);
    if (const auto* scan = std::get_if<carmen::Scan>(&event)) {
      channels.write(scan_channel, log_time, stamp, encoded(*scan, robot, scans++));
    } else {
      channels.write(odometry_channel, log_time, stamp, encoded(std::get<carmen::Odometry>(event), robot));
    }
  }
}

}  // namespace tandem::recorder
