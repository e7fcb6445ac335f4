#include "services/planner/core/motion/local_search.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr auto kLater = [](const auto& a, const auto& b) {
  return a.cost_m != b.cost_m ? a.cost_m > b.cost_m : a.node > b.node;
};

}  // namespace

LocalSearch::LocalSearch(const MotionMap& motion)
    : motion_(motion),
      seen_in_(static_cast<std::size_t>(motion.size()), 0),
      cost_m_(seen_in_.size()),
      previous_(seen_in_.size()) {}

void LocalSearch::run(int from, const std::function<bool(int, double)>& reached) {
  ++search_;
  open_.clear();
  const auto see = [&](std::int32_t node, float cost_m, std::int32_t previous) {
    const auto n = static_cast<std::size_t>(node);
    if (seen_in_[n] == search_ && cost_m_[n] <= cost_m) return;
    seen_in_[n] = search_;
    cost_m_[n] = cost_m;
    previous_[n] = previous;
    open_.push_back({cost_m, node});
    std::push_heap(open_.begin(), open_.end(), kLater);
  };
  see(from, 0.0F, -1);
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), kLater);
    const Entry next = open_.back();
    open_.pop_back();
    if (next.cost_m > cost_m_[static_cast<std::size_t>(next.node)]) continue;
    if (!reached(next.node, next.cost_m)) return;
    for (const MotionMap::Edge& edge : motion_.edges(next.node)) see(edge.to, next.cost_m + edge.cost_m, next.node);
  }
}

std::vector<int> LocalSearch::nodes_to(int node) const {
  std::vector<int> nodes;
  for (std::int32_t at = node; at >= 0; at = previous_[static_cast<std::size_t>(at)]) nodes.push_back(at);
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace tandem
