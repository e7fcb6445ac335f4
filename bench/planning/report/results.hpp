#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/planning/loop/first_plan.hpp"
#include "bench/planning/micro/micro.hpp"
#include "bench/planning/records/run_record.hpp"
#include "bench/planning/srs_worlds/task_run.hpp"
#include "bench/planning/statistics/statistics.hpp"

namespace tandem::bench {

/// All that was measured, with the questions a report asks of it.
struct Results {
  std::vector<RunRecord> runs;
  std::vector<FirstPlanRecord> first_plans;
  std::vector<MicroRecord> micro;
  std::vector<TaskRecord> tasks;

  /// E[T] of our planner against another's on the same instances of some families, at one budget.
  [[nodiscard]] PairedComparison compared_with(const std::string& ours, const std::string& theirs,
                                               const std::vector<std::string>& families,
                                               const std::string& budget) const;
  /// The budgets of runs of a family, ascending in their processor time.
  [[nodiscard]] std::vector<std::string> budgets_of(const std::string& family) const;
  [[nodiscard]] std::vector<std::string> families() const;  ///< of runs
  [[nodiscard]] std::vector<std::string> planners_in(const std::string& family, const std::string& budget) const;
  /// Of the runs of a planner in a family at a budget, one figure each.
  [[nodiscard]] std::vector<double> figure(const std::string& family, const std::string& planner,
                                           const std::string& budget, double RunRecord::*which) const;
  /// Values of first plans of `planner` after `budget_ms`, less the best that any planner found in any time, as parts
  /// of it.
  [[nodiscard]] std::vector<double> gaps_to_best(const std::string& family, const std::string& planner,
                                                 double budget_ms) const;
  /// Values of first plans after `budget_ms` over their certified bound, less 1; only those that have one.
  [[nodiscard]] std::vector<double> certified_gaps(const std::string& family, const std::string& planner,
                                                   double budget_ms) const;
  /// Values of first plans after `budget_ms` over the optimum, less 1, where the optimum is proven.
  [[nodiscard]] std::vector<double> exact_gaps(const std::vector<std::string>& families, const std::string& planner,
                                               double budget_ms) const;
  /// The best value known of each instance of a family, by seed.
  [[nodiscard]] std::map<std::uint64_t, double> best_known(const std::string& family) const;
  [[nodiscard]] std::vector<double> micro_values(const std::string& measure, const std::string& family) const;
};

/// The value after the greatest of a record's budgets that is at most `budget_ms`.
[[nodiscard]] std::optional<double> value_after(const FirstPlanRecord& record, double budget_ms,
                                                const std::vector<double>& values);

}  // namespace tandem::bench
