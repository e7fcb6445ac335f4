#pragma once

#include <cstdint>
#include <string>

#include "robot/camera/core/camera_model.hpp"
#include "services/common/config.hpp"

namespace tandem {

/// config/<place>/robot/camera.toml
struct CameraConfig {
  std::string source = "http://127.0.0.1:8090/stream.mjpeg";  ///< An IP camera, "/dev/video0", or a file.
  double latency_s = 0.05;                                    ///< From the exposure to the picture's arrival here.
  std::int64_t width_px = 320;                                ///< Pictures of another size are scaled to this one.
  std::int64_t height_px = 240;
  double focal_px = 277.0;          ///< Of pictures of this size.
  double principal_right_px = 0.0;  ///< Where the axis meets the picture, from its middle.
  double principal_down_px = 0.0;
  double radial = 0.0;      ///< How the lens bends lines: a slope r from the axis is seen at r (1 + radial r^2).
  double mount_x_m = 0.20;  ///< The lens on the base, above the ground.
  double mount_y_m = 0.0;
  double mount_z_m = 0.60;
  double mount_pitch_deg = 20.0;  ///< Downwards.
  double mount_yaw_deg = 0.0;     ///< To the left.
  double mount_roll_deg = 0.0;    ///< Clockwise.
  std::int64_t hue_min = 45;      ///< What the tokens look like: OpenCV's hue [0, 180), saturation and value [0, 256).
  std::int64_t hue_max = 75;
  std::int64_t saturation_min = 90;
  std::int64_t value_min = 70;
  std::int64_t area_min_px = 6;  ///< Smaller spots are noise.
  double token_radius_m = 0.10;
  double range_max_m = 5.0;  ///< Farther sightings say too little about the place.
  std::int64_t frames_to_confirm = 3;
  double same_place_m = 0.5;   ///< Sightings nearer to each other are of one place.
  double image_rate_hz = 0.0;  ///< Pictures published for people; 0: none.

  [[nodiscard]] CameraModel model() const {
    return {.width_px = static_cast<int>(width_px),
            .height_px = static_cast<int>(height_px),
            .focal_px = focal_px,
            .position_in_base = {mount_x_m, mount_y_m, mount_z_m},
            .pitch_rad = from_degrees(mount_pitch_deg),
            .yaw_rad = from_degrees(mount_yaw_deg),
            .roll_rad = from_degrees(mount_roll_deg),
            .principal_offset_px = {principal_right_px, principal_down_px},
            .radial = radial};
  }

  template <typename Visitor>
  void visit_fields(Visitor& visitor) {
    visitor.field("source", source);
    visitor.field("latency_s", latency_s, Range{0.0, 2.0});
    visitor.field("width_px", width_px, Range{32, 4096});
    visitor.field("height_px", height_px, Range{32, 4096});
    visitor.field("focal_px", focal_px, Range{10.0, 20'000.0});
    visitor.field("principal_right_px", principal_right_px, Range{-500.0, 500.0});
    visitor.field("principal_down_px", principal_down_px, Range{-500.0, 500.0});
    visitor.field("radial", radial, Range{-0.5, 0.5});
    visitor.field("mount_x_m", mount_x_m, Range{-2.0, 2.0});
    visitor.field("mount_y_m", mount_y_m, Range{-2.0, 2.0});
    visitor.field("mount_z_m", mount_z_m, Range{0.05, 3.0});
    visitor.field("mount_pitch_deg", mount_pitch_deg, Range{-30.0, 90.0});
    visitor.field("mount_yaw_deg", mount_yaw_deg, Range{-180.0, 180.0});
    visitor.field("mount_roll_deg", mount_roll_deg, Range{-180.0, 180.0});
    visitor.field("hue_min", hue_min, Range{0, 179});
    visitor.field("hue_max", hue_max, Range{0, 179});
    visitor.field("saturation_min", saturation_min, Range{0, 255});
    visitor.field("value_min", value_min, Range{0, 255});
    visitor.field("area_min_px", area_min_px, Range{1, 10'000});
    visitor.field("token_radius_m", token_radius_m, Range{0.01, 1.0});
    visitor.field("range_max_m", range_max_m, Range{0.5, 30.0});
    visitor.field("frames_to_confirm", frames_to_confirm, Range{1, 100});
    visitor.field("same_place_m", same_place_m, Range{0.05, 5.0});
    visitor.field("image_rate_hz", image_rate_hz, Range{0.0, 1.0});
  }
};

}  // namespace tandem
