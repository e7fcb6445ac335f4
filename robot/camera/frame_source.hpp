#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <optional>
#include <string>

#include "services/common/clock.hpp"

namespace tandem {

/// A picture and when it was here.
struct Frame {
  cv::Mat picture;  ///< 8-bit BGR
  Time received{};
};

/// Keeps a stream of pictures open: an IP camera (MJPEG over HTTP, RTSP), a video device, or a file.
class FrameSource {
 public:
  FrameSource(std::string name, Clock& timer, const Clock& mission)
      : name_(std::move(name)), timer_(timer), mission_(mission) {}

  /// The next picture, waiting for it. None when the source is closed, silent for 1.5 s, or behind: a picture of a live
  /// source that needed no waiting lay in a queue, nobody knows since when.
  [[nodiscard]] std::optional<Frame> next();
  /// Why there are no pictures; empty while they come.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  void open();
  void lose(const std::string& reason);
  [[nodiscard]] bool is_video_device() const { return name_.starts_with("/dev/video"); }
  [[nodiscard]] bool is_live() const { return is_video_device() || name_.find("://") != std::string::npos; }

  std::string name_;
  Clock& timer_;
  const Clock& mission_;
  cv::VideoCapture capture_;
  std::string failure_ = "not opened yet";
  Time next_try_{};
};

}  // namespace tandem
