#pragma once

#include <cstdint>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/planner/core/search/search_area.hpp"
#include "services/planner/core/search/searcher.hpp"

namespace tandem {

/// The search cells that an agent sees at one moment.
using View = std::vector<int>;

/// Which search cells can be seen from which: obstacles block the view, up to a range (paper 5.1).
///
/// Lines of sight are found when first asked for and kept, so asking changes the object: one per thread.
class Observability {
 public:
  /// `map` and `area` must outlive it.
  Observability(const OccupancyGrid& map, const SearchArea& area, double range_m);

  /// The cells in line of sight of `standpoint`, itself included, ascending.
  [[nodiscard]] const View& in_sight_of(int standpoint);

  /// The cells that `searcher` sees from `pose`: in line of sight of the cell it stands in, in range and in its field
  /// of view. Nothing from outside the area.
  [[nodiscard]] View seen_from(const Searcher& searcher, const Pose2& pose);

  /// The search cell from which one looks who is in the block at a column and row of the area's grid: its own, or the
  /// nearest one if the block is no floor (a place next to a wall, a drone above it); -1 if there is none near.
  [[nodiscard]] int standpoint(int column, int row) const;

  [[nodiscard]] const SearchArea& area() const { return area_; }
  [[nodiscard]] double range_m() const { return range_m_; }

 private:
  const OccupancyGrid& map_;
  const SearchArea& area_;
  double range_m_;
  std::vector<View> in_sight_;
  std::vector<int> standpoints_;  ///< per block of the area's grid
};

}  // namespace tandem
