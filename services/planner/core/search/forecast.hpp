#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/planner/core/search/observability.hpp"

namespace tandem {

/// What one agent will see, step by step; a null view sees nothing, after the end neither.
struct AgentViews {
  std::vector<const View*> steps;
  double detection_rate_per_s = 0.5;
};

/// What a plan promises.
struct Forecast {
  double expected_time_s = 0.0;    ///< until the object is found, from now, given that it was not found yet
  double probability_found = 0.0;  ///< within the horizon
};

/// The objective, the only one (digest A1): the expected time to find, exact for the exponential detection model.
///
/// E[T] = integral of P(not found by t) from 0 to the horizon, plus what is left at the horizon times `tail_s`, the
/// same for all plans compared. Within a step of `step_s` the views stand still.
class SearchForecaster {
 public:
  SearchForecaster(double step_s, double tail_s) : step_s_(step_s), tail_s_(tail_s) {}

  /// At most eight agents; `mass` is the joint mass of each cell.
  [[nodiscard]] Forecast forecast(const std::vector<double>& mass, std::span<const AgentViews> agents,
                                  int horizon_steps);

  /// P(not found) at the end of each step of the last forecast, 1 at its beginning.
  [[nodiscard]] const std::vector<double>& survival() const { return survival_; }

 private:
  double step_s_;
  double tail_s_;
  std::vector<double> mass_;           // scratch, kept to spare allocations
  std::vector<std::uint8_t> seen_by_;  // set of agents as bits, all zero between steps
  std::vector<int> touched_;
  std::vector<double> survival_;
};

}  // namespace tandem
