#include "services/recorder/rosbag_import.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/recorder/core/ros_frames.hpp"
#include "services/recorder/core/schemas.hpp"
#include "services/recorder/rosbag_source.hpp"

namespace tandem::recorder {
namespace {

constexpr const char* kUsualBase = "base_link";

/// What a first look at a bag tells.
struct Survey {
  std::set<std::string> scan_topics;
  std::set<std::string> odometry_topics;
  std::string odometry_child;
  ros::Frames frames;
};

Survey survey_of(const std::filesystem::path& bag, const RosbagOptions& options,
                 const std::function<bool()>& keep_going) {
  Survey survey;
  read_rosbag(bag, [&](const RosbagMessage& message) {
    const auto parsed = ros::parse(message.type, message.wire, message.data);
    if (!parsed) return keep_going();
    if (std::holds_alternative<ros::LaserScan>(*parsed)) survey.scan_topics.insert(message.topic);
    if (const auto* odometry = std::get_if<ros::Odometry>(&*parsed)) {
      survey.odometry_topics.insert(message.topic);
      const bool is_ours = options.odometry_topic.empty() || options.odometry_topic == message.topic;
      if (is_ours) survey.odometry_child = odometry->child_frame;
    }
    if (const auto* transforms = std::get_if<ros::Transforms>(&*parsed)) {
      for (const ros::Transform& transform : *transforms) survey.frames.learn(transform);
    }
    return keep_going();
  });
  return survey;
}

/// The topic to take: what was asked for, or the only one.
std::string chosen(const std::set<std::string>& topics, const std::string& asked, const std::string& what,
                   const std::string& option) {
  std::string list;
  for (const std::string& topic : topics) list += (list.empty() ? "" : ", ") + topic;
  if (!asked.empty()) {
    if (topics.contains(asked)) return asked;
    throw std::runtime_error("the bag has no " + what + " on " + asked + ", but on: " + (list.empty() ? "none" : list));
  }
  if (topics.size() > 1) throw std::runtime_error("the bag has " + what + " on " + list + ": choose with " + option);
  return topics.empty() ? "" : *topics.begin();
}

msg::Pose to_message(const Pose2& pose) {
  msg::Pose message;
  message.x(pose.x);
  message.y(pose.y);
  message.heading(pose.heading);
  return message;
}

class Importer {
 public:
  Importer(const RosbagOptions& options, Survey survey, mcap::Writer& writer)
      : options_(options), survey_(std::move(survey)), channels_(writer) {
    scan_topic_ = chosen(survey_.scan_topics, options.scan_topic, "scans", "--scan");
    odometry_topic_ = chosen(survey_.odometry_topics, options.odometry_topic, "odometry", "--odometry");
    base_ = options.base_frame;
    if (base_.empty()) base_ = survey_.odometry_child.empty() ? kUsualBase : survey_.odometry_child;
  }

  void take(const RosbagMessage& message) {
    if (!ros::is_known(message.type)) return;
    const auto parsed = ros::parse(message.type, message.wire, message.data);
    if (!parsed) {
      ++count_.broken;
      return;
    }
    time_ns_ = message.time_ns;
    if (const auto* scan = std::get_if<ros::LaserScan>(&*parsed)) {
      if (message.topic == scan_topic_) take(*scan);
    } else if (const auto* odometry = std::get_if<ros::Odometry>(&*parsed)) {
      if (message.topic == odometry_topic_) take(*odometry);
    } else if (const auto* map = std::get_if<ros::OccupancyGrid>(&*parsed)) {
      take(*map, message.topic);
    } else if (odometry_topic_.empty()) {
      for (const ros::Transform& transform : std::get<ros::Transforms>(*parsed)) take(transform);
    }
  }

  RosbagCount count() && { return std::move(count_); }

