#include "bench/planning/scores/frozen_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bench/planning/statistics/statistics.hpp"
#include "services/common/config.hpp"
#include "services/common/format.hpp"
#include "services/planner/remote/named_planner.hpp"

namespace tandem::bench {
namespace {

constexpr double kOtherProgram_ms = 100.0;
constexpr int kSlower =
    10;  ///< so many times longer rollouts take where somebody detects at a rate, not at first sight

/// Rollouts that a planner makes in 100 ms for its first plan of S1u (first_plans.jsonl of the whole campaign); those
/// that are not named here make a plan at once.
int rollouts_at_first_sight(const std::string& planner) {
  static const std::map<std::string, int, std::less<>> kRollouts{{"tandem", 900},
                                                                 {"paper", 12'000},
                                                                 {"paper_printed", 12'000},
                                                                 {"paper_travel", 12'000},
                                                                 {"paper_corrected", 8'000},
                                                                 {"dec_mcts", 12},
                                                                 {"sequential", 25},
                                                                 {"single", 25}};
  const auto found = kRollouts.find(planner.substr(0, planner.find(':')));
  return found == kRollouts.end() ? 0 : found->second;
}

/// What the table shows of a planner.
struct Row {
  std::string planner;
  std::map<std::string, double> search_s;  ///< by scenario
  double ratio = std::numeric_limits<double>::infinity();
};

double ratio_of(const Row& row, const Row* baseline) {
  std::vector<double> ratios;
  for (const auto& [scenario, search_s] : row.search_s) {
    if (baseline != nullptr && baseline->search_s.contains(scenario)) {
      ratios.push_back(search_s / baseline->search_s.at(scenario));
    }
  }
  return ratios.empty() ? std::numeric_limits<double>::infinity() : geometric_mean(ratios);
}

}  // namespace

std::vector<std::string> frozen_scenarios(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  if (names.empty()) throw ConfigError(folder.string() + ": there are no scenarios");
  std::ranges::sort(names);
  return names;
}

FrozenScoreRequest frozen_score_request(const std::string& scenario, const std::string& planner) {
  const auto underscore = scenario.rfind('_');
  if (underscore == std::string::npos) throw ConfigError(scenario + ": a frozen scenario is named FAMILY_SEED.json");
  const auto seeds = parse_seeds(scenario.substr(underscore + 1));
  const PlanningInstance instance = instance_of(scenario.substr(0, underscore), seeds.front());
  const bool first_sight = std::ranges::all_of(
      instance.searchers, [](const Searcher& searcher) { return std::isinf(searcher.detection_rate_per_s); });
  const int at_first_sight = rollouts_at_first_sight(planner);
  PlanningBudget budget{kOtherProgram_ms};
  if (!is_other_program(planner)) budget.rollouts = first_sight ? at_first_sight : at_first_sight / kSlower;
  return {{scenario, planner}, {{instance.family, instance.seed, planner, budget_label(budget), 1}, budget}};
}

FrozenScore made_frozen_score(const FrozenScoreRequest& request) {
  const RunRecord run = made_run(request.run);
  FrozenScore score;
  score.key = request.key;
  score.rollouts = request.run.budget.rollouts.value_or(0);
  score.plan_s = run.first_value_s;
  score.plan_bound_s = run.first_bound_s;
  score.search_s = run.expected_time_s;
  score.search_bound_s = run.sweep_bound_s;
  score.search_left = run.probability_left;
  score.plans = run.replans;
  return score;
}

std::string score_table(std::span<const FrozenScore> scores, const std::string& baseline) {
  std::vector<Row> rows;
  std::map<std::string, double> bounds_s;  // by scenario
  for (const FrozenScore& score : scores) {
    auto row = std::ranges::find(rows, score.key.planner, &Row::planner);
    if (row == rows.end()) row = rows.insert(rows.end(), Row{score.key.planner, {}});
    row->search_s[score.key.scenario] = score.search_s;
    bounds_s[score.key.scenario] = score.search_bound_s;
  }
  const auto base = std::ranges::find(rows, baseline, &Row::planner);
  const Row* compared_to = base == rows.end() ? nullptr : &*base;
  std::vector<double> ratios;
  for (const Row& row : rows) ratios.push_back(ratio_of(row, compared_to));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].ratio = ratios[i];
  std::ranges::stable_sort(rows, {}, &Row::ratio);
  std::string table = formatted("%-32s", "E[T] of the search, s");
  for (const auto& [scenario, bound_s] : bounds_s) table += formatted(" %9s", scenario.c_str());
  table += "   / " + baseline + "\n";
  for (const Row& row : rows) {
    table += formatted("%-32s", row.planner.c_str());
    for (const auto& [scenario, bound_s] : bounds_s) {
      const auto search = row.search_s.find(scenario);
      table += search == row.search_s.end() ? formatted(" %9s", "-") : formatted(" %9.2f", search->second);
    }
    table += formatted("   %.3f\n", row.ratio);
  }
  table += formatted("%-32s", "nobody can beat");
  for (const auto& [scenario, bound_s] : bounds_s) table += formatted(" %9.2f", bound_s);
  return table + "\n";
}

}  // namespace tandem::bench
