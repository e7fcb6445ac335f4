#pragma once

#include <functional>
#include <vector>

#include "services/common/random.hpp"

namespace tandem {

struct RouteTreeOptions {
  double exploration = 0.35;  ///< C_p of D-UCT, in parts of the reward, which is about 1
  double discount = 0.98;     ///< of what was learnt one visit of the tree ago: the others' plans change meanwhile
};

/// One robot's tree of Dec-MCTS: grown by UCT with discounted rewards (D-UCT; Best et al., IJRR 2019; Garivier and
/// Moulines 2011). It knows routes only as sequences of numbers; rewards are about in [0, 1].
class RouteTree {
 public:
  explicit RouteTree(const RouteTreeOptions& options) : options_(options), nodes_(1) {}

  /// What the problem says of a route so far: where it can go next.
  using Successors = std::function<std::vector<int>(const std::vector<int>& route)>;
  /// Ends the route and gives its reward; may append to it.
  using Simulate = std::function<double(std::vector<int>& route)>;

  /// Selection, expansion by one node, simulation, backpropagation.
  void grow(const Successors& successors, const Simulate& simulate, Rng& rng);

  /// The best routes of the nodes with the highest discounted mean reward, each route once, at most `count`.
  [[nodiscard]] std::vector<std::vector<int>> best_routes(std::size_t count) const;
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  struct Node {
    int place = -1;
    bool expanded = false;
    std::vector<int> untried;   ///< successors without a node
    std::vector<int> children;  ///< nodes
    double visits = 0.0;        ///< discounted, as of `as_of`
    double reward = 0.0;        ///< discounted sum, as of `as_of`
    int as_of = 0;
    double best_reward = -1.0;
    std::vector<int> best_route;
  };
  [[nodiscard]] double faded(const Node& node) const;
  [[nodiscard]] int child_to_visit(const Node& node) const;

  RouteTreeOptions options_;
  std::vector<Node> nodes_;
  int visits_ = 0;
};

}  // namespace tandem
