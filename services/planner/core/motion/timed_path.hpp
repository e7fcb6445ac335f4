#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/planner/core/search/searcher.hpp"

namespace tandem {

/// A place on the way and when it is left, counted from the start of the plan.
struct TimedPoint {
  double time_s = 0.0;
  Eigen::Vector2d point_in_map = Eigen::Vector2d::Zero();  ///< [m]
};

/// A way with times: straight at constant speed, then a turn on the spot. Times ascend.
struct TimedPath {
  std::vector<TimedPoint> points;
  [[nodiscard]] double duration_s() const { return points.empty() ? 0.0 : points.back().time_s; }
};

/// When `searcher` is where on `way`: it turns on the spot first, from `initial_heading_rad` and at every corner, and
/// then walks. An agent that sees all around does not need to turn.
[[nodiscard]] TimedPath timed_path(const std::vector<Eigen::Vector2d>& way, const Searcher& searcher,
                                   double initial_heading_rad);

/// How long `searcher` takes to turn from one heading to another [s].
[[nodiscard]] double turning_time_s(const Searcher& searcher, double from_rad, double to_rad);

/// The heading of the straight way between two points [rad].
[[nodiscard]] double heading_towards(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Where an agent on `path` is at `time_s`, heading along the piece it is on; it waits at the end.
[[nodiscard]] Pose2 pose_at(const TimedPath& path, double time_s);

}  // namespace tandem
