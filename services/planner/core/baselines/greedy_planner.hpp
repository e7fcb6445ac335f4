#pragma once

#include "services/planner/core/baselines/one_plan_planner.hpp"

namespace tandem {

/// What a member knows of the others when it chooses.
enum class Mates {
  Coordinated,  ///< what each is on its way to see
  NoIntent,     ///< only what each has seen before the plan was made
  Independent   ///< nothing, not even that
};

struct GreedyOptions {
  double exponent = 1.0;  ///< goes where gain / time^exponent is greatest
  int most_options = 40;  ///< looked at each time
  Mates mates = Mates::Coordinated;
};

/// Utility-greedy search: whoever arrives first goes where it shows most new mass for its time.
class GreedyPlanner final : public OnePlanPlanner {
 public:
  explicit GreedyPlanner(const GreedyOptions& options) : options_(options) {}
  [[nodiscard]] bool shares_looks() const override { return options_.mates != Mates::Independent; }

 private:
  [[nodiscard]] Routes routes(const PreparedProblem& problem) const override;

  GreedyOptions options_;
};

/// The routes of coordinated greedy, of `only` one member if that is not -1: the others stay.
[[nodiscard]] Routes greedy_routes(const PreparedProblem& problem, double exponent, int most_options, int only = -1);

/// What greedy chooses: the option with the greatest gain / time^exponent, the first of equals; -1 without options.
[[nodiscard]] int greediest(const std::vector<WalkOption>& options, double exponent);

}  // namespace tandem
