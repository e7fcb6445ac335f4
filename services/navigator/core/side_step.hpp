#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/navigator/core/path.hpp"
#include "services/navigator/core/path_follower.hpp"

namespace tandem::navigator {

/// What to look for when stepping aside.
struct SideStepOptions {
  double half_width_m = 0.0;  ///< Room to keep from obstacles: of the hull, with its margin.
  double hull_front_m = 0.0;  ///< Obstacles beside the hull are no reason to step aside.
  double horizon_m = 0.0;     ///< Of path looked at.
  double max_offset_m = 0.0;
  double lookahead_m = 0.0;
  double last_offset_m = 0.0;  ///< Of the cycle before: preferred, so that it does not change sides on the way.
};

struct SideStep {
  double offset_m = 0.0;                    ///< From the path, left positive.
  Eigen::Vector2d point_in_base{0.0, 0.0};  ///< To aim at.
};

/// The smallest parallel shift of the path that goes clear of the obstacles up to the horizon; none within the limit.
///
/// The shifted path begins where the robot is and reaches its offset before the first obstacle.
[[nodiscard]] std::optional<SideStep> side_step(const Aim& aim, const Path& path, const Pose2& map_from_base,
                                                const std::vector<Eigen::Vector2d>& obstacles_in_base,
                                                const SideStepOptions& options);

}  // namespace tandem::navigator
