#include "bench/planning/report/report.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "bench/planning/report/campaign.hpp"
#include "bench/planning/report/plot.hpp"
#include "bench/planning/report/rows.hpp"
#include "services/common/format.hpp"
#include "services/experiment/core/report/statistics.hpp"

namespace tandem::bench {
namespace {

double mean_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Met:
      return "met";
    case Verdict::NotMet:
      return "**not met**";
    case Verdict::NotMeasured:
      return "not measured";
  }
  return "";
}

/// The budget that targets are judged at: 200 ms if it was run, else the greatest.
std::string judged_budget(const Results& results) {
  const auto budgets = results.budgets_of("S1u");
  if (std::ranges::find(budgets, "200ms") != budgets.end()) return "200ms";
  return budgets.empty() ? "200ms" : budgets.back();
}

bool is_ablation(const std::string& planner) {
  return planner.starts_with(std::string(kOurs) + ":");
}

/// All planners on one family at one budget; the p values are Holm's over the table.
std::string family_table(const Results& results, const std::string& family, const std::string& budget) {
  std::string table =
      "\n### " + family + " at " + budget +
      "\n\n| planner | n | E[T] s | T95 s | by 60 s | by 120 s | overlap | human share | replan p95 ms | "
      "first ms | fallbacks | E[T] of `tandem` / this, 95 % | win/tie/loss | worst | p (Holm) |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::vector<std::string> planners = results.planners_in(family, budget);
  std::erase_if(planners, is_ablation);
  std::vector<PairedComparison> comparisons;
  std::vector<double> p_values;
  for (const auto& planner : planners) {
    comparisons.push_back(results.compared_with(kOurs, planner, {family}, budget));
    if (planner != kOurs) p_values.push_back(comparisons.back().p);
  }
  const std::vector<double> adjusted = experiment::holm_adjusted(p_values);
  std::size_t next_p = 0;
  for (std::size_t i = 0; i < planners.size(); ++i) {
    const auto mean = [&](double RunRecord::*which) {
      return mean_of(results.figure(family, planners[i], budget, which));
    };
    double fallbacks = 0.0;
    for (const RunRecord& run : results.runs) {
      if (run.key.family == family && run.key.planner == planners[i] && run.key.budget == budget)
        fallbacks += run.fallbacks;
    }
    const auto n = results.figure(family, planners[i], budget, &RunRecord::expected_time_s).size();
    table += formatted("| `%s` | %zu | %.2f | %.0f | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f | %.1f |",
                       planners[i].c_str(), n, mean(&RunRecord::expected_time_s), mean(&RunRecord::found95_s),
                       mean(&RunRecord::found_by_60_s), mean(&RunRecord::found_by_120_s), mean(&RunRecord::overlap),
                       mean(&RunRecord::human_share), mean(&RunRecord::replan_p95_ms), mean(&RunRecord::first_plan_ms),
                       fallbacks / static_cast<double>(std::max<std::size_t>(n, 1)));
    if (planners[i] == kOurs) {
      table += " | | | |\n";
      continue;
    }
    const PairedComparison& c = comparisons[i];
    table += formatted(" %.3f [%.3f, %.3f] | %d/%d/%d | %.3f | %.2g |\n", c.ratio.value, c.ratio.low, c.ratio.high,
                       c.wins, c.ties, c.losses, c.worst, adjusted[next_p++]);
  }
  return table;
}

std::string ablation_table(const Results& results, const std::string& budget) {
  std::string table =
      "\n## What the gain comes from\n\nE[T] with parts switched off, as a ratio to `tandem` whole.\n\n"
      "| variant | family | n | E[T] / whole, 95 % | worst |\n|---|---|---|---|---|\n";
  bool any = false;
  for (const auto& family : results.families()) {
    for (const auto& planner : results.planners_in(family, budget)) {
      if (!is_ablation(planner)) continue;
      const PairedComparison c = results.compared_with(planner, kOurs, {family}, budget);
      table += formatted("| `%s` | %s | %zu | %.3f [%.3f, %.3f] | %.3f |\n", planner.c_str(), family.c_str(),
                         c.instances, c.ratio.value, c.ratio.low, c.ratio.high, c.worst);
      any = true;
    }
  }
  return any ? table : "";
}

/// How far plans are above the best known, over the processor time they took, mean over the instances of a family.
std::vector<Curve> anytime_curves(const Results& results, const std::string& family) {
  std::vector<std::string> planners;
  std::set<double> budgets_ms;
  for (const FirstPlanRecord& plan : results.first_plans) {
    if (plan.key.family != family) continue;
    if (std::ranges::find(planners, plan.key.planner) == planners.end()) planners.push_back(plan.key.planner);
    budgets_ms.insert(plan.budgets_ms.begin(), plan.budgets_ms.end());
  }
  std::vector<Curve> curves;
  for (const auto& planner : planners) {
    Curve curve{planner, {}};
    for (const double budget_ms : budgets_ms) {
      const auto gaps = results.gaps_to_best(family, planner, budget_ms);
      if (!gaps.empty()) curve.points.emplace_back(budget_ms, 100.0 * mean_of(gaps));
    }
    curves.push_back(curve);
  }
  return curves;
}

