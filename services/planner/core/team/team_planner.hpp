#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "services/common/random.hpp"
#include "services/planner/core/team/course.hpp"

namespace tandem {

struct TeamPlannerOptions {
  int eligible = 8;              ///< Actions considered after each action, N_a of the paper.
  double exploration = 0.4;      ///< Weight of what was tried little, in parts of the spread of values.
  double rollout_spread = 0.35;  ///< A rollout takes anything within this share of the best score.
};

/// Multi-agent Monte Carlo tree search over the members' action sets (paper 4, digest F).
///
/// The first plan is coordinated greedy and exists at once; every rollout can only replace the best plan so far by a
/// better one. Equal problem, options, seed and number of rollouts give the same plan, bit for bit, however the
/// rollouts are cut into run() calls.
class TeamPlanner {
 public:
  /// `problem` must outlive the planner and have at least one member.
  TeamPlanner(const TeamProblem& problem, const TeamPlannerOptions& options, Rng rng);

  /// Makes `rollouts` more rollouts, or fewer if `stop` says so.
  void run(int rollouts, const std::function<bool()>& stop = {});

  [[nodiscard]] int rollouts() const { return rollouts_; }
  /// The value of the best plan so far [s]; it never grows.
  [[nodiscard]] double best_value_s() const { return best_.value_s; }
  /// The best plan so far, with paths.
  [[nodiscard]] JointPlan best();

 private:
  struct Node;
  struct Child {
    Choice choice;
    double prior = 0.0;
    int node = -1;
  };
  struct Node {
    int member = -1;  ///< who chooses here; -1: nobody any more
    bool expanded = false;
    int visits = 0;
    double best_s = 0.0;
    std::vector<Child> children;
  };
  void rollout();
  void complete(Course& course, bool randomly);
  double keep_if_better(const Course& course);
  [[nodiscard]] std::size_t child_to_try(const Node& node) const;

  const TeamProblem& problem_;
  TeamPlannerOptions options_;
  Rng rng_;
  SearchForecaster forecaster_;
  std::vector<Node> nodes_;
  JointPlan best_;
  bool has_best_ = false;
  double reference_s_ = 0.0;  ///< value of the first plan, the zero of the spread
  int rollouts_ = 0;
};

}  // namespace tandem
