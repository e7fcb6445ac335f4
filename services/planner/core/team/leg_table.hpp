#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "services/planner/core/team/near_legs.hpp"

namespace tandem {

/// What each near leg shows a team of the cells that hold mass, in seconds of the team's time: a member's share of it
/// is its speed times its range of view.
struct LegTable {
  struct Capability {
    double share = 0.0;  ///< of one member; those of all members add up to 1
    double speed_mps = 0.0;
    double view_max_m = 0.0;
    double rate_per_s = 0.0;
    double first_s = std::numeric_limits<double>::infinity();  ///< A cell of a row is in view then at the earliest.
    std::vector<std::size_t> members;
  };
  /// A leg; or a second of turning where an agent does not see all around and may miss what it sees.
  struct Row {
    double budget_s = 0.0;  ///< duration times share
    double begin_s = 0.0;   ///< the earliest it can begin; infinite: a second of turning
    std::size_t begin = 0;  ///< of its entries
    std::size_t end = 0;
    std::size_t capability = 0;
    int from = -1;  ///< a place
    int to = -1;
  };

  std::vector<Capability> capabilities;
  std::vector<Row> rows;
  // Entries: each cell once a row, ascending in time.
  std::vector<std::int32_t> cells;
  std::vector<float> detected;    ///< the most of the cell's mass that the leg detects, as a share
  std::vector<float> time_s;      ///< of the team, from the beginning of the leg
  std::vector<double> in_view_s;  ///< per cell, when at the earliest; infinite: no leg shows it
  std::vector<bool> is_free;      ///< per cell, found where a member starts; not in the rows
};

/// Of first sight a leg does not show what was in view at its beginning: that was found on arrival. The time that a
/// first leg takes before anything can be in view is not part of its budget.
[[nodiscard]] LegTable leg_table(const PreparedProblem& problem, const std::vector<NearLegs>& near,
                                 const std::vector<double>& mass);

}  // namespace tandem
