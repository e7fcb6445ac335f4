#include "bench/planning/oracles/sweep_bound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace tandem::bench {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// How much longer a way on eight neighbours can be than the straight one: 1 / cos(pi / 8).
constexpr double kEightNeighbours = 1.0823922;

/// A searcher looks from the point of its search cell (or of the nearest one): so far it may be from itself.
double view_slack_m(const SearchArea& area) {
  return std::numbers::sqrt2 * area.cell_size_m();
}

/// The earliest moment at which somebody can see each search cell.
std::vector<double> earliest_views_s(const PlanningInstance& instance, const SearchArea& area,
                                     const std::vector<OccupancyGrid>& layers) {
  std::vector<double> earliest_s(static_cast<std::size_t>(area.size()), std::numeric_limits<double>::infinity());
  for (std::size_t m = 0; m < instance.searchers.size(); ++m) {
    const Searcher& searcher = instance.searchers[m];
    const OccupancyGrid& map = layers[static_cast<std::size_t>(searcher.layer)];
    const auto distances_m = least_distances_m(map, instance.starts[m].position());
    const double reach_m = searcher.view_max_m + view_slack_m(area);
    for (int cell = 0; cell < area.size(); ++cell) {
      const double straight_m = (area.point(cell) - instance.starts[m].position()).norm();
      const auto walked_m = static_cast<double>(distances_m[map.offset(map.cell_at(area.point(cell)))]);
      // Where no way leads, somebody may still look in.
      const double way_m = std::isfinite(walked_m) ? std::max(straight_m, walked_m) : straight_m;
      double& earliest = earliest_s[static_cast<std::size_t>(cell)];
      earliest = std::min(earliest, std::max(0.0, way_m - reach_m) / searcher.speed_mps);
    }
  }
  return earliest_s;
}

}  // namespace

std::vector<float> least_distances_m(const OccupancyGrid& map, const Eigen::Vector2d& from_in_map) {
  std::vector<float> distance_m(map.cells().size(), kInfinity);
  using Item = std::pair<float, std::size_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
  const CellIndex start = map.cell_at(from_in_map);
  if (!map.contains(start)) return distance_m;
  distance_m[map.offset(start)] = 0.0F;
  open.push({0.0F, map.offset(start)});
  const auto step_m = static_cast<float>(map.resolution_m());
  while (!open.empty()) {
    const auto [so_far_m, offset] = open.top();
    open.pop();
    if (so_far_m > distance_m[offset]) continue;
    const CellIndex cell{static_cast<int>(offset) % map.width(), static_cast<int>(offset) / map.width()};
    for (int rows = -1; rows <= 1; ++rows) {
      for (int columns = -1; columns <= 1; ++columns) {
        const CellIndex next{cell.column + columns, cell.row + rows};
        if (!map.is_free(next)) continue;
        const float length_m = so_far_m + (rows != 0 && columns != 0 ? std::numbers::sqrt2_v<float> : 1.0F) * step_m;
        if (length_m >= distance_m[map.offset(next)]) continue;
        distance_m[map.offset(next)] = length_m;
        open.push({length_m, map.offset(next)});
      }
    }
  }
  // Both ends may lie anywhere in their cells.
  for (float& length_m : distance_m) {
    length_m = std::max(0.0F, length_m / static_cast<float>(kEightNeighbours) - 2.0F * step_m);
  }
  return distance_m;
}

double sweep_lower_bound_s(const PlanningInstance& instance, const SearchArea& area,
                           const std::vector<OccupancyGrid>& layers, const std::vector<double>& prior) {
  // How much can be found by some time: as a curve over the time, of cells by when they can be seen...
  std::vector<std::pair<double, double>> by_reach;  // (time, mass)
  const auto earliest_s = earliest_views_s(instance, area, layers);
  for (std::size_t i = 0; i < prior.size(); ++i) by_reach.push_back({earliest_s[i], prior[i]});
  // ... and of cells by how dense they are, swept in the best order.
  double rate_m2ps = 0.0;
  double at_once_m2 = 0.0;
  for (const Searcher& searcher : instance.searchers) {
    const double radius_m = searcher.view_max_m + view_slack_m(area);
    at_once_m2 += std::numbers::pi * radius_m * radius_m;
    rate_m2ps += 2.0 * radius_m * searcher.speed_mps;
  }
  std::vector<std::size_t> by_density(prior.size());
  for (std::size_t i = 0; i < prior.size(); ++i) by_density[i] = i;
  std::ranges::sort(by_density, std::greater<>(),
                    [&](std::size_t i) { return prior[i] / area.floor_m2(static_cast<int>(i)); });
  std::vector<std::pair<double, double>> by_sweep;
  double swept_m2 = 0.0;
  for (const std::size_t i : by_density) {
    swept_m2 += area.floor_m2(static_cast<int>(i));
    by_sweep.push_back({std::max(0.0, swept_m2 - at_once_m2) / rate_m2ps, prior[i]});
  }
  std::ranges::sort(by_reach);
  std::ranges::sort(by_sweep);
  // The integral of 1 - min(both): step through the times at which either grows.
  double reach_found = 0.0;
  double sweep_found = 0.0;
  double now_s = 0.0;
  double integral_s = 0.0;
  for (std::size_t r = 0, s = 0; r < by_reach.size() || s < by_sweep.size();) {
    const bool reach_next = s == by_sweep.size() || (r < by_reach.size() && by_reach[r].first <= by_sweep[s].first);
    const double next_s = reach_next ? by_reach[r].first : by_sweep[s].first;
    integral_s += std::max(0.0, 1.0 - std::min(reach_found, sweep_found)) * (next_s - now_s);
    now_s = next_s;
    (reach_next ? reach_found : sweep_found) += reach_next ? by_reach[r++].second : by_sweep[s++].second;
  }
  return integral_s;
}

}  // namespace tandem::bench
