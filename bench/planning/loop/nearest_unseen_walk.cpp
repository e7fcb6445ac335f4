#include "bench/planning/loop/nearest_unseen_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tandem::bench {
namespace {

constexpr double kReach_m = 1.0;

}  // namespace

TimedPath nearest_unseen_walk(SearchWorld& world, int searcher, const Pose2& pose, const std::vector<double>& mass) {
  const SearchArea& area = world.area();
  const MotionMap& motion = world.actions(searcher).motion();
  const Observability& observability = world.observability(world.searcher(searcher).layer);
  ViewTable& views = world.views(searcher);
  TimedPath stay{{{0.0, pose.position()}}};
  const auto start = motion.nearest_node(pose.position(), kReach_m);
  if (!start) return stay;
  const ShortestPaths paths = motion.shortest_paths(*start);
  std::vector<int> nodes(static_cast<std::size_t>(motion.size()));
  std::iota(nodes.begin(), nodes.end(), 0);
  std::ranges::stable_sort(nodes, {}, [&](int node) { return paths.cost_m[static_cast<std::size_t>(node)]; });
  std::vector<bool> tried(static_cast<std::size_t>(area.size()), false);
  for (const int node : nodes) {
    if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(node)])) break;
    const Eigen::Vector2d block = ((motion.point(node) - area.origin_in_map()) / area.cell_size_m()).array().floor();
    const int standpoint = observability.standpoint(static_cast<int>(block.x()), static_cast<int>(block.y()));
    if (standpoint < 0 || tried[static_cast<std::size_t>(standpoint)]) continue;
    tried[static_cast<std::size_t>(standpoint)] = true;
    const View& view = views.view(standpoint, views.sector_of(pose.heading));
    if (std::ranges::none_of(view, [&](int cell) { return mass[static_cast<std::size_t>(cell)] > 0.0; })) continue;
    const auto way = motion.way(paths, node, pose.position(), motion.point(node));
    return timed_path(way, world.searcher(searcher), pose.heading);
  }
  return stay;
}

}  // namespace tandem::bench
