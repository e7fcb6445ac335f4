#include "services/relay/relay_messages.hpp"

#include <algorithm>

#include "services/common/version.hpp"
#include "services/mapping/map_messages.hpp"
#include "services/relay/core/packed_cells.hpp"

namespace tandem {

ForwardingRule rule_of(const TopicInfo& topic) {
  using Direction = Relay::Direction;
  const Direction direction = topic.relay.direction;
  return {direction == Direction::ToLaptop || direction == Direction::Both,
          direction == Direction::ToRobot || direction == Direction::Both, topic.relay.max_rate_hz,
          topic.relay.max_age_s};
}

std::vector<TopicInfo> topics_by_urgency() {
  const auto is_urgent = [](const TopicInfo& topic) {
    for (const auto& name : {topic::kStopRequest.name, topic::kResumeRequest.name, topic::kTeamPlan.name,
                             topic::kRobotPose.name, topic::kBaseStatus.name, topic::kMessageReceipt.name}) {
      if (topic.name == name) return true;
    }
    return false;
  };
  std::vector<TopicInfo> topics = all_topics();
  std::stable_partition(topics.begin(), topics.end(), is_urgent);
  return topics;
}

msg::LinkHeartbeat to_message(const Heartbeat& heartbeat, const std::string& role) {
  msg::LinkHeartbeat message;
  message.host(heartbeat.host);
  message.role(role);
  message.sequence_number(heartbeat.sequence_number);
  message.sent_ns(to_stamp_ns(heartbeat.sent));
  message.heard_host(heartbeat.heard_host);
  message.heard_sequence_number(heartbeat.heard_sequence_number);
  message.heard_sent_ns(to_stamp_ns(heartbeat.heard_sent));
  message.held_ns(heartbeat.held.count());
  message.contract_hash(contract_hash());
  return message;
}

Heartbeat from_message(const msg::LinkHeartbeat& message) {
  return {message.host(),
          message.sequence_number(),
          from_stamp_ns(message.sent_ns()),
          message.heard_host(),
          message.heard_sequence_number(),
          from_stamp_ns(message.heard_sent_ns()),
          Duration{message.held_ns()}};
}

msg::LinkStatus to_message(const LinkState& state, const std::string& host, Time now) {
  msg::LinkStatus message;
  message.host(host);
  message.stamp_ns(to_stamp_ns(now));
  message.peer(state.peer);
  message.up(state.up);
  message.one_way(state.one_way);
  message.heard_age_s(state.heard_age_s);
  message.round_trip_s(state.round_trip_s);
  message.loss(state.loss);
  message.clock_offset_s(state.clock_offset_s);
  return message;
}

msg::LaserScan thinned(const msg::LaserScan& scan, std::size_t most_beams) {
  const auto& ranges = scan.ranges_m();
  const std::size_t step = (ranges.size() + most_beams - 1) / most_beams;
  if (step <= 1 && scan.intensities().empty()) return scan;
  msg::LaserScan thin = scan;
  thin.ranges_m().clear();
  thin.intensities().clear();
  for (std::size_t i = 0; i < ranges.size(); i += step) thin.ranges_m().push_back(ranges[i]);
  thin.angle_increment_rad(scan.angle_increment_rad() * static_cast<double>(step));
  thin.beam_interval_s(scan.beam_interval_s() * static_cast<double>(step));
  return thin;
}

msg::CompressedMap packed(const msg::OccupancyGrid& map) {
  msg::CompressedMap message;
  message.map_id(map.map_id());
  message.sha256(map.sha256());
  message.resolution_m(map.resolution_m());
  message.width(map.width());
  message.height(map.height());
  message.map_from_grid(map.map_from_grid());
  message.zstd_cells(packed_cells(map.cells()));
  return message;
}

std::optional<msg::OccupancyGrid> unpacked(const msg::CompressedMap& map) {
  auto cells = unpacked_cells(map.zstd_cells(), std::size_t{map.width()} * map.height());
  if (!cells) return std::nullopt;
  msg::OccupancyGrid message;
  message.map_id(map.map_id());
  message.sha256(map.sha256());
  message.resolution_m(map.resolution_m());
  message.width(map.width());
  message.height(map.height());
  message.map_from_grid(map.map_from_grid());
  message.cells(std::move(*cells));
  if (!to_grid(message)) return std::nullopt;
  return message;
}

}  // namespace tandem
