#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "services/common/pose2.hpp"

namespace tandem {

/// A point where a beam ended, with the direction across the surface it met.
struct SurfacePoint {
  Eigen::Vector2d point = Eigen::Vector2d::Zero();   ///< [m]
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< of length 1, towards the laser; zero where none is known
};

/// What one scan, or several together, saw.
using Surface = std::vector<SurfacePoint>;

/// The surface that the beams of a scan met, ending at `endpoints_in_base` in their order; `laser_in_base` [m] is where
/// the beams came from. At most `count` points, evenly chosen.
[[nodiscard]] Surface surface_of(std::span<const Eigen::Vector2d> endpoints_in_base,
                                 const Eigen::Vector2d& laser_in_base, std::size_t count);

/// The surface seen from another frame.
[[nodiscard]] Surface operator*(const Pose2& a_from_b, const Surface& surface_in_b);

/// Puts surfaces together, keeping the first point in each square of `cell_m`.
class SurfaceUnion {
 public:
  explicit SurfaceUnion(double cell_m) : cells_per_m_(1.0 / cell_m) {}

  /// Adds `surface_in_b`, seen from frame a.
  void add(const Pose2& a_from_b, const Surface& surface_in_b);
  /// What was put together.
  [[nodiscard]] Surface take();

 private:
  double cells_per_m_;
  Surface points_;
  std::vector<std::size_t> slots_;  ///< open addressing: 1 + index into points_, 0 for none
  [[nodiscard]] bool is_new(const Eigen::Vector2d& point);
  void grow();
};

}  // namespace tandem
