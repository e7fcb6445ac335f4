#include "services/planner/core/paper/action_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tandem {
namespace {

std::vector<Draw> draws_of(const Sightings& seen, double rate_per_s) {
  std::vector<std::size_t> order(seen.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return seen.cells[i]; });
  std::vector<Draw> draws;
  for (const std::size_t i : order) {
    const double kept = std::isinf(rate_per_s) ? 0.0 : std::exp(-rate_per_s * (seen.leave_s[i] - seen.enter_s[i]));
    if (!draws.empty() && draws.back().cell == seen.cells[i]) {
      draws.back().kept *= kept;
    } else {
      draws.push_back({seen.cells[i], kept});
    }
  }
  return draws;
}

/// Gains and bounds in one walk through the tree, with what is left in each cell put back on the way up.
class Appraisal {
 public:
  Appraisal(ActionTree& tree, const std::vector<double>& mass, double cost_per_s)
      : tree_(tree), mass_(mass), cost_per_s_(cost_per_s), children_(tree.size()) {
    for (std::size_t i = 1; i < tree.size(); ++i) {
      children_[static_cast<std::size_t>(tree[i].parent)].push_back(static_cast<int>(i));
    }
  }

  void appraise(int index) {
    Action& action = tree_[static_cast<std::size_t>(index)];
    const std::size_t undo_from = undo_.size();
    double drawn = 0.0;
    for (const Draw& draw : action.draws) {
      double& left = mass_[static_cast<std::size_t>(draw.cell)];
      if (left == 0.0) continue;
      undo_.emplace_back(draw.cell, left);
      drawn += left * (1.0 - draw.kept);
      left *= draw.kept;
    }
    action.gain = drawn - cost_per_s_ * static_cast<double>(action.duration_ms) * 1e-3;
    const auto& children = children_[static_cast<std::size_t>(index)];
    for (const int child : children) appraise(child);
    action.bound = children.empty()
                       ? 0.0
                       : promise(*std::ranges::max_element(children, {}, [&](int child) { return promise(child); }));
    while (undo_.size() > undo_from) {
      mass_[static_cast<std::size_t>(undo_.back().first)] = undo_.back().second;
      undo_.pop_back();
    }
  }

  /// The most attainable by going there and on.
  [[nodiscard]] double promise(int index) const {
    const Action& action = tree_[static_cast<std::size_t>(index)];
    return action.gain + action.bound;
  }
  [[nodiscard]] std::vector<int>& children_of(std::size_t index) { return children_[index]; }

 private:
  ActionTree& tree_;
  std::vector<double> mass_;
  double cost_per_s_;
  std::vector<std::vector<int>> children_;
  std::vector<std::pair<std::int32_t, double>> undo_;
};

}  // namespace

ActionTree action_tree(const std::vector<TreeNode>& nodes, double initial_heading_rad, double limit_s,
                       ViewTable& views) {
  const Searcher& searcher = views.searcher();
  ActionTree tree(1);
  tree[0].heading_rad = initial_heading_rad;
  tree[0].path.points = {{0.0, nodes[0].point_in_map}};
  std::vector<int> kept(nodes.size(), -1);
  kept[0] = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const int parent = kept[static_cast<std::size_t>(nodes[i].parent)];
    if (parent < 0) continue;
    const Action& above = tree[static_cast<std::size_t>(parent)];
    const Eigen::Vector2d& from = nodes[static_cast<std::size_t>(nodes[i].parent)].point_in_map;
    Action action;
    action.parent = parent;
    action.start_s = above.start_s + above.path.duration_s();
    action.heading_rad = heading_towards(from, nodes[i].point_in_map);
    action.path = timed_path({from, nodes[i].point_in_map}, searcher, above.heading_rad);
    if (action.start_s + action.path.duration_s() > limit_s) continue;
    action.duration_ms = std::max<std::int64_t>(1, std::llround(1e3 * action.path.duration_s()));
    action.seen = sightings_along(action.path, above.heading_rad, views);
    action.draws = draws_of(action.seen, searcher.detection_rate_per_s);
    kept[i] = static_cast<int>(tree.size());
    tree.push_back(std::move(action));
  }
  return tree;
}

void prune(ActionTree& tree, const std::vector<double>& mass, const PruningOptions& options) {
  const double mass_left = std::accumulate(mass.begin(), mass.end(), 0.0);
  Appraisal appraisal(tree, mass, options.travel_cost_per_s * mass_left);
  appraisal.appraise(0);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    std::vector<int>& children = appraisal.children_of(i);
    std::ranges::stable_sort(children, std::greater<>{}, [&](int child) { return appraisal.promise(child); });
    if (static_cast<int>(children.size()) > options.eligible) {
      children.resize(static_cast<std::size_t>(options.eligible));
    }
    tree[i].eligible = children;
    tree[i].selection.clear();
    if (children.empty()) continue;
    const double shift = std::min(0.0, appraisal.promise(children.back()));
    for (const int child : children) tree[i].selection.push_back(appraisal.promise(child) - shift);
    normalise(tree[i].selection);
  }
}

void normalise(std::vector<double>& selection) {
  const double sum = std::accumulate(selection.begin(), selection.end(), 0.0);
  const auto count = static_cast<double>(selection.size());
  double with_floor = 0.0;
  for (double& probability : selection) {
    probability = std::max(kLeastSelection, sum > 0.0 ? probability / sum : 1.0 / count);
    with_floor += probability;
  }
  for (double& probability : selection) probability /= with_floor;
}

std::vector<int> sequence_to(const ActionTree& tree, int action) {
  std::vector<int> sequence;
  for (int at = action; at > 0; at = tree[static_cast<std::size_t>(at)].parent) sequence.push_back(at);
  std::ranges::reverse(sequence);
  return sequence;
}

TimedPath path_to(const ActionTree& tree, int action) {
  TimedPath path = tree[0].path;
  for (const int index : sequence_to(tree, action)) {
    const Action& movement = tree[static_cast<std::size_t>(index)];
    for (const TimedPoint& point : movement.path.points) {
      if (point.time_s > 0.0) path.points.push_back({movement.start_s + point.time_s, point.point_in_map});
    }
  }
  return path;
}

}  // namespace tandem
