#pragma once

#include <nlohmann/json_fwd.hpp>

#include "services/planner/core/srs/world_file.hpp"

namespace tandem {

/// A boundary in a world file: {"shape": "disc", "centre": [1, 2], "radius_m": 3}. Throws ConfigError, on an area that
/// is not among `areas`, too.
[[nodiscard]] Boundary boundary_from(StrictObject object, const NamedAreas& areas);

/// The object that boundary_from() reads.
[[nodiscard]] nlohmann::json json_of(const Boundary& boundary);

/// [x, y] of each.
[[nodiscard]] nlohmann::json json_of(const std::vector<Eigen::Vector2d>& points);

}  // namespace tandem
