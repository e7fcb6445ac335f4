#pragma once

#include <vector>

#include "services/planner/core/paper/rrt_star.hpp"

namespace tandem {

struct MultiRrtOptions {
  int nodes = 3000;     ///< of the tree that begins at the agent
  int goal_trees = 4;   ///< trees centred on positive sources
  int goal_nodes = 40;  ///< of each of them
  double step_m = 2.0;  ///< the longest movement
};

/// The multiple RRT* of one agent (paper 4.3): a tree from the agent, and trees from the `sources`, each joined with it
/// where that gives the shortest way to the source, so that a sequence leads to each of them.
///
/// A tree for each source is impossible where every search cell is one, so `sources` are a few of them, best first
/// (digest E2); trees beyond `options.goal_trees` are not grown. Of a source's tree only the way to the source is used:
/// on what branches off behind it sequences only get longer, which an objective without order takes for better. Parents
/// stand before their children; node 0 is the root.
[[nodiscard]] std::vector<TreeNode> multi_rrt(const MotionMap& motion, double radius_m,
                                              const Eigen::Vector2d& start_in_map,
                                              const std::vector<Eigen::Vector2d>& sources,
                                              const MultiRrtOptions& options, Rng& rng);

/// As multi_rrt, for an agent whose goal is fixed (digest H1): every sequence ends at `goal_in_map`, on ways at most
/// half as long again as the shortest and 4 m. Only the root if the trees do not meet.
[[nodiscard]] std::vector<TreeNode> multi_rrt_to(const MotionMap& motion, double radius_m,
                                                 const Eigen::Vector2d& start_in_map,
                                                 const Eigen::Vector2d& goal_in_map, const MultiRrtOptions& options,
                                                 Rng& rng);

}  // namespace tandem