std::string first_plan_table(const Results& results) {
  std::string table =
      "\n## First plans\n\n| family | planner | n | map ready s | first plan ms | first E[T] s | best known s | "
      "certified bound s | independent bound s |\n|---|---|---|---|---|---|---|---|---|\n";
  std::map<std::pair<std::string, std::string>, std::vector<const FirstPlanRecord*>> by_case;
  for (const FirstPlanRecord& plan : results.first_plans) by_case[{plan.key.family, plan.key.planner}].push_back(&plan);
  for (const auto& [which, plans] : by_case) {
    const auto best = results.best_known(which.first);
    std::array<double, 6> sums{};
    for (const FirstPlanRecord* plan : plans) {
      sums[0] += 1e-3 * plan->prepare_ms;
      sums[1] += plan->first_plan_ms;
      sums[2] += plan->first_value_s;
      sums[3] += best.at(plan->key.seed);
      sums[4] += plan->bounds_s.back();
      sums[5] += plan->sweep_bound_s;
    }
    for (double& sum : sums) sum /= static_cast<double>(plans.size());
    table += formatted("| %s | `%s` | %zu | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f |\n", which.first.c_str(),
                       which.second.c_str(), plans.size(), sums[0], sums[1], sums[2], sums[3], sums[4], sums[5]);
  }
  return table;
}

/// Certified bounds that a plan beats, which must not be.
std::string bound_check(const Results& results) {
  int checked = 0;
  int violated = 0;
  for (const FirstPlanRecord& plan : results.first_plans) {
    const double best_s = results.best_known(plan.key.family).at(plan.key.seed);
    for (const double bound_s : plan.bounds_s) {
      if (bound_s <= 0.0) continue;
      ++checked;
      violated += bound_s > best_s + 1e-6 ? 1 : 0;
    }
    violated += plan.sweep_bound_s > best_s + 1e-6 ? 1 : 0;
  }
  return formatted("\nOf %d certified bounds and the independent ones, %d lie above the value of a known plan.\n",
                   checked, violated);
}

std::string csv(const Results& results) {
  std::string text = "family,seed,planner,budget,planner_seed,expected_time_s,found95_s,overlap,probability_left\n";
  for (const RunRecord& run : results.runs) {
    text += formatted("%s,%llu,\"%s\",%s,%llu,%.6f,%.1f,%.4f,%.3g\n", run.key.family.c_str(),
                      static_cast<unsigned long long>(run.key.seed), run.key.planner.c_str(), run.key.budget.c_str(),
                      static_cast<unsigned long long>(run.key.planner_seed), run.expected_time_s, run.found95_s,
                      run.overlap, run.probability_left);
  }
  return text;
}

}  // namespace

std::string target_table(const Results& results) {
  std::string table = "| row | target | measured | |\n|---|---|---|---|\n";
  for (const TargetLine& line : target_lines(results, judged_budget(results))) {
    table += formatted("| %d | %s | %s | %s |\n", line.row, line.target.c_str(), line.measured.c_str(),
                       word_of(line.verdict));
  }
  return table;
}

std::map<std::string, std::string> report_files(const Results& results, const ReportHead& head) {
  std::map<std::string, std::string> files;
  std::string text =
      "# How good the planners are\n\n" + head.date + ", commit " + head.commit + ", " + head.machine + ".\n\n    " +
      head.command +
      "\n\nE[T] is exact, over whole executed searches; budgets are processor time of one core for each plan. "
      "Ratios are geometric means over the same instances with BCa bootstrap intervals of 95 %. Families: "
      "`tandem-bench-planning families`.\n\n## Targets\n\n" +
      target_table(results);
  text += "\n## Searches\n";
  for (const auto& family : results.families()) {
    for (const auto& budget : results.budgets_of(family)) text += family_table(results, family, budget);
  }
  text += ablation_table(results, judged_budget(results));
  text += first_plan_table(results) + bound_check(results);
  std::set<std::string> plan_families;
  for (const FirstPlanRecord& plan : results.first_plans) plan_families.insert(plan.key.family);
  for (const auto& family : plan_families) {
    const auto curves = anytime_curves(results, family);
    if (curves.empty() || curves.front().points.size() < 2) continue;
    const std::string name = "anytime_" + family + ".svg";
    files[name] = plotted(curves, {family + ": first plans over the time they took", "processor time [ms]",
                                   "above the best known [%]", true, false});
    text += "\n![" + family + "](" + name + ")\n";
  }
  files["REPORT.md"] = text;
  files["runs.csv"] = csv(results);
  return files;
}

}  // namespace tandem::bench
