#include "robot/camera/frame_source.hpp"

namespace tandem {
namespace {

constexpr int kOpenTimeoutMs = 2000;
constexpr int kReadTimeoutMs = 1500;
constexpr Duration kRetry = std::chrono::seconds{1};
constexpr Duration kWaited = std::chrono::milliseconds{2};
constexpr int kMostBuffered = 100;

}  // namespace

std::optional<Frame> FrameSource::next() {
  if (!capture_.isOpened()) open();
  if (!capture_.isOpened()) return std::nullopt;
  Frame frame;
  for (int i = 0; i < kMostBuffered; ++i) {
    const Time asked = timer_.now();
    if (!capture_.read(frame.picture) || frame.picture.empty()) {
      lose(is_live() ? "the stream has ended or fallen silent" : "the file has ended");
      return std::nullopt;
    }
    failure_.clear();
    frame.received = mission_.now();
    // A picture that did not have to be waited for has lain in a buffer, nobody knows how long; what follows is newer.
    if (!is_live() || timer_.now() - asked >= kWaited) return frame;
  }
  return std::nullopt;
}

void FrameSource::open() {
  const Time now = timer_.now();
  if (now < next_try_)
    timer_.wait_until(std::min(next_try_, now + std::chrono::milliseconds{50}), [] { return false; });
  if (timer_.now() < next_try_) return;
  // Named, for the first backend that OpenCV tries by itself need not be one that obeys time-outs or opens HTTP. FFmpeg
  // gives a picture as soon as it is whole; Debian's GStreamer has no source for HTTP without a further package.
  const int backend = is_video_device() ? cv::CAP_V4L2 : cv::CAP_FFMPEG;
  const std::vector<int> parameters = is_video_device()
                                          ? std::vector<int>{}
                                          : std::vector<int>{cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenTimeoutMs,
                                                             cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadTimeoutMs};
  if (!capture_.open(name_, backend, parameters)) {
    lose(is_video_device() ? "cannot be opened: is the camera plugged in, is the user in group video?"
                           : "cannot be opened: is the camera (or the simulator) running, is the address right?");
  }
}

void FrameSource::lose(const std::string& reason) {
  capture_.release();
  failure_ = name_ + ": " + reason;
  next_try_ = timer_.now() + kRetry;
}

}  // namespace tandem
