#include "robot/camera/camera_service.hpp"

#include <spdlog/spdlog.h>

#include <opencv2/imgproc.hpp>

#include "robot/camera/camera_messages.hpp"
#include "robot/camera/jpeg.hpp"

namespace tandem {
namespace {

constexpr std::size_t kMostJpegOfDetection = 30'000;
constexpr std::size_t kMostJpegOfImage = 60'000;
constexpr std::size_t kMostWaiting = 20;

}  // namespace

CameraService::CameraService(const CameraConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& timer,
                             const Clock& mission)
    : config_(config),
      robot_(site.robot),
      mission_(mission),
      frames_(config.source, timer, mission),
      pose_messages_(bus.in_order(topic::kRobotPose)),
      images_(bus.writer(topic::kCameraImage)),
      detections_(bus, topic::kDetection),
      health_(bus, site, "camera"),
      places_(static_cast<int>(config.frames_to_confirm), config.same_place_m),
      epoch_(mission.epoch()) {}

void CameraService::step() {
  if (mission_.epoch() != epoch_) {  // time began anew: what was seen belongs to another run
    epoch_ = mission_.epoch();
    poses_.clear();
    places_.clear();
    waiting_for_pose_.clear();
    sent_.clear();
    next_image_ = {};
  }
  if (const auto frame = frames_.next()) look(*frame);
  take_poses();
  place_on_map();
  detections_.step();
  repeat_undelivered();
  report_health();
}

void CameraService::take_poses() {
  for (const auto& received : pose_messages_.take()) {
    if (received.message.robot() != robot_) continue;
    if (const auto pose = from_message(received.message)) {
      poses_.add(*pose);
    } else {
      poses_.clear();
    }
  }
}

void CameraService::look(const Frame& frame) {
  const Time exposed = frame.received - from_seconds(config_.latency_s);
  const cv::Size size{static_cast<int>(config_.width_px), static_cast<int>(config_.height_px)};
  cv::Mat picture = frame.picture;
  if (picture.size() != size) cv::resize(frame.picture, picture, size, 0.0, 0.0, cv::INTER_AREA);
  publish(picture, exposed);
  auto sightings = find_tokens(picture, config_);
  if (sightings.empty()) return;
  auto jpeg = jpeg_of(surroundings(picture, sightings.front().box_px), kMostJpegOfDetection);
  waiting_for_pose_.push_back({exposed, std::move(sightings), std::move(jpeg)});
  if (waiting_for_pose_.size() > kMostWaiting) waiting_for_pose_.pop_front();
}

void CameraService::place_on_map() {
  while (!waiting_for_pose_.empty() && !poses_.is_after_last(waiting_for_pose_.front().exposed)) {
    const Seen seen = std::move(waiting_for_pose_.front());
    waiting_for_pose_.pop_front();
    const auto pose = poses_.at(seen.exposed);
    if (!pose) continue;
    for (const TokenSighting& sighting : seen.sightings) {
      const UncertainPoint point = on_map({sighting.point_in_base, sighting.covariance_in_base}, *pose);
      if (const auto confirmed = places_.add(point, seen.exposed)) report(*confirmed, seen);
    }
  }
}

void CameraService::report(const PlaceConfirmation::Confirmed& place, const Seen& seen) {
  msg::ObjectDetection message = to_message(place, robot_, seen.exposed, seen.jpeg);
  message.id(bus::new_event_id(robot_, mission_));
  detections_.send(message);
  spdlog::info("object found: x={:.2f} y={:.2f} frames={}", message.point_in_map().x(), message.point_in_map().y(),
               place.frames);
  sent_.push_back(std::move(message));
}

void CameraService::repeat_undelivered() {
  for (msg::ObjectDetection& message : sent_) {
    if (detections_.outcome(message.id()).state != bus::EventOutcome::State::Undelivered) continue;
    spdlog::warn("nobody has received the detection, it is sent again: id={}", message.id());
    message.id(bus::new_event_id(robot_, mission_));
    detections_.send(message);
  }
}

void CameraService::publish(const cv::Mat& picture, Time exposed) {
  if (config_.image_rate_hz <= 0.0 || exposed < next_image_) return;
  next_image_ = exposed + from_seconds(1.0 / config_.image_rate_hz);
  msg::CameraImage message;
  message.robot(robot_);
  message.stamp_ns(to_stamp_ns(exposed));
  message.width_px(static_cast<std::uint32_t>(picture.cols));
  message.height_px(static_cast<std::uint32_t>(picture.rows));
  message.jpeg(jpeg_of(picture, kMostJpegOfImage));
  images_.write(message);
}

void CameraService::report_health() {
  const std::string& failure = frames_.failure();
  if (failure != logged_failure_) {
    if (failure.empty()) {
      spdlog::info("camera streams: source={}", config_.source);
    } else {
      spdlog::warn("no pictures: {}", failure);
    }
    logged_failure_ = failure;
  }
  health_.step(failure.empty() ? msg::HEALTH_OK : msg::HEALTH_FAILED, failure);
}

}  // namespace tandem
