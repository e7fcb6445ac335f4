#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/motion/motion_map.hpp"

namespace tandem {

/// A place of a tree and the place before it.
struct TreeNode {
  Eigen::Vector2d point_in_map;  ///< [m]
  int parent = -1;               ///< -1 at the root
  double cost_m = 0.0;           ///< length of the way from the root [m]
};

/// RRT* (Karaman and Frazzoli, IJRR 2011): a tree of straight movements of at most `step_m` that is rewired towards
/// shortest ways as it grows.
///
/// The cost is the length, never a reward: with rewards that depend on the past the tree would not converge (digest
/// E1).
class RrtStar {
 public:
  /// `motion` must outlive it; `radius_m` is the clearance of the body, `root_in_map` where the tree begins.
  RrtStar(const MotionMap& motion, double radius_m, double step_m, const Eigen::Vector2d& root_in_map);
  ~RrtStar();
  RrtStar(RrtStar&&) noexcept;
  RrtStar& operator=(RrtStar&&) = delete;
  RrtStar(const RrtStar&) = delete;
  RrtStar& operator=(const RrtStar&) = delete;

  /// Extends the tree once towards `sample_in_map`; returns the new node, none if an obstacle is in the way or the
  /// place is in the tree already.
  std::optional<int> extend(const Eigen::Vector2d& sample_in_map);
  /// The nodes within `reach_m` of a point that a straight movement joins with it, nearest first.
  [[nodiscard]] std::vector<int> joined_within(const Eigen::Vector2d& point_in_map, double reach_m) const;

  [[nodiscard]] const std::vector<TreeNode>& nodes() const { return nodes_; }

 private:
  struct Index;
  [[nodiscard]] bool is_free(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const;
  [[nodiscard]] std::vector<std::pair<int, double>> within(const Eigen::Vector2d& point, double reach_m) const;
  void add_node(const Eigen::Vector2d& point, int parent);
  void move_below(int node, int parent);

  const MotionMap* motion_;
  double radius_m_;
  double step_m_;
  std::vector<TreeNode> nodes_;
  std::vector<std::vector<int>> children_;
  std::unique_ptr<Index> index_;
};

/// A place drawn evenly from where a body can stand, within the reach of one node of `motion`, which must not be empty.
[[nodiscard]] Eigen::Vector2d random_place(const MotionMap& motion, Rng& rng);

}  // namespace tandem
