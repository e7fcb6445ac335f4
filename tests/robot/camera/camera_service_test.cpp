#include "robot/camera/camera_service.hpp"

#include <gtest/gtest.h>

#include "robot/camera/camera_messages.hpp"
#include "robot/camera/jpeg.hpp"
#include "tests/robot/camera/mjpeg_server.hpp"
#include "tests/robot/camera/synthetic_picture.hpp"
#include "tests/support/domain_lease.hpp"

namespace tandem {
namespace {

SiteConfig site_in(int domain) {
  SiteConfig site;
  site.robot = "robot7";
  site.host_domain = domain;
  return site;
}

TEST(CameraMessages, CarryAFoundPlace) {
  PlaceConfirmation::Confirmed place{{{1.0, 2.0}, Eigen::Matrix2d::Identity() * 0.04}, 3};
  const msg::ObjectDetection message = to_message(place, "robot7", from_stamp_ns(99), {1, 2, 3});
  EXPECT_EQ(message.detected_by(), "robot7");
  EXPECT_EQ(message.stamp_ns(), 99);
  EXPECT_EQ(message.point_in_map().y(), 2.0);
  EXPECT_EQ(message.covariance_m2()[3], 0.04);
  EXPECT_NEAR(message.confidence(), 0.973, 1e-9);  // 1 - 0.3^3
  EXPECT_EQ(message.jpeg().size(), 3u);
}

TEST(CameraMessages, ALostRobotHasNoPose) {
  msg::RobotPose message;
  message.map_from_base().x(3.0);
  message.covariance()[4] = 0.5;
  message.status(msg::LOCALIZATION_UNCERTAIN);
  ASSERT_TRUE(from_message(message));
  EXPECT_EQ(from_message(message)->map_from_base.x, 3.0);
  EXPECT_EQ(from_message(message)->covariance(1, 1), 0.5);
  message.status(msg::LOCALIZATION_LOST);
  EXPECT_FALSE(from_message(message));
}

TEST(CameraService, ReportsOncePerPlaceWhereOnTheMapTokensLie) {
  const test::DomainLease domain{1};
  const SiteConfig site = site_in(domain[0]);
  CameraConfig config;
  const MjpegServer camera{jpeg_of(picture_of(config, {{2.0, -0.15}, {2.0, 0.0}, {2.0, 0.15}}), 60'000)};
  config.source = camera.address();
  config.image_rate_hz = 1.0;
  bus::Bus bus{bus::host_domain(site, "camera")};
  bus::Bus other{bus::host_domain(site, "planner")};
  auto poses = other.writer(topic::kRobotPose);
  auto images = other.latest(topic::kCameraImage);
  bus::EventReceiver detections{other, topic::kDetection, "planner"};
  SteadyClock clock;
  CameraService service{config, site, bus, clock, clock};

  std::vector<msg::ObjectDetection> found;
  const auto step = [&] {
    msg::RobotPose pose;
    pose.robot("robot7");
    pose.stamp_ns(to_stamp_ns(clock.now()));
    pose.map_from_base().x(10.0);
    pose.map_from_base().y(5.0);
    pose.map_from_base().heading(std::numbers::pi / 2);
    poses.write(pose);
    service.step();
    for (const auto& detection : detections.take()) {
      detections.applied(detection.id());
      found.push_back(detection);
    }
  };
  ASSERT_TRUE(bus::wait_until(other, from_seconds(20.0), [&] {
    step();
    return !found.empty() && images.newest();
  }));
  EXPECT_NEAR(found[0].point_in_map().x(), 10.0, 0.05);
  EXPECT_NEAR(found[0].point_in_map().y(), 7.0, 0.05);  // 2 m ahead is 2 m up
  EXPECT_EQ(found[0].robot(), "robot7");
  EXPECT_FALSE(found[0].jpeg().empty());
  EXPECT_EQ(images.newest()->message.width_px(), 320u);

  for (int i = 0; i < 20; ++i) step();
  EXPECT_EQ(found.size(), 1u);
}

}  // namespace
}  // namespace tandem
