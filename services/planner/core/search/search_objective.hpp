#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "services/planner/core/search/sightings.hpp"

namespace tandem {

/// A path of one agent, or a piece of it, as the objective sees it.
struct Look {
  const Sightings* seen = nullptr;                           ///< Outlives the call.
  double start_s = 0.0;                                      ///< When the path begins.
  double rate_per_s = 0.5;                                   ///< Of detection; infinite: seen is found.
  double until_s = std::numeric_limits<double>::infinity();  ///< Nothing is seen from then on.
};

/// What a plan promises.
struct Forecast {
  double expected_time_s = 0.0;    ///< until all objects are found, from now, given that they were not found yet
  double probability_found = 0.0;  ///< that all are found within the horizon
};

/// The objective, the only one, for every planner (digest A1): the expected time to find.
///
/// E[T] = integral of P(not all found by t) from 0 to the horizon, plus what is left at the horizon times `tail_s`, the
/// same for all plans compared. Exact for the exponential detection model and for first sight: between the moments at
/// which cells come into view or leave it every integral has a closed form. With several objects the integral is a sum
/// over steps of 0.25 s (trapezoids).
class SearchObjective {
 public:
  /// `masses`: for each object still missing, independent of each other, the joint mass of each search cell.
  SearchObjective(std::vector<std::vector<double>> masses, double horizon_s, double tail_s);

  /// What is to be expected of these paths together, in whatever order they are given.
  [[nodiscard]] Forecast forecast(std::span<const Look> looks);

  /// P(not all found) at 0, `step_s`, 2 `step_s`, ... up to the horizon, given that none was found yet.
  [[nodiscard]] std::vector<double> survival(std::span<const Look> looks, double step_s);

  [[nodiscard]] const std::vector<std::vector<double>>& masses() const { return masses_; }
  [[nodiscard]] double horizon_s() const { return horizon_s_; }
  [[nodiscard]] double tail_s() const { return tail_s_; }

 private:
  /// A time of constant visibility of one cell to one agent.
  struct Exposure {
    double from_s;
    double to_s;
    double rate_per_s;
  };
  /// A change of the detection rate in one cell.
  struct Change {
    double time_s;
    double rate_per_s;  ///< more, or less if negative
  };

  void collect(std::span<const Look> looks);
  [[nodiscard]] std::span<const Exposure> exposures_of(std::size_t touched) const;
  [[nodiscard]] Forecast forecast_of_first_sight(std::span<const Look> looks);
  [[nodiscard]] Forecast forecast_of_one();
  [[nodiscard]] Forecast forecast_of_several(std::span<const Look> looks);
  [[nodiscard]] std::vector<double> survival_of(std::size_t object, double step_s);
  void order_changes(std::span<const Exposure> exposures);

  std::vector<std::vector<double>> masses_;
  std::vector<double> totals_;
  double horizon_s_;
  double tail_s_;
  // Scratch, kept to spare allocations.
  std::vector<double> first_s_;         ///< per cell, when it is first seen
  std::vector<std::uint32_t> counts_;   ///< per cell, then where its exposures begin
  std::vector<std::int32_t> touched_;   ///< cells that are seen at all
  std::vector<std::uint32_t> offsets_;  ///< per touched cell and one more
  std::vector<Exposure> exposures_;
  std::vector<Change> changes_;
};

}  // namespace tandem
