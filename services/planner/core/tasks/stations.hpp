#pragma once

#include <Eigen/Core>
#include <vector>

#include "services/planner/core/srs/resolved_world.hpp"

namespace tandem {

/// Points inside a boundary where an agent at `altitude_m` may stand to consume its source: the middle first, and for
/// larger ones points just inside its edge. None if the boundary moves, is an event, or lies at another altitude.
///
/// Of a half-plane, the point nearest to `seen_from_in_map`.
[[nodiscard]] std::vector<Eigen::Vector2d> stations_of(const ResolvedBoundary& boundary, double altitude_m,
                                                       const Eigen::Vector2d& seen_from_in_map);

/// A point inside a boundary that moves with agents, as they stand at the start of `joint`: where to be to consume it.
/// The boundary must be somewhere.
[[nodiscard]] Eigen::Vector2d moving_station(const ResolvedBoundary& boundary, const JointMove& joint);

/// Whether the boundary moves with agents, and whether with this one.
[[nodiscard]] bool is_moving(const ResolvedBoundary& boundary);
[[nodiscard]] bool moves_with(const ResolvedBoundary& boundary, std::size_t agent);

}  // namespace tandem
