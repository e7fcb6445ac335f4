#include "bench/planning/report/results.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace tandem::bench {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& item) {
  return std::ranges::find(list, item) != list.end();
}

void add_once(std::vector<std::string>& list, const std::string& item) {
  if (!contains(list, item)) list.push_back(item);
}

}  // namespace

std::optional<double> value_after(const FirstPlanRecord& record, double budget_ms, const std::vector<double>& values) {
  std::optional<double> value;
  for (std::size_t i = 0; i < record.budgets_ms.size(); ++i) {
    if (record.budgets_ms[i] <= budget_ms) value = values[i];
  }
  return value;
}

PairedComparison Results::compared_with(const std::string& ours, const std::string& theirs,
                                        const std::vector<std::string>& families, const std::string& budget) const {
  std::map<std::pair<std::string, std::uint64_t>, std::pair<double, double>> pairs;
  for (const RunRecord& run : runs) {
    if (run.key.budget != budget || !contains(families, run.key.family)) continue;
    auto& pair = pairs[{run.key.family, run.key.seed}];
    if (run.key.planner == ours) pair.first = run.expected_time_s;
    if (run.key.planner == theirs) pair.second = run.expected_time_s;
  }
  std::vector<double> our_times_s;
  std::vector<double> their_times_s;
  for (const auto& [instance, times_s] : pairs) {
    if (times_s.first <= 0.0 || times_s.second <= 0.0) continue;
    our_times_s.push_back(times_s.first);
    their_times_s.push_back(times_s.second);
  }
  return compared(our_times_s, their_times_s, Rng{1});
}

std::vector<std::string> Results::budgets_of(const std::string& family) const {
  std::vector<std::string> budgets;
  for (const RunRecord& run : runs) {
    if (run.key.family == family) add_once(budgets, run.key.budget);
  }
  std::ranges::sort(budgets, {}, [](const std::string& budget) { return std::strtod(budget.c_str(), nullptr); });
  return budgets;
}

std::vector<std::string> Results::families() const {
  std::vector<std::string> list;
  for (const RunRecord& run : runs) add_once(list, run.key.family);
  return list;
}

std::vector<std::string> Results::planners_in(const std::string& family, const std::string& budget) const {
  std::vector<std::string> list;
  for (const RunRecord& run : runs) {
    if (run.key.family == family && run.key.budget == budget) add_once(list, run.key.planner);
  }
  return list;
}

std::vector<double> Results::figure(const std::string& family, const std::string& planner, const std::string& budget,
                                    double RunRecord::*which) const {
  std::vector<double> values;
  for (const RunRecord& run : runs) {
    if (run.key.family == family && run.key.planner == planner && run.key.budget == budget) {
      values.push_back(run.*which);
    }
  }
  return values;
}

std::map<std::uint64_t, double> Results::best_known(const std::string& family) const {
  std::map<std::uint64_t, double> best;
  for (const FirstPlanRecord& plan : first_plans) {
    if (plan.key.family != family) continue;
    for (const double value : plan.values_s) {
      const auto entry = best.try_emplace(plan.key.seed, value).first;
      entry->second = std::min(entry->second, value);
    }
  }
  return best;
}

std::vector<double> Results::gaps_to_best(const std::string& family, const std::string& planner,
                                          double budget_ms) const {
  const auto best = best_known(family);
  std::vector<double> gaps;
  for (const FirstPlanRecord& plan : first_plans) {
    if (plan.key.family != family || plan.key.planner != planner) continue;
    if (const auto value = value_after(plan, budget_ms, plan.values_s))
      gaps.push_back(*value / best.at(plan.key.seed) - 1.0);
  }
  return gaps;
}

std::vector<double> Results::certified_gaps(const std::string& family, const std::string& planner,
                                            double budget_ms) const {
  std::vector<double> gaps;
  for (const FirstPlanRecord& plan : first_plans) {
    if (plan.key.family != family || plan.key.planner != planner) continue;
    const auto value = value_after(plan, budget_ms, plan.values_s);
    const auto bound = value_after(plan, budget_ms, plan.bounds_s);
    if (value && bound && *bound > 0.0) gaps.push_back(*value / *bound - 1.0);
  }
  return gaps;
}

std::vector<double> Results::exact_gaps(const std::vector<std::string>& families, const std::string& planner,
                                        double budget_ms) const {
  std::map<std::pair<std::string, std::uint64_t>, double> optimum_s;
  for (const FirstPlanRecord& plan : first_plans) {
    if (plan.exact_proven) optimum_s[{plan.key.family, plan.key.seed}] = plan.exact_s;
  }
  std::vector<double> gaps;
  for (const FirstPlanRecord& plan : first_plans) {
    if (!contains(families, plan.key.family) || plan.key.planner != planner) continue;
    const auto optimum = optimum_s.find({plan.key.family, plan.key.seed});
    const auto value = value_after(plan, budget_ms, plan.values_s);
    if (optimum != optimum_s.end() && value) gaps.push_back(*value / optimum->second - 1.0);
  }
  return gaps;
}

std::vector<double> Results::micro_values(const std::string& measure, const std::string& family) const {
  std::vector<double> values;
  for (const MicroRecord& record : micro) {
    if (record.key.measure == measure && record.key.family == family) values.push_back(record.value);
  }
  return values;
}

}  // namespace tandem::bench
