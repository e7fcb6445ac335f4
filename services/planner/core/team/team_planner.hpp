#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "services/planner/core/team/course.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

struct TeamPlannerOptions {
  int eligible = 8;              ///< Actions considered after each action, N_a of the paper.
  double exploration = 0.4;      ///< Weight of what was tried little, in parts of the spread of values.
  double rollout_spread = 0.35;  ///< A rollout takes anything within this share of the best score.
};

/// Multi-agent Monte Carlo tree search over the members' action sets (paper 4, digest F).
///
/// The first plan is coordinated greedy; every rollout can only replace the best plan so far by a better one.
class TeamPlanner : public Planner {
 public:
  explicit TeamPlanner(const TeamPlannerOptions& options) : options_(options) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return rollouts_; }
  [[nodiscard]] JointPlan best() override;

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

  [[nodiscard]] double value_s(const Routes& routes);

  TeamPlannerOptions options_;
  Rng rng_{0};
  std::unique_ptr<PreparedProblem> problem_;
  std::optional<SearchObjective> objective_;
  std::vector<Look> looks_;
  std::vector<Node> nodes_;
  Routes best_;
  double best_value_s_ = 0.0;
  double reference_s_ = 0.0;  ///< value of the first plan, the zero of the spread
  int rollouts_ = 0;
};

}  // namespace tandem
