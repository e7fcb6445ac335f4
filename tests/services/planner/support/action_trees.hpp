#pragma once

#include <vector>

#include "services/planner/core/paper/action_tree.hpp"

namespace tandem {

/// A movement of a tree made by hand: it comes after `parent`, lasts so long, and at its end the cell comes into view
/// and is seen for `look_s`.
struct HandAction {
  int parent = 0;
  double duration_s = 1.0;
  int cell = -1;        ///< -1: shows nothing
  double kept = 0.0;    ///< see Draw
  double look_s = 0.0;  ///< counted after the end
};

/// The tree of these actions, numbered from 1, below a root; all are eligible and equally likely.
inline ActionTree hand_tree(const std::vector<HandAction>& actions) {
  ActionTree tree(1);
  tree[0].path.points = {{0.0, {0.0, 0.0}}};
  for (const HandAction& by_hand : actions) {
    const Action& parent = tree[static_cast<std::size_t>(by_hand.parent)];
    Action action;
    action.parent = by_hand.parent;
    action.duration_ms = std::llround(1e3 * by_hand.duration_s);
    action.start_s = parent.start_s + parent.path.duration_s();
    const Eigen::Vector2d from = parent.path.points.back().point_in_map;
    action.path.points = {{0.0, from}, {by_hand.duration_s, from + Eigen::Vector2d{by_hand.duration_s, 0.0}}};
    if (by_hand.cell >= 0) {
      action.draws = {{by_hand.cell, by_hand.kept}};
      action.seen = {{by_hand.cell}, {by_hand.duration_s}, {by_hand.duration_s + by_hand.look_s}};
    }
    const int index = static_cast<int>(tree.size());
    tree[static_cast<std::size_t>(by_hand.parent)].eligible.push_back(index);
    tree.push_back(std::move(action));
  }
  for (Action& action : tree) {
    action.selection.assign(action.eligible.size(), 1.0 / static_cast<double>(action.eligible.size()));
  }
  return tree;
}

}  // namespace tandem
