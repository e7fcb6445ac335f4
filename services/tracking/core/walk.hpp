#pragma once

#include <Eigen/Core>
#include <vector>

namespace tandem::tracking {

/// Where someone is who has walked `walked_m` [m] along a path since they were at `from_in_map`.
///
/// They go parallel to the path, at the offset from it that they had, and stand at its end. The path must not be empty.
struct Walk {
  Eigen::Vector2d position_in_map{0.0, 0.0};
  Eigen::Vector2d direction{0.0, 0.0};  ///< Of the piece walked on, of length 1; zero at the end of the path.
};
[[nodiscard]] Walk walk_along(const std::vector<Eigen::Vector2d>& path_in_map, const Eigen::Vector2d& from_in_map,
                              double walked_m);

/// Distance [m] of `point_in_map` from the nearest place of a path; infinite from an empty one.
[[nodiscard]] double distance_from_path(const std::vector<Eigen::Vector2d>& path_in_map,
                                        const Eigen::Vector2d& point_in_map);

}  // namespace tandem::tracking
