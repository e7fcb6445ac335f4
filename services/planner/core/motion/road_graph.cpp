#include "services/planner/core/motion/road_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void append(std::vector<int>& nodes, const std::vector<int>& more) {
  nodes.insert(nodes.end(), more.begin() + (nodes.empty() ? 0 : 1), more.end());
}

}  // namespace

RoadGraph::RoadGraph(const MotionMap& motion, std::vector<int> lookouts, int nearest)
    : motion_(motion),
      lookouts_(static_cast<int>(lookouts.size())),
      nearest_(static_cast<std::size_t>(nearest)),
      nodes_(std::move(lookouts)),
      place_at_(static_cast<std::size_t>(motion.size()), -1),
      roads_(nodes_.size()),
      roads_known_(nodes_.size(), false),
      search_(motion) {
  for (int place = 0; place < lookouts_; ++place) place_at_[static_cast<std::size_t>(node(place))] = place;
}

int RoadGraph::add_place(int node) {
  nodes_.push_back(node);
  roads_.emplace_back();
  roads_known_.push_back(false);
  return static_cast<int>(nodes_.size()) - 1;
}

void RoadGraph::forget_added_places() {
  const auto count = static_cast<std::size_t>(lookouts_);
  nodes_.resize(count);
  roads_.resize(count);
  roads_known_.resize(count);
  rows_.erase(rows_.lower_bound(lookouts_), rows_.end());
  all_paths_.erase(all_paths_.lower_bound(lookouts_), all_paths_.end());
}

const std::vector<RoadGraph::Road>& RoadGraph::roads(int place) {
  const auto p = static_cast<std::size_t>(place);
  if (roads_known_[p]) return roads_[p];
  roads_known_[p] = true;
  search_.run(node(place), [&](int reached, double cost_m) {
    const int there = place_at_[static_cast<std::size_t>(reached)];
    if (there < 0 || there == place) return true;
    roads_[p].push_back({there, cost_m, search_.nodes_to(reached)});
    return roads_[p].size() < nearest_;
  });
  return roads_[p];
}

const RoadGraph::Road* RoadGraph::road_between(int from, int to) {
  for (const Road& road : roads(from)) {
    if (road.to == to) return &road;
  }
  return nullptr;
}

const RoadGraph::Row& RoadGraph::row(int from) {
  const auto [entry, is_new] = rows_.try_emplace(from);
  Row& row = entry->second;
  if (!is_new) return row;
  row.cost_m.assign(static_cast<std::size_t>(lookouts_), std::numeric_limits<float>::infinity());
  row.previous.assign(static_cast<std::size_t>(lookouts_), -1);
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto relax = [&](int place, float cost_m, int previous) {
    for (const Road& road : roads(place)) {
      const auto to = static_cast<std::size_t>(road.to);
      const float next_m = cost_m + static_cast<float>(road.cost_m);
      if (next_m >= row.cost_m[to]) continue;
      row.cost_m[to] = next_m;
      row.previous[to] = previous;
      open.emplace(next_m, road.to);
    }
  };
  if (from < lookouts_) row.cost_m[static_cast<std::size_t>(from)] = 0.0F;
  relax(from, 0.0F, -1);
  while (!open.empty()) {
    const auto [cost_m, place] = open.top();
    open.pop();
    if (cost_m > row.cost_m[static_cast<std::size_t>(place)]) continue;
    relax(place, cost_m, place);
  }
  return row;
}

const ShortestPaths& RoadGraph::all_paths(int from) {
  const auto known = all_paths_.find(from);
  if (known != all_paths_.end()) return known->second;
  return all_paths_.emplace(from, motion_.shortest_paths(node(from))).first->second;
}

std::pair<const RoadGraph::Road*, double> RoadGraph::last_road(int from, int to) {
  const Road* best = nullptr;
  double best_m = kInfinity;
  for (const Road& road : roads(to)) {
    const double cost_m = road.cost_m + (road.to == from ? 0.0 : row(from).cost_m[static_cast<std::size_t>(road.to)]);
    if (cost_m >= best_m) continue;
    best = &road;
    best_m = cost_m;
  }
  return {best, best_m};
}

double RoadGraph::cost_m(int from, int to) {
  if (from == to || node(from) == node(to)) return 0.0;
  if (const Road* road = road_between(from, to)) return road->cost_m;
  double cost_m = kInfinity;
  if (to < lookouts_) {
    cost_m = row(from).cost_m[static_cast<std::size_t>(to)];
  } else {
    cost_m = last_road(from, to).second;
  }
  return std::isfinite(cost_m) ? cost_m : all_paths(from).cost_m[static_cast<std::size_t>(node(to))];
}

std::vector<int> RoadGraph::nodes_to_lookout(int from, int lookout) {
  std::vector<int> stops{lookout};
  while (row(from).previous[static_cast<std::size_t>(stops.back())] >= 0) {
    stops.push_back(row(from).previous[static_cast<std::size_t>(stops.back())]);
  }
  std::vector<int> nodes;
  int at = from;
  for (; !stops.empty(); stops.pop_back()) {
    append(nodes, road_between(at, stops.back())->nodes);
    at = stops.back();
  }
  return nodes;
}

std::vector<int> RoadGraph::nodes(int from, int to) {
  if (from == to || node(from) == node(to)) return {node(from)};
  if (const Road* road = road_between(from, to)) return road->nodes;
  if (to < lookouts_ && std::isfinite(row(from).cost_m[static_cast<std::size_t>(to)]))
    return nodes_to_lookout(from, to);
  if (to >= lookouts_) {
    if (const auto [last, last_m] = last_road(from, to); last != nullptr && std::isfinite(last_m)) {
      std::vector<int> nodes;
      if (last->to != from) nodes = nodes_to_lookout(from, last->to);
      append(nodes, {last->nodes.rbegin(), last->nodes.rend()});
      return nodes;
    }
  }
  const ShortestPaths& paths = all_paths(from);
  std::vector<int> nodes;
  if (!std::isfinite(paths.cost_m[static_cast<std::size_t>(node(to))])) return nodes;
  for (int at = node(to); at >= 0; at = paths.previous[static_cast<std::size_t>(at)]) nodes.push_back(at);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace tandem
