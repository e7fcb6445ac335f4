#include "services/planner/core/baselines/route_tree.hpp"

#include <algorithm>
#include <cmath>

namespace tandem {

double RouteTree::faded(const Node& node) const {
  return std::pow(options_.discount, visits_ - node.as_of);
}

int RouteTree::child_to_visit(const Node& node) const {
  double visits = 0.0;
  for (const int child : node.children) {
    const Node& below = nodes_[static_cast<std::size_t>(child)];
    visits += below.visits * faded(below);
  }
  int best = -1;
  double best_score = -1.0;
  for (const int child : node.children) {
    const Node& below = nodes_[static_cast<std::size_t>(child)];
    const double tried = std::max(1e-9, below.visits * faded(below));
    const double score =
        below.reward / below.visits + 2.0 * options_.exploration * std::sqrt(std::max(0.0, std::log(visits)) / tried);
    if (score <= best_score) continue;
    best_score = score;
    best = child;
  }
  return best;
}

void RouteTree::grow(const Successors& successors, const Simulate& simulate, Rng& rng) {
  ++visits_;
  std::vector<int> visited{0};
  std::vector<int> route;
  for (;;) {
    const auto at = static_cast<std::size_t>(visited.back());
    if (!nodes_[at].expanded) {
      nodes_[at].untried = successors(route);
      nodes_[at].expanded = true;
    }
    if (!nodes_[at].untried.empty()) {
      const std::size_t which = rng.index(nodes_[at].untried.size());
      Node leaf;
      leaf.place = nodes_[at].untried[which];
      nodes_[at].untried.erase(nodes_[at].untried.begin() + static_cast<std::ptrdiff_t>(which));
      nodes_[at].children.push_back(static_cast<int>(nodes_.size()));
      visited.push_back(static_cast<int>(nodes_.size()));
      route.push_back(leaf.place);
      nodes_.push_back(std::move(leaf));
      break;
    }
    if (nodes_[at].children.empty()) break;
    visited.push_back(child_to_visit(nodes_[at]));
    route.push_back(nodes_[static_cast<std::size_t>(visited.back())].place);
  }
  const double reward = simulate(route);
  for (const int index : visited) {
    Node& node = nodes_[static_cast<std::size_t>(index)];
    const double kept = faded(node);
    node.visits = node.visits * kept + 1.0;
    node.reward = node.reward * kept + reward;
    node.as_of = visits_;
    if (reward <= node.best_reward) continue;
    node.best_reward = reward;
    node.best_route = route;
  }
}

std::vector<std::vector<int>> RouteTree::best_routes(std::size_t count) const {
  std::vector<int> order;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].visits > 0.0) order.push_back(static_cast<int>(i));
  }
  std::ranges::stable_sort(order, std::greater<>{}, [&](int i) {
    const Node& node = nodes_[static_cast<std::size_t>(i)];
    return node.reward / node.visits;
  });
  std::vector<std::vector<int>> routes;
  for (const int i : order) {
    if (routes.size() >= count) break;
    const auto& route = nodes_[static_cast<std::size_t>(i)].best_route;
    if (std::ranges::find(routes, route) == routes.end()) routes.push_back(route);
  }
  return routes;
}

}  // namespace tandem
