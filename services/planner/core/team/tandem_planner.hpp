#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "services/planner/core/team/joint_tree.hpp"
#include "services/planner/core/team/planner.hpp"
#include "services/planner/core/team/refinement.hpp"

namespace tandem {

struct TandemOptions {
  JointTreeOptions tree;
  WalkOptions walk;
  RefinementOptions refinement;
  int moves = 48;          ///< of refinement in a rollout; 0: tree only
  int tree_every = 128;    ///< only one rollout of so many goes through the tree, of fewer with few lookouts; 0: none
  bool seeds = true;       ///< greedy of two exponents, sequential allocation; else one greedy
  bool warm_start = true;  ///< the plan in execution is a seed, too
};

/// Tandem's planner (digest 4): seeds first, then a joint asynchronous tree search and a refinement that tell each
/// other what they find.
///
/// The first plan is the best of its seeds, so no plan is worse than any of them: coordinated greedy by gain / time and
/// gain / time^1.5, sequential allocation, mowing (areas of up to 5000 cells), what is left of the plan in execution.
class TandemPlanner final : public Planner {
 public:
  explicit TandemPlanner(const TandemOptions& options) : options_(options) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return rollouts_; }
  [[nodiscard]] JointPlan best() override;
  [[nodiscard]] double lower_bound_s() override;

 private:
  void take_seed(Routes routes);
  [[nodiscard]] Routes greedy(double exponent, bool one_after_the_other) const;
  /// The lookouts of the plan in execution.
  [[nodiscard]] Routes running_plan() const;

  TandemOptions options_;
  Rng rng_{0};
  std::unique_ptr<PreparedProblem> problem_;
  TeamGround ground_;
  std::optional<RouteValue> value_;
  std::optional<JointTree> tree_;
  std::optional<Refinement> refinement_;
  Routes best_;
  double best_s_ = 0.0;
  Routes incumbent_;  ///< the best that was asked for, or the best seed: by its exact value
  double incumbent_s_ = 0.0;
  int tree_every_ = 0;             ///< rollouts
  std::optional<double> bound_s_;  ///< of this problem, once it was asked for
  int rollouts_ = 0;
};

}  // namespace tandem
