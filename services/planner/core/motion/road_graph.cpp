#include "services/planner/core/motion/road_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tandem {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A plan begins at an added place, perhaps far from what is worth seeing, and ends at one: times `nearest`.
constexpr std::size_t kRoadsOfAdded = 4;

}  // namespace

RoadGraph::RoadGraph(const MotionMap& motion, std::vector<int> lookouts, int nearest)
    : motion_(motion),
      lookouts_(static_cast<int>(lookouts.size())),
      nearest_(static_cast<std::size_t>(nearest)),
      nodes_(std::move(lookouts)),
      place_at_(static_cast<std::size_t>(motion.size()), -1),
      roads_(nodes_.size()),
      ends_(nodes_.size()),
      roads_known_(nodes_.size(), false),
      search_(motion),
      reached_in_(nodes_.size(), 0),
      reached_m_(nodes_.size()),
      reached_from_(nodes_.size()) {
  for (int place = 0; place < lookouts_; ++place) place_at_[static_cast<std::size_t>(node(place))] = place;
}

int RoadGraph::add_place(int node) {
  nodes_.push_back(node);
  roads_.emplace_back();
  ends_.emplace_back();
  roads_known_.push_back(false);
  return static_cast<int>(nodes_.size()) - 1;
}

void RoadGraph::forget_added_places() {
  const auto count = static_cast<std::size_t>(lookouts_);
  nodes_.resize(count);
  roads_.resize(count);
  ends_.resize(count);
  roads_known_.resize(count);
  rows_.erase(rows_.lower_bound(lookouts_), rows_.end());
  added_roads_.clear();
  added_stops_.clear();
  all_paths_.erase(all_paths_.lower_bound(lookouts_), all_paths_.end());
}

const std::vector<RoadGraph::Road>& RoadGraph::roads(int place) {
  const auto p = static_cast<std::size_t>(place);
  if (roads_known_[p]) return roads_[p];
  roads_known_[p] = true;
  const std::size_t most = place < lookouts_ ? nearest_ : kRoadsOfAdded * nearest_;
  search_.run(node(place), [&](int reached, double cost_m) {
    const int there = place_at_[static_cast<std::size_t>(reached)];
    if (there < 0 || there == place) return true;
    roads_[p].push_back({there, cost_m, search_.nodes_to(reached)});
    ends_[p].push_back(there);
    return roads_[p].size() < most;
  });
  return roads_[p];
}

const std::vector<std::int32_t>& RoadGraph::ends(int place) {
  (void)roads(place);
  return ends_[static_cast<std::size_t>(place)];
}

const RoadGraph::Road& RoadGraph::road_between_added(int from, int to) {
  const auto [entry, is_new] = added_roads_.try_emplace({from, to});
  Road& road = entry->second;
  if (!is_new) return road;
  road = {to, kInfinity, {}};
  search_.run(node(from), [&](int reached, double cost_m) {
    if (reached != node(to)) return true;
    road.cost_m = cost_m;
    road.nodes = search_.nodes_to(reached);
    return false;
  });
  return road;
}

const RoadGraph::Road* RoadGraph::road_between(int from, int to) {
  if (from >= lookouts_ && to >= lookouts_) {
    const Road& road = road_between_added(from, to);
    return road.nodes.empty() ? nullptr : &road;
  }
  for (const Road& road : roads(from)) {
    if (road.to == to) return &road;
  }
  return nullptr;
}

