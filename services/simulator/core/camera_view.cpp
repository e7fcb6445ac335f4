#include "services/simulator/core/camera_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "services/mapping/core/ray_casting.hpp"
#include "services/simulator/core/laser_view.hpp"

namespace tandem::simulator {
namespace {

using Colour = std::array<std::uint8_t, 3>;  // blue, green, red
constexpr Colour kGround{200, 200, 200};
constexpr Colour kWall{80, 80, 80};
constexpr Colour kSky{235, 225, 220};
constexpr Colour kToken{30, 230, 40};
constexpr int kRays = 240;
constexpr double kFarthest_m = 25.0;

/// Azimuth of a pixel's ray in the base frame [rad].
double azimuth_of(const CameraModel& camera, int u, int v) {
  const Eigen::Vector3d ray = ray_in_base(camera, {u, v});
  return std::atan2(ray.y(), ray.x());
}

}  // namespace

CameraView::CameraView(const CameraModel& camera) : camera_(camera) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const int v : {0, camera.height_px - 1}) {
    for (const int u : {0, camera.width_px - 1}) {
      low = std::min(low, azimuth_of(camera, u, v));
      high = std::max(high, azimuth_of(camera, u, v));
    }
  }
  first_ray_rad_ = low;
  ray_step_rad_ = (high - low) / (kRays - 1);
  looks_.reserve(static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px));
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      Look look;
      const auto ground = ground_point_of(camera, {u, v});
      look.ground_m = ground ? static_cast<float>((*ground - camera.position_in_base.head<2>()).norm())
                             : std::numeric_limits<float>::infinity();
      const double ray = std::round((azimuth_of(camera, u, v) - first_ray_rad_) / ray_step_rad_);
      look.ray = static_cast<std::uint16_t>(std::clamp(ray, 0.0, kRays - 1.0));
      looks_.push_back(look);
    }
  }
}

std::vector<float> CameraView::fan(const Pose2& map_from_camera, const Place& place,
                                   std::span<const Disc> people) const {
  std::vector<float> fan_m(kRays);
  for (int i = 0; i < kRays; ++i) {
    const double heading = map_from_camera.heading + first_ray_rad_ + i * ray_step_rad_;
    double range = range_to_obstacle_m(place.map(), map_from_camera.position(), heading, kFarthest_m)
                       .value_or(std::numeric_limits<double>::infinity());
    for (const auto& person : people) {
      range = std::min(range, range_to_disc_m(map_from_camera.position(), heading, person));
    }
    fan_m[static_cast<std::size_t>(i)] = static_cast<float>(range);
  }
  return fan_m;
}

Picture CameraView::draw(const Pose2& map_from_base, const Place& place, std::span<const Disc> people,
                         std::span<const Eigen::Vector2d> tokens_in_map) const {
  const Pose2 base_from_camera{camera_.position_in_base.x(), camera_.position_in_base.y(), 0.0};
  const auto fan_m = fan(map_from_base * base_from_camera, place, people);
  Picture picture{camera_.width_px, camera_.height_px, {}};
  picture.bgr.reserve(3 * looks_.size());
  for (const auto& look : looks_) {
    const float wall_m = fan_m[look.ray];
    const Colour& colour = look.ground_m < wall_m ? kGround : std::isfinite(wall_m) ? kWall : kSky;
    picture.bgr.insert(picture.bgr.end(), colour.begin(), colour.end());
  }
  for (const auto& token : tokens_in_map) draw_token(picture, inverse(map_from_base) * token, fan_m);
  return picture;
}

void CameraView::draw_token(Picture& picture, const Eigen::Vector2d& token_in_base,
                            const std::vector<float>& fan_m) const {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e9);
  for (int i = 0; i < 8; ++i) {
    const double angle = from_degrees(45.0 * i);
    const Eigen::Vector2d edge = token_in_base + kTokenRadius_m * Eigen::Vector2d{std::cos(angle), std::sin(angle)};
    const auto pixel = pixel_of(camera_, {edge.x(), edge.y(), 0.0});
    if (!pixel) return;
    low = low.cwiseMin(*pixel);
    high = high.cwiseMax(*pixel);
  }
  const int left = std::max(0, static_cast<int>(low.x()) - 1);
  const int right = std::min(camera_.width_px - 1, static_cast<int>(high.x()) + 2);
  const int top = std::max(0, static_cast<int>(low.y()) - 1);
  const int bottom = std::min(camera_.height_px - 1, static_cast<int>(high.y()) + 2);
  constexpr int kSamples = 3;  // along each axis of a pixel: far tokens are a pixel high
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      const auto index = static_cast<std::size_t>(v * camera_.width_px + u);
      if (looks_[index].ground_m >= fan_m[looks_[index].ray]) continue;  // a wall hides it
      int inside = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const Eigen::Vector2d pixel{u + (i % kSamples - 1) / 3.0, v + (i / kSamples - 1) / 3.0};
        const auto ground = ground_point_of(camera_, pixel);
        if (ground && (*ground - token_in_base).norm() <= kTokenRadius_m) ++inside;
      }
      for (std::size_t channel = 0; channel < 3; ++channel) {
        auto& value = picture.bgr[3 * index + channel];
        value = static_cast<std::uint8_t>(value + (kToken[channel] - value) * inside / (kSamples * kSamples));
      }
    }
  }
}

}  // namespace tandem::simulator
