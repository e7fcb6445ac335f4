#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/planning/loop/first_plan.hpp"
#include "bench/planning/loop/run_plan.hpp"
#include "bench/planning/micro/micro.hpp"
#include "bench/planning/srs_worlds/task_run.hpp"

namespace tandem::bench {

/// Names that the report's rows know.
inline constexpr const char* kOurs = "tandem";
inline constexpr const char* kPaper = "paper";
inline constexpr const char* kPaperCorrected = "paper_corrected";
inline constexpr const char* kTunedGreedy = "greedy15";

struct CampaignOptions {
  bool quick = false;            ///< few instances and small budgets
  std::vector<int> rows = {};    ///< only what these rows of the report need; empty: all
  std::uint64_t first_seed = 1;  ///< of the instances; 1000001 for those that nothing was tuned on
  /// Options of tandem that switch a part off: refinement, tree, all seeds but one, the plan in execution as a seed.
  std::vector<std::string> ablations = {"moves=0", "tree_every=0", "seeds=0", "warm_start=0"};
};

/// All that is to be run for a report.
struct Campaign {
  std::vector<RunRequest> runs;
  std::vector<FirstPlanRequest> first_plans;
  std::vector<MicroRequest> micro;
  std::vector<TaskRequest> tasks;
};

[[nodiscard]] Campaign campaign_of(const CampaignOptions& options);

}  // namespace tandem::bench
