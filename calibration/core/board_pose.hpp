#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "calibration/core/camera_residual.hpp"

namespace tandem {

/// Roughly where a board is in the camera's frame (right, down, ahead), as angle-axis and translation [m], of a lens
/// without bend whose axis is in the picture's middle. Takes four corners at least, not all in a line.
[[nodiscard]] std::array<double, 6> camera_from_board(std::span<const SeenCorner> corners,
                                                      const Eigen::Vector2d& middle_px, double focal_px);

}  // namespace tandem
