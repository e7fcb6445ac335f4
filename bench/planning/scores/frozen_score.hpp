#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "bench/planning/loop/run_plan.hpp"

namespace tandem::bench {

/// How a planner does on a scenario of bench/planning/scenarios: a line of its scores.jsonl. All of it is exact, and
/// equal bit for bit wherever the arithmetic is: budgets are rollouts, not time.
struct FrozenScore {
  struct Key {
    std::string scenario;  ///< FAMILY_SEED, the name of its file
    std::string planner;   ///< NAME[:key=value,...] or exec:COMMAND

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  Key key;
  int rollouts = 0;             ///< of each plan; 0 for planners that make none, or are told a time instead
  double plan_s = 0.0;          ///< E[T] of the plan made at the start
  double plan_bound_s = 0.0;    ///< its certified lower bound, 0: none
  double search_s = 0.0;        ///< E[T] of the whole search, planned anew on the way
  double search_bound_s = 0.0;  ///< what nobody can beat: sweep_lower_bound_s()
  double search_left = 0.0;     ///< probability that nothing was found at its end
  int plans = 0;                ///< made in the search

  template <typename Self, typename Visitor>
  static void visit_fields(Self& score, Visitor&& field) {
    field("scenario", score.key.scenario);
    field("planner", score.key.planner);
    field("rollouts", score.rollouts);
    field("plan_s", score.plan_s);
    field("plan_bound_s", score.plan_bound_s);
    field("search_s", score.search_s);
    field("search_bound_s", score.search_bound_s);
    field("search_left", score.search_left);
    field("plans", score.plans);
  }
};

/// A score still to be computed.
struct FrozenScoreRequest {
  FrozenScore::Key key;
  RunRequest run;
};

/// The names of the scenarios in a folder: its files FAMILY_SEED.json, in the order of the alphabet. Throws ConfigError
/// if there are none.
[[nodiscard]] std::vector<std::string> frozen_scenarios(const std::filesystem::path& folder);

/// What to run for `planner` on a frozen scenario: as many rollouts as it makes in about 100 ms on the machine of the
/// reports, for another program a time of 100 ms. Throws ConfigError if the name is not FAMILY_SEED.
[[nodiscard]] FrozenScoreRequest frozen_score_request(const std::string& scenario, const std::string& planner);

/// Plays the search.
[[nodiscard]] FrozenScore made_frozen_score(const FrozenScoreRequest& request);

/// A line for each planner, the best first: E[T] of its search of each scenario, and how many times the time of
/// `baseline` that is (geometric mean over the scenarios that both have).
[[nodiscard]] std::string score_table(std::span<const FrozenScore> scores, const std::string& baseline);

}  // namespace tandem::bench
