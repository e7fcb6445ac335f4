#pragma once

#include <vector>

#include "services/planner/core/search/observability.hpp"

namespace tandem {

/// What a searcher sees in plans: it depends only on the search cell it stands in and, if it does not see all around,
/// on one of 24 sectors of its heading. So the moments at which cells come into view are exact.
///
/// Views are found when first asked for and kept, so asking changes the object: one per thread.
class ViewTable {
 public:
  /// `observability` must outlive it.
  ViewTable(Observability& observability, const Searcher& searcher);

  /// The sector of a heading; 0 if the searcher sees all around.
  [[nodiscard]] int sector_of(double heading_rad) const;
  /// What is seen from a search cell, ascending.
  [[nodiscard]] const View& view(int standpoint, int sector);
  [[nodiscard]] Observability& observability() const { return *observability_; }
  [[nodiscard]] const Searcher& searcher() const { return searcher_; }

 private:
  Observability* observability_;
  Searcher searcher_;
  int sectors_ = 1;
  bool sees_all_in_sight_ = false;
  std::vector<std::vector<View>> views_;  ///< per cell, then sector; empty until asked for
  std::vector<std::vector<bool>> is_known_;
};

}  // namespace tandem
