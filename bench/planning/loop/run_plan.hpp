#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/planning/loop/result_line.hpp"

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

/// Makes the runs that `results_file` does not hold yet, on `threads` threads, and appends each as a line as soon as it
/// is done; `on_record` hears of each, `stop` is asked before each. Gives all requested records there are, the old ones
/// too, in the order of `requests`.
[[nodiscard]] std::vector<RunRecord> made_runs(const std::vector<RunRequest>& requests,
                                               const std::filesystem::path& results_file, int threads,
                                               const std::function<void(const RunRecord&, std::size_t left)>& on_record,
                                               const std::function<bool()>& stop);

}  // namespace tandem::bench
