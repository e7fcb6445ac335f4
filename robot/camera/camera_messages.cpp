#include "robot/camera/camera_messages.hpp"

#include <cmath>

namespace tandem {
namespace {

constexpr double kDoubtAfterOneFrame = 0.3;  // a green thing in one picture is something else so often

}  // namespace

std::optional<PoseHistory::Entry> from_message(const msg::RobotPose& message) {
  if (message.status() == msg::LOCALIZATION_LOST) return std::nullopt;
  PoseHistory::Entry entry{
      .stamp = from_stamp_ns(message.stamp_ns()),
      .map_from_base = {message.map_from_base().x(), message.map_from_base().y(), message.map_from_base().heading()}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      entry.covariance(row, column) = message.covariance()[static_cast<std::size_t>(3 * row + column)];
    }
  }
  return entry;
}

msg::ObjectDetection to_message(const PlaceConfirmation::Confirmed& place, const std::string& robot, Time stamp,
                                std::vector<std::uint8_t> jpeg) {
  const UncertainPoint& point = place.point_in_map;
  msg::ObjectDetection message;
  message.robot(robot);
  message.detected_by(robot);
  message.stamp_ns(to_stamp_ns(stamp));
  message.point_in_map().x(point.position.x());
  message.point_in_map().y(point.position.y());
  message.covariance_m2(
      {point.covariance(0, 0), point.covariance(0, 1), point.covariance(1, 0), point.covariance(1, 1)});
  message.confidence(1.0 - std::pow(kDoubtAfterOneFrame, place.frames));
  message.jpeg(std::move(jpeg));
  return message;
}

}  // namespace tandem
