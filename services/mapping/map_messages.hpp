#pragma once

#include <localization.h>

#include <optional>
#include <string>

#include "services/mapping/core/occupancy_grid.hpp"

// The one converter of a message that other shells include: every service that reads the map needs the same.
namespace tandem {

/// `grid` as a message, with the hash of its cells.
[[nodiscard]] msg::OccupancyGrid to_message(const OccupancyGrid& grid, const std::string& map_id);

/// The map in `message`; none if sizes, numbers or hash do not fit together.
[[nodiscard]] std::optional<OccupancyGrid> to_grid(const msg::OccupancyGrid& message);

}  // namespace tandem