 private:
  void take(ros::LaserScan scan) {
    const auto placed = survey_.frames.base_from(base_, scan.header.frame);
    auto& lost = count_.lost_lasers;
    if (!placed && std::find(lost.begin(), lost.end(), scan.header.frame) == lost.end()) {
      lost.push_back(scan.header.frame);
    }
    if (placed && placed->is_mirrored && !scan.ranges_m.empty()) scan = ros::turned_up(std::move(scan));
    for (float& range : scan.ranges_m) {
      const bool is_return = range >= static_cast<float>(scan.range_min_m) &&
                             range <= static_cast<float>(scan.range_max_m) && std::isfinite(range);
      if (!is_return) range = std::numeric_limits<float>::quiet_NaN();
    }
    msg::LaserScan message;
    message.robot(options_.robot);
    message.stamp_ns(scan.header.stamp_ns);
    message.sequence_number(count_.scans++);
    message.base_from_laser(to_message(placed ? placed->pose : Pose2{}));
    message.angle_min_rad(scan.angle_min_rad);
    message.angle_increment_rad(scan.angle_increment_rad);
    message.scan_period_s(scan.scan_period_s);
    message.beam_interval_s(scan.beam_interval_s);
    message.range_min_m(scan.range_min_m);
    message.range_max_m(scan.range_max_m);
    message.ranges_m(scan.ranges_m);
    message.intensities(scan.intensities);
    write(topic::kScan, message, scan.header.stamp_ns);
  }

  void take(const ros::Odometry& odometry) {
    msg::Odometry message;
    message.robot(options_.robot);
    message.stamp_ns(odometry.header.stamp_ns);
    message.odom_from_base(to_message(odometry.odom_from_base));
    message.velocity().forward_mps(odometry.forward_mps);
    message.velocity().left_mps(odometry.left_mps);
    message.velocity().turn_rate_radps(odometry.turn_rate_radps);
    message.covariance(odometry.covariance);
    ++count_.odometry;
    write(topic::kOdometry, message, odometry.header.stamp_ns);
  }

  void take(const ros::Transform& transform) {
    if (transform.header.frame != options_.odom_frame || transform.child_frame != base_) return;
    ros::Odometry odometry;
    odometry.header = transform.header;
    odometry.odom_from_base = transform.parent_from_child;
    take(odometry);
  }

  void take(const ros::OccupancyGrid& map, const std::string& topic) {
    msg::OccupancyGrid message;
    message.map_id(topic);
    message.resolution_m(map.resolution_m);
    message.width(map.width);
    message.height(map.height);
    message.map_from_grid(to_message(map.map_from_grid));
    message.cells(map.cells);
    ++count_.maps;
    write(topic::kMap, message, map.header.stamp_ns);
  }

  template <class PubSubType>
  void write(const Topic<PubSubType>& topic, const typename PubSubType::type& message, std::int64_t stamp_ns) {
    const std::string type = PubSubType{}.getName();
    const std::uint16_t channel = channels_.channel_of(std::string{topic.name}, type, idl_of(type));
    const auto positive = [](std::int64_t time) { return static_cast<std::uint64_t>(std::max<std::int64_t>(time, 0)); };
    channels_.write(channel, positive(time_ns_), positive(stamp_ns), bus::encode<PubSubType>(message));
  }

  RosbagOptions options_;
  Survey survey_;
  mcap::ChannelTable channels_;
  std::string scan_topic_;
  std::string odometry_topic_;
  std::string base_;
  std::int64_t time_ns_ = 0;  ///< of the message at hand
  RosbagCount count_;
};

}  // namespace

RosbagCount import_rosbag(const std::filesystem::path& bag, const RosbagOptions& options, mcap::Writer& writer,
                          const std::function<bool()>& keep_going) {
  Importer importer{options, survey_of(bag, options, keep_going), writer};
  read_rosbag(bag, [&](const RosbagMessage& message) {
    importer.take(message);
    return keep_going();
  });
  return std::move(importer).count();
}

}  // namespace tandem::recorder
