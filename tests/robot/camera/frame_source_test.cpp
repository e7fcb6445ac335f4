#include "robot/camera/frame_source.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "robot/camera/jpeg.hpp"
#include "tests/robot/camera/mjpeg_server.hpp"
#include "tests/robot/camera/synthetic_picture.hpp"

namespace tandem {
namespace {

std::vector<std::uint8_t> grey_jpeg() {
  return jpeg_of(cv::Mat(240, 320, CV_8UC3, cv::Scalar(128, 128, 128)), 60'000);
}

/// The next picture within 20 s.
std::optional<Frame> frame_within_deadline(FrameSource& source, SteadyClock& clock) {
  const Time deadline = clock.now() + from_seconds(20.0);
  while (clock.now() < deadline) {
    if (auto frame = source.next()) return frame;
  }
  return std::nullopt;
}

TEST(FrameSource, ReadsAnIpCameraAndComesBackWhenThatWasAway) {
  auto server = std::make_unique<MjpegServer>(grey_jpeg());
  const std::uint16_t port = server->port();
  SteadyClock clock;
  FrameSource source{server->address(), clock, clock};
  for (int i = 0; i < 3; ++i) {
    const auto frame = frame_within_deadline(source, clock);
    ASSERT_TRUE(frame) << source.failure();
    EXPECT_EQ(frame->picture.size(), cv::Size(320, 240));
    EXPECT_LE(frame->received, clock.now());
  }
  EXPECT_EQ(source.failure(), "");

  const std::string address = server->address();
  server.reset();
  const Time deadline = clock.now() + from_seconds(20.0);
  while (source.failure().empty() && clock.now() < deadline) (void)source.next();
  EXPECT_TRUE(source.failure().starts_with(address)) << source.failure();

  server = std::make_unique<MjpegServer>(grey_jpeg(), port);
  EXPECT_TRUE(frame_within_deadline(source, clock)) << source.failure();
}

TEST(FrameSource, SaysWhichCameraDoesNotAnswer) {
  SteadyClock clock;
  std::string address;
  {
    const MjpegServer gone{grey_jpeg()};
    address = gone.address();
  }
  FrameSource source{address, clock, clock};
  EXPECT_FALSE(source.next());
  EXPECT_EQ(source.failure(),
            address + ": cannot be opened: is the camera (or the simulator) running, is the address right?");
}

TEST(Jpeg, FitsItsLimitOrIsEmpty) {
  const cv::Mat picture = picture_of(CameraConfig{}, {{2.0, 0.0}});
  EXPECT_FALSE(jpeg_of(picture, 30'000).empty());
  EXPECT_LE(jpeg_of(picture, 30'000).size(), 30'000u);
  EXPECT_TRUE(jpeg_of(picture, 100).empty());
}

TEST(Jpeg, ShowsTheSurroundingsAsFarAsThePictureReaches) {
  const cv::Mat picture(240, 320, CV_8UC3);
  EXPECT_EQ(surroundings(picture, {100, 100, 20, 10}).size(), cv::Size(100, 90));
  EXPECT_EQ(surroundings(picture, {0, 0, 20, 10}).size(), cv::Size(60, 50));
}

}  // namespace
}  // namespace tandem
