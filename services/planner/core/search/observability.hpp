#pragma once

#include <cstdint>
#include <unordered_map>
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

  [[nodiscard]] const SearchArea& area() const { return area_; }

 private:
  const OccupancyGrid& map_;
  const SearchArea& area_;
  double range_m_;
  std::vector<View> in_sight_;
};

}  // namespace tandem
