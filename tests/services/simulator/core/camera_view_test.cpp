#include "services/simulator/core/camera_view.hpp"

#include <gtest/gtest.h>

#include "tests/support/ascii_map.hpp"

namespace tandem::simulator {
namespace {

Place hall() {
  return Place{test::ascii_map({"############", "#..........#", "#..........#", "#..........#", "############"})};
}

/// Is the pixel that shows `point_in_base` on the ground green?
bool is_green_at(const Picture& picture, const CameraModel& camera, const Eigen::Vector2d& point_in_base) {
  const auto pixel = pixel_of(camera, {point_in_base.x(), point_in_base.y(), 0.0});
  if (!pixel || !is_in_picture(camera, *pixel)) return false;
  const auto index = static_cast<std::size_t>(std::lround(pixel->y()) * camera.width_px + std::lround(pixel->x()));
  const auto* bgr = picture.bgr.data() + 3 * index;
  return bgr[1] > 200 && bgr[0] < 60 && bgr[2] < 60;
}

TEST(CameraView, ShowsATokenWhereTheCameraModelPutsIt) {
  const CameraModel camera;
  const std::vector<Eigen::Vector2d> tokens{{4.0, 2.9}};
  const Picture picture = CameraView{camera}.draw({2.0, 2.5, 0.0}, hall(), {}, tokens);

  EXPECT_EQ(picture.bgr.size(), 3U * 320U * 240U);
  EXPECT_TRUE(is_green_at(picture, camera, {2.0, 0.4}));
  EXPECT_FALSE(is_green_at(picture, camera, {2.0, 0.0}));
}

TEST(CameraView, AWallHidesAToken) {
  const Place walled{test::ascii_map({"############", "#....#.....#", "#....#.....#", "#....#.....#", "############"})};
  const CameraModel camera;
  const std::vector<Eigen::Vector2d> tokens{{6.5, 2.5}};
  EXPECT_TRUE(is_green_at(CameraView{camera}.draw({3.0, 2.5, 0.0}, hall(), {}, tokens), camera, {3.5, 0.0}));
  EXPECT_FALSE(is_green_at(CameraView{camera}.draw({3.0, 2.5, 0.0}, walled, {}, tokens), camera, {3.5, 0.0}));
}

TEST(CameraView, APersonHidesAToken) {
  const CameraModel camera;
  const std::vector<Eigen::Vector2d> tokens{{6.0, 2.5}};
  const std::vector<Disc> people{{{4.5, 2.5}, 0.2}};
  EXPECT_FALSE(is_green_at(CameraView{camera}.draw({3.0, 2.5, 0.0}, hall(), people, tokens), camera, {3.0, 0.0}));
}

TEST(CameraView, GroundIsLightAndWallsAreDark) {
  const Picture picture = CameraView{CameraModel{}}.draw({9.0, 2.5, 0.0}, hall(), {}, {});
  const auto at = [&](int u, int v) { return picture.bgr[3 * static_cast<std::size_t>(v * 320 + u)]; };
  EXPECT_EQ(at(160, 239), 200);
  EXPECT_EQ(at(160, 60), 80);
}

}  // namespace
}  // namespace tandem::simulator
