#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "robot/camera/core/camera_config.hpp"
#include "robot/camera/core/place_confirmation.hpp"
#include "robot/camera/core/pose_history.hpp"
#include "robot/camera/core/token_finder.hpp"
#include "robot/camera/frame_source.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/bus/health.hpp"

namespace tandem {

/// Looks for tokens in the camera's pictures and reports each place where some lie, once.
class CameraService {
 public:
  CameraService(const CameraConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& timer, const Clock& mission);

  /// Waits for the next picture, at most 2 s when the camera does not answer, and reports what it shows.
  void step();

 private:
  /// What a picture showed, until the robot's pose at its time is known.
  struct Seen {
    Time exposed{};
    std::vector<TokenSighting> sightings;
    std::vector<std::uint8_t> jpeg;  ///< of the nearest
  };
  void take_poses();
  void look(const Frame& frame);
  void place_on_map();
  void report(const PlaceConfirmation::Confirmed& place, const Seen& seen);
  void repeat_undelivered();
  void publish(const cv::Mat& picture, Time exposed);
  void report_health();

  CameraConfig config_;
  std::string robot_;
  const Clock& mission_;
  FrameSource frames_;
  bus::InOrder<msg::RobotPose, msg::RobotPosePubSubType> pose_messages_;
  bus::Writer<msg::CameraImage, msg::CameraImagePubSubType> images_;
  bus::EventSender<msg::ObjectDetection, msg::ObjectDetectionPubSubType> detections_;
  bus::HealthReporter health_;
  PoseHistory poses_;
  PlaceConfirmation places_;
  std::deque<Seen> waiting_for_pose_;
  std::vector<msg::ObjectDetection> sent_;
  Time next_image_{};
  int epoch_ = 0;
  std::optional<std::string> logged_failure_;
};

}  // namespace tandem
