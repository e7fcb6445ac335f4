#pragma once

#include <Eigen/Core>
#include <span>

#include "services/common/pose2.hpp"
#include "services/localization/core/likelihood_field.hpp"

namespace tandem {

/// A box of poses around a centre, searched on a lattice.
struct SearchWindow {
  double half_side_m = 0.8;
  double half_turn_rad = 0.3;
  double step_m = 0.1;
  double step_rad = 0.05;
  double prior_weight = 0.3;  ///< what a pose on the rim costs against the centre [log likelihood per beam]
};

/// The pose of the lattice at which the beams fit the map best; exhaustive, so no start value can mislead it.
///
/// Correlative scan matching (Olson, ICRA 2009). Ties go to the first in order of heading, y, x.
[[nodiscard]] Pose2 best_pose_in_window(const LikelihoodField& field,
                                        std::span<const Eigen::Vector2d> endpoints_in_base, const Pose2& centre,
                                        const SearchWindow& window);

}  // namespace tandem
