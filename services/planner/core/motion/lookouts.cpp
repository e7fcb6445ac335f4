#include "services/planner/core/motion/lookouts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

namespace tandem {
namespace {

struct Candidate {
  double gain_m2 = 0.0;
  int cell = -1;
  int node = -1;
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.gain_m2 != b.gain_m2 ? a.gain_m2 < b.gain_m2 : a.cell > b.cell;
  }
};

/// For each search cell the reachable node of `motion` that is nearest to its point and inside it, -1 without one.
std::vector<int> standing_nodes(const SearchArea& area, const MotionMap& motion, int from) {
  const ShortestPaths paths = motion.shortest_paths(from);
  std::vector<int> nodes(static_cast<std::size_t>(area.size()), -1);
  for (int node = 0; node < motion.size(); ++node) {
    if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(node)])) continue;
    const auto cell = area.cell_at(motion.point(node));
    if (!cell) continue;
    int& best = nodes[static_cast<std::size_t>(*cell)];
    const auto off_m = [&](int n) { return (motion.point(n) - area.point(*cell)).norm(); };
    if (best < 0 || off_m(node) < off_m(best)) best = node;
  }
  return nodes;
}

}  // namespace

std::vector<int> covering_lookouts(Observability& observability, const MotionMap& motion, int from, double range_m,
                                   double least_gain_m2) {
  const SearchArea& area = observability.area();
  const std::vector<int> nodes = standing_nodes(area, motion, from);
  std::vector<bool> covered(static_cast<std::size_t>(area.size()), false);
  const auto gain_m2 = [&](int cell) {
    double gain = 0.0;
    for (const int seen : observability.in_sight_of(cell)) {
      if (!covered[static_cast<std::size_t>(seen)] && (area.point(seen) - area.point(cell)).norm() <= range_m) {
        gain += area.floor_m2(seen);
      }
    }
    return gain;
  };
  // A gain only shrinks as more is covered, so the best of old gains that holds anew is the best (lazy greedy).
  std::priority_queue<Candidate> candidates;
  for (int cell = 0; cell < area.size(); ++cell) {
    const int node = nodes[static_cast<std::size_t>(cell)];
    if (node >= 0) candidates.push({gain_m2(cell), cell, node});
  }
  std::vector<int> lookouts;
  while (!candidates.empty()) {
    Candidate best = candidates.top();
    candidates.pop();
    best.gain_m2 = gain_m2(best.cell);
    if (best.gain_m2 < least_gain_m2) continue;
    if (!candidates.empty() && best < candidates.top()) {
      candidates.push(best);
      continue;
    }
    lookouts.push_back(best.node);
    for (const int seen : observability.in_sight_of(best.cell)) {
      if ((area.point(seen) - area.point(best.cell)).norm() <= range_m) covered[static_cast<std::size_t>(seen)] = true;
    }
  }
  return lookouts;
}

}  // namespace tandem
