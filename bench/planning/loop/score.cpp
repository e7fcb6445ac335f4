#include "bench/planning/loop/score.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "services/planner/core/search/search_objective.hpp"

namespace tandem::bench {
namespace {

constexpr double kCurveStep_s = 0.5;

double floor_seen_m2(const SearchArea& area, const std::vector<bool>& seen) {
  double sum_m2 = 0.0;
  for (int cell = 0; cell < area.size(); ++cell)
    sum_m2 += seen[static_cast<std::size_t>(cell)] ? area.floor_m2(cell) : 0;
  return sum_m2;
}

double time_until(const std::vector<double>& survival, double left, double horizon_s) {
  const auto step = std::ranges::find_if(survival, [&](double probability) { return probability <= left; });
  return step == survival.end() ? horizon_s : kCurveStep_s * static_cast<double>(step - survival.begin());
}

double found_by(const std::vector<double>& survival, double time_s) {
  const auto step = static_cast<std::size_t>(time_s / kCurveStep_s);
  return 1.0 - survival[std::min(step, survival.size() - 1)];
}

}  // namespace

SearchScore score_of(SearchWorld& world, const std::vector<double>& prior, const std::vector<Walked>& walked,
                     double horizon_s) {
  SearchScore score;
  std::vector<Sightings> seen;
  std::vector<Look> looks;
  std::vector<int> searchers(walked.size());
  std::iota(searchers.begin(), searchers.end(), 0);
  for (std::size_t m = 0; m < walked.size(); ++m) {
    seen.push_back(sightings_along(walked[m].path, walked[m].start.heading, world.views(static_cast<int>(m))));
    score.distance_m.push_back(length_m(walked[m].path));
  }
  for (std::size_t m = 0; m < walked.size(); ++m) {
    looks.push_back({&seen[m], 0.0, world.searcher(static_cast<int>(m)).detection_rate_per_s});
  }
  SearchObjective objective({prior}, horizon_s, world.sweep_time_s(searchers));
  const Forecast forecast = objective.forecast(looks);
  score.expected_time_s = forecast.expected_time_s;
  score.probability_left = 1.0 - forecast.probability_found;
  const std::vector<double> survival = objective.survival(looks, kCurveStep_s);
  score.found_by_60_s = found_by(survival, 60.0);
  score.found_by_120_s = found_by(survival, 120.0);
  score.found_by_300_s = found_by(survival, 300.0);
  score.found_by_600_s = found_by(survival, 600.0);
  score.half_found_s = time_until(survival, 0.5, horizon_s);
  score.found95_s = time_until(survival, 0.05, horizon_s);
  score.all_found_s = time_until(survival, 0.001, horizon_s);

  const auto size = static_cast<std::size_t>(world.area().size());
  std::vector<bool> by_any(size, false);
  double sum_m2 = 0.0;
  for (const Sightings& one : seen) {
    std::vector<bool> by_one(size, false);
    for (const int cell : one.cells)
      by_one[static_cast<std::size_t>(cell)] = by_any[static_cast<std::size_t>(cell)] = true;
    sum_m2 += floor_seen_m2(world.area(), by_one);
  }
  const double union_m2 = floor_seen_m2(world.area(), by_any);
  score.overlap = union_m2 > 0.0 ? sum_m2 / union_m2 - 1.0 : 0.0;
  return score;
}

}  // namespace tandem::bench
