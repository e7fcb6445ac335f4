#pragma once

#include <optional>

#include "services/planner/core/baselines/route_search.hpp"
#include "services/planner/core/team/planner.hpp"

namespace tandem {

struct SequentialOptions {
  RouteSearchOptions search;
  int tries_at_first = 16;    ///< routes tried for each member in the first round, twice as many in each that follows
  bool only_fastest = false;  ///< the member that gets farthest alone; the others stay
};

/// Sequential allocation (Hollinger et al., IJRR 2009): one member after the other, in the order given, plans its whole
/// route for the best while the routes planned before stay as they are, and those after are not thought of.
///
/// Each round does so anew with twice the effort; the best of the rounds is kept.
class SequentialPlanner final : public Planner {
 public:
  explicit SequentialPlanner(const SequentialOptions& options) : options_(options) {}

  void begin(const SearchProblem& problem, Rng rng) override;
  void run(int rollouts, const std::function<bool()>& stop) override;
  [[nodiscard]] int rollouts() const override { return rollouts_; }
  [[nodiscard]] JointPlan best() override { return problem_->plan(best_); }

 private:
  void plan_next_member();
  void end_round();

  SequentialOptions options_;
  Rng rng_{0};
  std::unique_ptr<PreparedProblem> problem_;
  std::optional<SearchObjective> objective_;
  std::vector<int> order_;  ///< in which members plan
  std::optional<RouteSearch> search_;
  std::size_t turn_ = 0;  ///< whose route is searched, in order_
  int tries_ = 0;         ///< of this round and member
  int tries_left_ = 0;
  Routes best_;
  double best_s_ = 0.0;
  int rollouts_ = 0;
};

}  // namespace tandem
