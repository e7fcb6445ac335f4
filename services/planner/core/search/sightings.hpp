#pragma once

#include <cstdint>
#include <vector>

#include "services/planner/core/motion/timed_path.hpp"
#include "services/planner/core/search/view_table.hpp"

namespace tandem {

/// Which search cells are in view when, on one path: cell `cells[i]` from `enter_s[i]` to `leave_s[i]`, counted from
/// the start of the path [s]. Ascending in `enter_s`; a cell that comes into view twice is there twice.
struct Sightings {
  std::vector<std::int32_t> cells;
  std::vector<double> enter_s;
  std::vector<double> leave_s;

  [[nodiscard]] std::size_t size() const { return cells.size(); }
};

/// What `views`' searcher sees on `path`, which it begins with `initial_heading_rad`. During a stay it looks where it
/// walked before.
///
/// Exact for the view model of ViewTable: entries and exits are crossings of cell borders, so a path seen in pieces
/// shows the same as in one.
[[nodiscard]] Sightings sightings_along(const TimedPath& path, double initial_heading_rad, ViewTable& views);

/// What is seen by `views`' searcher that stands at `pose` for ever.
[[nodiscard]] Sightings sightings_of_stay(const Pose2& pose, ViewTable& views);

}  // namespace tandem
