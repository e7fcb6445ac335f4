#pragma once

#include <cstddef>
#include <vector>

#include "services/planner/core/team/leg_table.hpp"

namespace tandem {

/// A piece of a walk ends when it is so long, in ranges of view of a searcher to whom seen is found ...
inline constexpr double kPieceOfViews = 3.0;
/// ... or has so many legs. At a finite rate what legs detect does not add up, and each leg is a piece.
inline constexpr std::size_t kMostLegsOfPiece = 6;

/// What it costs a team at least to look at each search cell, in seconds of the whole team's time.
///
/// A walk is cut into pieces of some legs each. No piece shows cells of a higher price together than its budget; of a
/// cell of which a look leaves something, as much of the price counts as is detected. So by t a member has looked at
/// cells for at most its share of t - `from_s`, and `ahead_s` for what a piece under way shows before its time. These
/// are dual prices of the covering problem whose columns are the pieces: any that keep that law hold. Longer pieces
/// allow higher prices, as less is shown twice.
struct CellPrices {
  struct Member {
    double share = 0.0;    ///< of the team's time; all add up to 1
    double from_s = 0.0;   ///< No cell with a price is in its view before.
    double ahead_s = 0.0;  ///< the most by which a piece under way is ahead, in seconds of the team's time
  };
  std::vector<double> price_s;  ///< per cell; 0: it costs nothing, or no leg shows it
  std::vector<Member> members;
};

/// Prices that let mass cost much: at first in proportion to it, then each cell as much as the legs that show it leave.
[[nodiscard]] CellPrices cell_prices(const PreparedProblem& problem, const LegTable& table,
                                     const std::vector<double>& mass);

}  // namespace tandem