void RoadGraph::explore(int from, const std::function<bool(int, double)>& reached) {
  ++exploration_;
  open_.clear();
  const auto is_later = [](const Open& a, const Open& b) {
    return a.cost_m != b.cost_m ? a.cost_m > b.cost_m : a.lookout > b.lookout;
  };
  const auto relax = [&](int place, float cost_m, std::int32_t previous) {
    for (const Road& road : roads(place)) {
      const auto to = static_cast<std::size_t>(road.to);
      const float next_m = cost_m + static_cast<float>(road.cost_m);
      if (reached_in_[to] == exploration_ && reached_m_[to] <= next_m) continue;
      reached_in_[to] = exploration_;
      reached_m_[to] = next_m;
      reached_from_[to] = previous;
      open_.push_back({next_m, road.to});
      std::push_heap(open_.begin(), open_.end(), is_later);
    }
  };
  if (from < lookouts_) {
    reached_in_[static_cast<std::size_t>(from)] = exploration_;
    reached_m_[static_cast<std::size_t>(from)] = 0.0F;
  }
  relax(from, 0.0F, -1);
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), is_later);
    const Open next = open_.back();
    open_.pop_back();
    if (next.cost_m > reached_m_[static_cast<std::size_t>(next.lookout)]) continue;
    if (!reached(next.lookout, next.cost_m)) return;
    relax(next.lookout, next.cost_m, next.lookout);
  }
}

const std::vector<float>& RoadGraph::row(int from) {
  const auto [entry, is_new] = rows_.try_emplace(from);
  std::vector<float>& cost_m = entry->second;
  if (!is_new) return cost_m;
  cost_m.assign(static_cast<std::size_t>(lookouts_), std::numeric_limits<float>::infinity());
  if (from < lookouts_) cost_m[static_cast<std::size_t>(from)] = 0.0F;
  explore(from, [&](int lookout, double reached_m) {
    cost_m[static_cast<std::size_t>(lookout)] = static_cast<float>(reached_m);
    return true;
  });
  return cost_m;
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
    const double cost_m = road.cost_m + (road.to == from ? 0.0 : row(from)[static_cast<std::size_t>(road.to)]);
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
    cost_m = row(from)[static_cast<std::size_t>(to)];
  } else {
    cost_m = last_road(from, to).second;
  }
  return std::isfinite(cost_m) ? cost_m : all_paths(from).cost_m[static_cast<std::size_t>(node(to))];
}

const std::vector<int>& RoadGraph::stops(int from, int to) {
  auto& known = from < lookouts_ && to < lookouts_ ? stops_ : added_stops_;
  const auto key = static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint32_t>(to);
  const auto [entry, is_new] = known.try_emplace(key);
  if (is_new) entry->second = found_stops(from, to);
  return entry->second;
}

std::vector<int> RoadGraph::found_stops(int from, int to) {
  if (from == to || node(from) == node(to) || road_between(from, to) != nullptr) return {to};
  int last = -1;  // the last lookout on the way
  double best_m = kInfinity;
  if (to < lookouts_) {
    explore(from, [&](int lookout, double /*cost_m*/) {
      if (lookout == to) last = to;
      return last < 0;
    });
  } else {
    const std::vector<Road>& around = roads(to);
    for (const Road& road : around) {
      if (road.to == from) best_m = road.cost_m;
    }
    explore(from, [&](int lookout, double cost_m) {
      const auto road = std::ranges::find(around, lookout, &Road::to);
      if (road != around.end() && cost_m + road->cost_m < best_m) {
        last = lookout;
        best_m = cost_m + road->cost_m;
      }
      return cost_m < best_m;
    });
    if (last < 0 && std::isfinite(best_m)) return {to};
  }
  if (last < 0) {
    const bool is_reached = std::isfinite(all_paths(from).cost_m[static_cast<std::size_t>(node(to))]);
    return is_reached ? std::vector<int>{to} : std::vector<int>{};
  }
  std::vector<int> backwards;
  if (last != to) backwards.push_back(to);
  for (std::int32_t at = last; at >= 0 && at != from; at = reached_from_[static_cast<std::size_t>(at)]) {
    backwards.push_back(at);
  }
  return {backwards.rbegin(), backwards.rend()};
}

std::vector<int> RoadGraph::nodes(int from, int to) {
  if (from == to || node(from) == node(to)) return {node(from)};
  if (const Road* road = road_between(from, to)) return road->nodes;
  if (to >= lookouts_) {
    for (const Road& road : roads(to)) {
      if (road.to == from) return {road.nodes.rbegin(), road.nodes.rend()};
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
