#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/planning/records/run_record.hpp"

namespace tandem::bench {

/// A run still to be made.
struct RunRequest {
  RunKey key;
  PlanningBudget budget;
};

/// Each instance with each planner and each budget, instance by instance.
[[nodiscard]] std::vector<RunRequest> all_runs(const std::vector<std::string>& families,
                                               const std::vector<std::uint64_t>& seeds,
                                               const std::vector<std::string>& planners,
                                               const std::vector<PlanningBudget>& budgets);

/// `1:6`, `3`, `1,4,7:9` as numbers; throws ConfigError on anything else.
[[nodiscard]] std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// The budgets in `50,200` [ms] or `500r` (rollouts); throws ConfigError on anything else.
[[nodiscard]] std::vector<PlanningBudget> parse_budgets(const std::string& text);

/// Plays one search.
[[nodiscard]] RunRecord made_run(const RunRequest& request);

}  // namespace tandem::bench
