#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "robot/camera/core/camera_model.hpp"
#include "services/common/pose2.hpp"
#include "services/simulator/core/place.hpp"
#include "services/simulator/core/robot_body.hpp"

namespace tandem::simulator {

/// A colour picture, row by row from the top, three bytes a pixel: blue, green, red.
struct Picture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> bgr;
};

/// Radius of a token [m], a bright green disc on the ground.
inline constexpr double kTokenRadius_m = 0.10;

/// Draws what the robot's camera sees: light ground, dark walls and people, green tokens where nothing hides them.
///
/// Where each pixel looks is worked out once; a picture costs a fan of rays against the map and one look-up a pixel.
class CameraView {
 public:
  explicit CameraView(const CameraModel& camera);

  [[nodiscard]] Picture draw(const Pose2& map_from_base, const Place& place, std::span<const Disc> people,
                             std::span<const Eigen::Vector2d> tokens_in_map) const;

 private:
  struct Look {
    float ground_m = 0.0F;  ///< Distance along the floor to where the pixel meets it; infinite above the horizon.
    std::uint16_t ray = 0;  ///< Of the fan.
  };
  /// Distance [m] from the camera along the floor to the first wall or person, for each ray of the fan.
  [[nodiscard]] std::vector<float> fan(const Pose2& map_from_camera, const Place& place,
                                       std::span<const Disc> people) const;
  void draw_token(Picture& picture, const Eigen::Vector2d& token_in_base, const std::vector<float>& fan_m) const;

  CameraModel camera_;
  std::vector<Look> looks_;
  double first_ray_rad_ = 0.0;
  double ray_step_rad_ = 0.0;
};

}  // namespace tandem::simulator
