#pragma once

#include <vector>

#include "services/planner/core/team/team_ground.hpp"

namespace tandem {

/// For each pair of members the lookout of one that stands for a lookout of the other: the nearest one.
class PlaceTranslation {
 public:
  explicit PlaceTranslation(const TeamGround& ground);

  /// A lookout of member `to` near lookout `place` of member `from`; -1 if it has none.
  [[nodiscard]] int translated(std::size_t from, std::size_t to, int place) const {
    const auto& table = tables_[from * members_ + to];
    return table.empty() ? place : table[static_cast<std::size_t>(place)];
  }

 private:
  std::size_t members_;
  std::vector<std::vector<int>> tables_;  ///< empty where both have one capability
};

}  // namespace tandem
