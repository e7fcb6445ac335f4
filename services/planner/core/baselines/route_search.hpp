#pragma once

#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/baselines/team_walk.hpp"

namespace tandem {

struct RouteSearchOptions {
  double exponent = 1.5;  ///< of the greedy that routes are begun and ended with
  double spread = 0.35;   ///< takes anything within this share of the best score
  int most_options = 20;
};

/// Good routes of one member while those of all others are fixed: randomised greedy, begun again from a random point of
/// the best route so far.
class RouteSearch {
 public:
  /// `problem` outlives it. `routes` are those of the others; that of `member` is what the search begins with.
  RouteSearch(const PreparedProblem& problem, SearchObjective& objective, const RouteSearchOptions& options,
              Routes routes, int member);

  /// Tries one more route.
  void improve(Rng& rng);

  [[nodiscard]] const Routes& routes() const { return routes_; }
  /// Expected time of all routes together [s].
  [[nodiscard]] double expected_time_s() const { return expected_time_s_; }

 private:
  [[nodiscard]] double expected_time_of(const std::vector<int>& route);

  const PreparedProblem* problem_;
  SearchObjective* objective_;
  RouteSearchOptions options_;
  Routes routes_;
  int member_;
  std::vector<Look> looks_;
  std::size_t looks_of_others_ = 0;
  double expected_time_s_ = 0.0;
};

/// Any of the options whose score is within `spread` of the best; -1 without options.
[[nodiscard]] int greedy_at_random(const std::vector<WalkOption>& options, const RouteSearchOptions& search, Rng& rng);

}  // namespace tandem
