#pragma once

#include <vector>

#include "services/planner/core/team/search_world.hpp"

namespace tandem::bench {

/// The way of a searcher from `pose` to the nearest place from where it sees a cell that has mass left, or its pose
/// alone if there is none. The last resort of a search whose planner sees nothing more to do.
[[nodiscard]] TimedPath nearest_unseen_walk(SearchWorld& world, int searcher, const Pose2& pose,
                                            const std::vector<double>& mass);

}  // namespace tandem::bench
