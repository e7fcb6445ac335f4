#pragma once

#include <cstdint>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/team/joint_walk.hpp"
#include "services/planner/core/team/route_value.hpp"

namespace tandem {

struct JointTreeOptions {
  int eligible = 8;              ///< Actions considered after each action, N_a of the paper.
  double exploration = 0.4;      ///< Weight of what was tried little, in parts of the spread of values.
  double rollout_spread = 0.35;  ///< A rollout takes anything within this share of the best score.
  int deepest = 24;              ///< Joint decisions below the root that the tree remembers.
};

/// The joint search tree over the members' actions (paper 4, digest F): a node is who goes where and when they arrive,
/// so it branches only for whoever arrives first.
///
/// Selection by PUCT, with the share of a child in the scores of its parent's choices as prior and the best value met
/// below it as worth; few children at first, more with the visits (progressive widening).
class JointTree {
 public:
  /// Both must outlive it.
  JointTree(const TeamGround& ground, RouteValue& value, const JointTreeOptions& options, const WalkOptions& walk);

  /// One rollout: down the tree, then greedy at random to the end. Gives its value; routes() are its routes.
  double rollout(Rng& rng);
  /// Remembers routes that were found otherwise, with their value.
  void remember(const Routes& routes, double value_s);

  [[nodiscard]] const Routes& routes() const { return walk_.routes(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }

 private:
  struct Child {
    Choice choice;
    double prior = 0.0;
    std::int32_t node = -1;
  };
  struct Node {
    int member = -1;  ///< who chooses here; -1: nobody any more
    bool expanded = false;
    int visits = 0;
    double best_s = 0.0;
    std::uint32_t first_child = 0;
    std::uint32_t children = 0;
    std::int32_t extra = -1;  ///< a remembered child that is not among the choices: index in children_
  };
  void expand(std::size_t node);
  [[nodiscard]] std::size_t child_to_try(const Node& node) const;
  std::size_t node_of(std::size_t child);
  void learn(double value_s);

  RouteValue* value_;
  JointTreeOptions options_;
  JointWalk walk_;
  std::vector<Node> nodes_;
  std::vector<Child> children_;
  std::vector<std::size_t> visited_;
  std::vector<std::size_t> next_;  ///< per member, while routes are remembered
  double best_s_ = 0.0;
  double worst_s_ = 0.0;  ///< of the first value, the zero of the spread
};

}  // namespace tandem
