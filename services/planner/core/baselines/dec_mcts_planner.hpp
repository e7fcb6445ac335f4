#pragma once

#include <optional>

#include "services/planner/core/baselines/route_distribution.hpp"
#include "services/planner/core/baselines/route_search.hpp"
#include "services/planner/core/baselines/route_tree.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

struct DecMctsOptions {
  RouteTreeOptions tree;
  RouteSearchOptions rollout;    ///< how routes are ended: greedily at random, what others intend to see left out
  int successors = 8;            ///< places considered after each place
  int growths = 10;              ///< of each tree between two messages
  int intentions = 10;           ///< routes in a distribution
  int messages_per_choice = 10;  ///< after so many messages the routes in the distribution are chosen anew
  int samples = 4;               ///< of the others' plans, for the expected reward of a route
  double step = 0.1;             ///< of the gradient
  double temperature = 0.5;      ///< at first
  double cooling = 0.98;         ///< from message to message
};

/// Dec-MCTS (Best, Cliff, Patten, Mettu and Fitch, IJRR 2019), all robots in one process: each grows a tree of its own
/// against plans drawn from what the others say they intend, makes its own intention better by variational gradient,
/// and tells it to the others.
///
/// Its reward is the share of the expected time that a robot's route saves beyond what the others' routes save. The
/// best joint plan that any robot met is the result, which is kinder than the likeliest routes alone.
class DecMctsPlanner final : public Planner {
 public:
  explicit DecMctsPlanner(const DecMctsOptions& options) : options_(options) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  /// One rollout is one growth of one tree.
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return rollouts_; }
  [[nodiscard]] JointPlan best() override { return problem_->plan(best_); }

 private:
  struct Robot {
    RouteTree tree;
    RouteDistribution intention;  ///< as told to the others
    double scale_s = 1.0;         ///< the most that a route of it has saved
  };
  void grow(std::size_t robot);
  void send_messages();
  /// Routes of all others, drawn from what they intend.
  [[nodiscard]] Routes drawn_routes(std::size_t robot);
  [[nodiscard]] double expected_time_s(const Routes& routes);

  DecMctsOptions options_;
  Rng rng_{0};
  std::unique_ptr<PreparedProblem> problem_;
  std::optional<SearchObjective> objective_;
  std::vector<Look> looks_;
  std::vector<Robot> robots_;
  Routes best_;
  double best_s_ = 0.0;
  double temperature_ = 1.0;
  int messages_ = 0;
  int rollouts_ = 0;
};

}  // namespace tandem
