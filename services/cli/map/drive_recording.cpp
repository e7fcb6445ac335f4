#include "services/cli/map/drive_recording.hpp"

#include <optional>
#include <string>

#include "idl/topics.hpp"
#include "services/bus/codec.hpp"
#include "services/localization/localization_messages.hpp"

namespace tandem::cli {
namespace {

/// Odometry and scans of one robot, on their way into a log.
class Reading {
 public:
  explicit Reading(const MapBuilderConfig& config) : log_(config) {}

  void add(const std::string& topic, const mcap::Message& message) {
    if (topic == topic::kOdometry.name) {
      if (const auto sample = converted<msg::OdometryPubSubType>(message)) {
        ++odometry_;
        log_.add_odometry(*sample);
      }
    } else if (topic == topic::kScan.name) {
      if (const auto scan = converted<msg::LaserScanPubSubType>(message)) {
        if (!first_) base_from_laser_ = scan->base_from_laser;
        if (!first_) first_ = scan->time;
        last_ = scan->time;
        log_.add_scan(*scan);
      }
    } else if (topic == topic::kBaseStatus.name) {
      const auto status = bus::decode<msg::BaseStatusPubSubType>({message.data.begin(), message.data.end()});
      if (status && (!robot_ || status->robot() == *robot_)) model_ = status->model();
    }
  }
  void add_damage() { ++damaged_; }
  [[nodiscard]] RecordedDrive take() {
    return {.drive = log_.take(),
            .duration_s = first_ ? to_seconds(last_ - *first_) : 0.0,
            .odometry = odometry_,
            .damaged = damaged_,
            .base_from_laser = base_from_laser_,
            .model = model_};
  }

 private:
  /// None for another robot's, and for what cannot be read: that is counted.
  template <class PubSubType>
  auto converted(const mcap::Message& message)
      -> decltype(from_message(std::declval<const typename PubSubType::type&>())) {
    const auto decoded = bus::decode<PubSubType>({message.data.begin(), message.data.end()});
    if (!decoded) {
      ++damaged_;
      return std::nullopt;
    }
    if (!robot_) robot_ = decoded->robot();
    if (decoded->robot() != *robot_) return std::nullopt;
    auto result = from_message(*decoded);
    if (!result) ++damaged_;
    return result;
  }

  DriveLog log_;
  std::optional<std::string> robot_;
  std::optional<Time> first_;
  Time last_{};
  Pose2 base_from_laser_;
  std::string model_;
  std::size_t odometry_ = 0;
  std::size_t damaged_ = 0;
};

}  // namespace

RecordedDrive read_drive(mcap::Reader& recording, const MapBuilderConfig& config,
                         const std::function<bool(double)>& keep_going) {
  Reading reading{config};
  for (std::size_t i = 0; i < recording.message_count(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(recording.message_count());
    if (i % 100 == 0 && !keep_going(share)) break;
    if (const auto message = recording.message_at(i)) {
      reading.add(recording.channels().at(message->channel_id).topic, *message);
    } else {
      reading.add_damage();
    }
  }
  return reading.take();
}

}  // namespace tandem::cli
