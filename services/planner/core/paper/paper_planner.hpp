#pragma once

#include <memory>
#include <set>
#include <variant>
#include <vector>

#include "services/planner/core/paper/joint_reward.hpp"
#include "services/planner/core/paper/multi_rrt.hpp"
#include "services/planner/core/paper/selection_update.hpp"
#include "services/planner/core/team/planner.hpp"
#include "services/planner/core/team/prepared_problem.hpp"

namespace tandem {

/// What the best plan is the best in.
enum class PaperObjective {
  DetectedMass,  ///< as printed
  ExpectedTime   ///< corrected (digest A1, A2)
};

struct PaperOptions {
  MultiRrtOptions trees;
  PruningOptions pruning;
  SelectionUpdate update;
  PaperObjective objective = PaperObjective::DetectedMass;
  double rest_sweeps = 1.0;        ///< see NegativeExpectedTime
  bool replans_under_way = false;  ///< see Planner
};

/// Algorithm 1 of the paper: multiple RRT* per agent, pruned to the actions that reward it alone, joint rollouts drawn
/// from q, and the best of the joint plans met. What is as printed and what is charitable: docs/planner_paper.md.
///
/// "Best" is meant in its own objective, best_reward(), which never falls; the expected time may well grow with it.
class PaperPlanner : public Planner {
 public:
  explicit PaperPlanner(const PaperOptions& options) : options_(options) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return rollouts_; }
  [[nodiscard]] JointPlan best() override;
  [[nodiscard]] bool replans_under_way() const override { return options_.replans_under_way; }

  /// g of the best plan so far; higher is better.
  [[nodiscard]] double best_reward() const { return best_reward_; }
  /// The pruned action set of a member.
  [[nodiscard]] const ActionTree& actions(std::size_t member) const { return trees_[member]; }

 private:
  using LastActions = std::array<int, kMostAgents>;
  [[nodiscard]] ActionTree grown_actions(std::size_t member);
  [[nodiscard]] ActionTree pruned(std::vector<TreeNode> nodes, std::size_t member);
  [[nodiscard]] std::vector<Eigen::Vector2d> richest_places(ActionSet& actions) const;
  void expand_end_states();
  void take(const LastActions& last_actions);
  [[nodiscard]] std::vector<TimedPath> paths(const LastActions& last_actions) const;

  PaperOptions options_;
  Rng rng_{0};
  std::unique_ptr<PreparedProblem> problem_;
  std::vector<double> mass_;  ///< of all objects, without what is detected whatever is planned
  std::vector<ActionTree> trees_;
  std::vector<ActionTree*> tree_pointers_;
  JointState root_;
  std::unique_ptr<std::variant<DetectedMass, NegativeExpectedTime>> objective_;
  std::set<LastActions> met_;  ///< T of the paper: in action trees the last actions are the whole plan
  LastActions best_{};
  double best_reward_ = 0.0;
  bool has_best_ = false;
  bool best_is_rejected_ = false;
  int rollouts_ = 0;
};

}  // namespace tandem
