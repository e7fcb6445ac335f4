#include "bench/planning/instance/instance_world.hpp"

#include <cmath>

#include "services/mapping/core/ray_casting.hpp"

namespace tandem::bench {
namespace {

/// From which cells `searcher` can look: those it can walk through.
std::vector<bool> standpoints_of(SearchWorld& world, int searcher, const Pose2& start) {
  const SearchArea& area = world.area();
  const MotionMap& motion = world.actions(searcher).motion();
  const Observability& observability = world.observability(world.searcher(searcher).layer);
  std::vector<bool> standpoints(static_cast<std::size_t>(area.size()), false);
  const auto from = motion.nearest_node(start.position(), 1.0);
  if (!from) return standpoints;
  const ShortestPaths paths = motion.shortest_paths(*from);
  for (int node = 0; node < motion.size(); ++node) {
    if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(node)])) continue;
    const Eigen::Vector2d block = ((motion.point(node) - area.origin_in_map()) / area.cell_size_m()).array().floor();
    const int cell = observability.standpoint(static_cast<int>(block.x()), static_cast<int>(block.y()));
    if (cell >= 0) standpoints[static_cast<std::size_t>(cell)] = true;
  }
  return standpoints;
}

}  // namespace

std::unique_ptr<SearchWorld> world_of(const PlanningInstance& instance) {
  SearchWorldOptions options;
  options.area = instance.area;
  options.searchers = instance.searchers;
  return std::make_unique<SearchWorld>(layers_of(instance), options);
}

std::vector<bool> visible_cells(SearchWorld& world, const PlanningInstance& instance) {
  const SearchArea& area = world.area();
  std::vector<bool> visible(static_cast<std::size_t>(area.size()), false);
  for (std::size_t m = 0; m < instance.searchers.size(); ++m) {
    const Searcher& searcher = instance.searchers[m];
    if (m > 0 && same_capability(searcher, instance.searchers[m - 1])) continue;
    const std::vector<bool> standpoints = standpoints_of(world, static_cast<int>(m), instance.starts[m]);
    for (int cell = 0; cell < area.size(); ++cell) {
      const auto i = static_cast<std::size_t>(cell);
      if (visible[i]) continue;
      visible[i] = standpoints[i];
      // Few cells cannot be stood in: those along walls.
      for (const int other : area.cells_around(cell, searcher.view_max_m)) {
        if (visible[i]) break;
        visible[i] = standpoints[static_cast<std::size_t>(other)] &&
                     (area.point(cell) - area.point(other)).norm() <= searcher.view_max_m &&
                     line_of_sight(world.map(searcher.layer), area.point(other), area.point(cell));
      }
    }
  }
  return visible;
}

std::vector<double> prior_mass(SearchWorld& world, const PlanningInstance& instance) {
  return prior_of(instance.prior, world.area(), instance.area.start_in_map, visible_cells(world, instance));
}

}  // namespace tandem::bench
