#pragma once

#include <vector>

#include "services/planner/core/srs/planar_shape.hpp"
#include "services/planner/core/team/search_problem.hpp"

namespace tandem {

/// The expected time to find [s] if the only member of `problem`, a person, searches their own way: always on to where
/// most new mass for the time is, by what they believe.
///
/// `believed` is their mass of each search cell; what they find is valued by the problem's own, true masses (digest
/// D2).
[[nodiscard]] double time_of_own_way_s(const SearchProblem& problem, const std::vector<double>& believed);

/// How much sooner [s] a person who searches their own way finds the object once they know the true masses.
[[nodiscard]] double gain_of_knowing_s(const SearchProblem& problem, const std::vector<double>& believed);

/// How long [s] one who does not know of `place` is inside it, if they go straight on in direction `course` (of length
/// 1) for `ahead_s`, or up to the first wall of `map`.
[[nodiscard]] double time_walked_into_s(const OccupancyGrid& map, const PlanarShape& place,
                                        const Eigen::Vector2d& from_in_map, const Eigen::Vector2d& course,
                                        double speed_mps, double ahead_s);

}  // namespace tandem
