#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/planning/loop/closed_loop.hpp"

namespace tandem::bench {

/// What was run: a line of a results file is known by it.
struct RunKey {
  std::string family;
  std::uint64_t seed = 0;  ///< of the instance
  std::string planner;     ///< NAME[:key=value,...]
  std::string budget;      ///< "200ms" or "500rollouts"
  std::uint64_t planner_seed = 1;

  friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

[[nodiscard]] std::string budget_label(const PlanningBudget& budget);

/// One run in figures: what stands in a line of a results file.
struct RunRecord {
  RunKey key;
  bool finished = false;
  double expected_time_s = 0.0;
  double probability_left = 0.0;
  double duration_s = 0.0;
  double found_by_60_s = 0.0;
  double found_by_120_s = 0.0;
  double found_by_300_s = 0.0;
  double found_by_600_s = 0.0;
  double half_found_s = 0.0;
  double found95_s = 0.0;
  double all_found_s = 0.0;
  double overlap = 0.0;
  std::vector<double> distance_m;
  double human_share = 0.0;  ///< of the distance
  double prepare_ms = 0.0;
  double first_plan_ms = 0.0;
  double replan_p50_ms = 0.0;
  double replan_p95_ms = 0.0;
  double replan_p99_ms = 0.0;
  double first_value_s = 0.0;
  double first_bound_s = 0.0;
  double sweep_bound_s = 0.0;  ///< the independent lower bound of the instance
  int replans = 0;
  int rollouts = 0;
  int fallbacks = 0;
  double plan_change_m = 0.0;
};

[[nodiscard]] RunRecord record_of(const RunKey& key, const PlanningInstance& instance, const LoopResult& result);

/// The record as one line of JSON, without the line's end.
[[nodiscard]] std::string to_line(const RunRecord& record);

/// The record of a line; throws ConfigError if it is none.
[[nodiscard]] RunRecord from_line(std::string_view line);

/// All whole lines of a results file, none if there is no such file. A last line that was cut off is left out.
[[nodiscard]] std::vector<RunRecord> read_records(const std::filesystem::path& file);

}  // namespace tandem::bench
