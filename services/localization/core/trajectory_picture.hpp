#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "services/localization/core/trajectory_file.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem {

/// Two points [m] that a picture joins: a place that was recognised.
struct PictureLink {
  Eigen::Vector2d from_in_map;
  Eigen::Vector2d to_in_map;
};

/// What is drawn upon a map besides the estimated way; each may be empty.
struct PictureLayers {
  std::span<const TimedPose> truth{};
  std::span<const PictureLink> closures{};
};

/// The map with the estimated way on it (blue), the true one below (orange) and closures above (red), as an SVG file.
/// Equal inputs, equal bytes.
[[nodiscard]] std::string trajectory_picture(const OccupancyGrid& map, std::span<const TimedPose> estimate,
                                             const PictureLayers& layers);

}  // namespace tandem
