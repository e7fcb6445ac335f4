#include "bench/planning/report/rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "bench/planning/report/campaign.hpp"
#include "services/common/format.hpp"

namespace tandem::bench {
namespace {

Verdict verdict(bool met) {
  return met ? Verdict::Met : Verdict::NotMet;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// That ours takes at most `limit` times as long as theirs, with the upper end of the interval.
TargetLine faster_than(const Results& results, int row, const std::string& theirs, const std::string& family,
                       const std::string& budget, double limit) {
  TargetLine line{
      row, formatted("%s: E[T] at most %.2f of `%s` (upper end)", family.c_str(), limit, theirs.c_str()), "", {}};
  const PairedComparison c = results.compared_with(kOurs, theirs, {family}, budget);
  if (c.instances == 0) return {row, line.target, "", Verdict::NotMeasured};
  line.measured = formatted("%.3f [%.3f, %.3f], n=%zu, %s, p=%.2g", c.ratio.value, c.ratio.low, c.ratio.high,
                            c.instances, budget.c_str(), c.p);
  line.verdict = verdict(c.ratio.high <= limit);
  return line;
}

void add_row_3_worst(const Results& results, const std::string& budget, std::vector<TargetLine>& lines) {
  for (const std::string greedy : {"greedy", "greedy15"}) {
    TargetLine line{3, formatted("never worse than `%s` on any instance of S1", greedy.c_str()), "", {}};
    const auto c = results.compared_with(kOurs, greedy, {"S1u", "S1x", "S1u4", "S1uR4"}, budget);
    line.verdict = c.instances == 0 ? Verdict::NotMeasured : verdict(c.worst <= 1.0 + 1e-9);
    if (c.instances > 0) {
      line.measured =
          formatted("worst %.3f, win/tie/loss %d/%d/%d of %zu", c.worst, c.wins, c.ties, c.losses, c.instances);
    }
    lines.push_back(line);
  }
}

void add_row_4(const Results& results, std::vector<TargetLine>& lines) {
  TargetLine line{4, "S0: mean at most 0.5 % over the optimum at 100 ms, 85 % exact, worst 3 %", "", {}};
  const auto gaps = results.exact_gaps({"S0m1", "S0m", "S0m3"}, kOurs, 100.0);
  line.verdict = Verdict::NotMeasured;
  if (!gaps.empty()) {
    const auto exact = std::ranges::count_if(gaps, [](double gap) { return gap <= 1e-6; });
    const double share = static_cast<double>(exact) / static_cast<double>(gaps.size());
    const double worst = *std::ranges::max_element(gaps);
    line.measured = formatted("mean %.2f %%, %.0f %% exact, worst %.2f %%, n=%zu proven optima", 100.0 * mean_of(gaps),
                              100.0 * share, 100.0 * worst, gaps.size());
    line.verdict = verdict(mean_of(gaps) <= 0.005 && share >= 0.85 && worst <= 0.03);
  }
  lines.push_back(line);
}

void add_row_5(const Results& results, std::vector<TargetLine>& lines) {
  for (const auto& [family, limit] :
       std::array<std::pair<const char*, double>, 4>{{{"S1u", 0.13}, {"S1x", 0.30}, {"S1u4", 0.30}, {"S1uR4", 0.30}}}) {
    TargetLine line{5, formatted("%s: certified gap at most %.0f %% at 1 s", family, 100.0 * limit), "", {}};
    const auto gaps = results.certified_gaps(family, kOurs, 1000.0);
    line.verdict = gaps.empty() ? Verdict::NotMeasured : verdict(mean_of(gaps) <= limit);
    if (!gaps.empty()) {
      line.measured = formatted("mean %.1f %%, worst %.1f %%, n=%zu", 100.0 * mean_of(gaps),
                                100.0 * *std::ranges::max_element(gaps), gaps.size());
    }
    lines.push_back(line);
  }
}

void add_row_6(const Results& results, std::vector<TargetLine>& lines) {
  struct Limit {
    const char* family;
    double budget_ms;
    double gap;
  };
  for (const Limit& limit : {Limit{"S1u", 50.0, 0.04}, Limit{"S1u", 200.0, 0.02}, Limit{"S1u", 1000.0, 0.01},
                             Limit{"S2r2", 50.0, 0.06}, Limit{"S2r2", 200.0, 0.04}, Limit{"S2r2", 1000.0, 0.02}}) {
    TargetLine line{
        6,
        formatted("%s: at %g ms within %.0f %% of the best known", limit.family, limit.budget_ms, 100.0 * limit.gap),
        "",
        {}};
    const auto gaps = results.gaps_to_best(limit.family, kOurs, limit.budget_ms);
    line.verdict = gaps.empty() ? Verdict::NotMeasured : verdict(mean_of(gaps) <= limit.gap);
    if (!gaps.empty()) line.measured = formatted("mean %.2f %%, n=%zu", 100.0 * mean_of(gaps), gaps.size());
    lines.push_back(line);
  }
}

void add_row_7(const Results& results, std::vector<TargetLine>& lines) {
  struct Limit {
    std::vector<std::string> families;
    double first_ms;
    double prepare_s;
  };
  for (const Limit& limit :
       {Limit{{"S1u", "S1x", "S1u4", "S1uR4"}, 10.0, 0.3}, Limit{{"S2r2", "S2p2", "S2r4", "S2r8"}, 60.0, 5.0},
        Limit{{"S3c2", "S3c4", "S3c8"}, 600.0, 60.0}}) {
    std::vector<double> first_ms;
    std::vector<double> prepare_s;
    for (const FirstPlanRecord& plan : results.first_plans) {
      if (plan.key.planner != kOurs || std::ranges::find(limit.families, plan.key.family) == limit.families.end())
        continue;
      first_ms.push_back(plan.first_plan_ms);
      prepare_s.push_back(1e-3 * plan.prepare_ms);
    }
    TargetLine line{7,
                    formatted("%s...: first plan p95 at most %g ms, the map ready in %g s",
                              limit.families.front().c_str(), limit.first_ms, limit.prepare_s),
                    "",
                    {}};
    line.verdict = Verdict::NotMeasured;
    if (!first_ms.empty()) {
      line.measured = formatted("%.1f ms, map p95 %.2f s, n=%zu", quantile(first_ms, 0.95), quantile(prepare_s, 0.95),
                                first_ms.size());
      line.verdict =
          verdict(quantile(first_ms, 0.95) <= limit.first_ms && quantile(prepare_s, 0.95) <= limit.prepare_s);
    }
    lines.push_back(line);
  }
}

void add_row_8_and_9(const Results& results, std::vector<TargetLine>& lines) {
  const auto evaluations = results.micro_values("evaluations", "S1u");
  TargetLine speed{8, "S1u: at least 100,000 exact evaluations of whole missions per second and core", "",
                   Verdict::NotMeasured};
  if (!evaluations.empty()) {
    speed.measured = formatted("%.0f 1/s", quantile(evaluations, 0.5));
    const auto objective = results.micro_values("objective", "S1u");
    if (!objective.empty()) speed.measured += formatted("; by SearchObjective %.0f 1/s", quantile(objective, 0.5));
    const auto rollouts = results.micro_values("rollouts", "S1u");
    if (!rollouts.empty()) speed.measured += formatted("; tandem: %.0f rollouts/s", quantile(rollouts, 0.5));
    speed.verdict = verdict(quantile(evaluations, 0.5) >= 1e5);
  }
  lines.push_back(speed);
  TargetLine reuse{8, "S1u: at least 500,000 changes of a plan judged per second and core, reusing what stays", "",
                   Verdict::NotMeasured};
  if (const auto changes = results.micro_values("changes", "S1u"); !changes.empty()) {
    reuse.measured = formatted("%.0f 1/s", quantile(changes, 0.5));
    reuse.verdict = verdict(quantile(changes, 0.5) >= 5e5);
  }
  lines.push_back(reuse);
  for (const auto& [family, limit_mb] :
       std::array<std::pair<const char*, double>, 3>{{{"S1u", 100.0}, {"S2r2", 500.0}, {"S3c2", 2000.0}}}) {
    const auto memory = results.micro_values("memory", family);
    TargetLine line{9, formatted("%s: peak memory at most %g MB", family, limit_mb), "", Verdict::NotMeasured};
    if (!memory.empty()) {
      line.measured = formatted("%.0f MB", *std::ranges::max_element(memory));
      line.verdict = verdict(*std::ranges::max_element(memory) <= limit_mb);
    }
    lines.push_back(line);
  }
  const auto growth = [&](const char* what, const std::vector<std::pair<const char*, double>>& sizes) {
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [family, size] : sizes) {
      std::vector<double> first_ms;
      for (const FirstPlanRecord& plan : results.first_plans) {
        if (plan.key.planner == kOurs && plan.key.family == family) first_ms.push_back(plan.first_plan_ms);
      }
      if (first_ms.empty()) continue;
      x.push_back(size);
      y.push_back(quantile(first_ms, 0.5));
    }
    TargetLine line{9, formatted("time of the first plan grows with exponent at most 1.2 in %s", what), "",
                    Verdict::NotMeasured};
    if (x.size() >= 2) {
      line.measured = formatted("%.2f over %zu sizes", growth_exponent(x, y), x.size());
      line.verdict = verdict(growth_exponent(x, y) <= 1.2);
    }
    lines.push_back(line);
  };
  growth("area", {{"S1u", 750.0}, {"S2r2", 10000.0}, {"S3c2", 100000.0}});
  growth("agents", {{"S2r2", 2.0}, {"S2r4", 4.0}, {"S2r8", 8.0}});
}

void add_row_10_and_11(const Results& results, const std::string& budget, std::vector<TargetLine>& lines) {
  const auto ours = results.figure("S1u", kOurs, budget, &RunRecord::overlap);
  const auto papers = results.figure("S1u", kPaper, budget, &RunRecord::overlap);
  TargetLine overlap{10, "S1u: overlap at most half of the paper's", "", Verdict::NotMeasured};
  if (!ours.empty() && !papers.empty()) {
    overlap.measured = formatted("%.2f against %.2f", mean_of(ours), mean_of(papers));
    overlap.verdict = verdict(mean_of(ours) <= 0.5 * mean_of(papers));
  }
  lines.push_back(overlap);
  const std::vector<std::string> humans{"S5obedient", "S5late", "S5own", "S5random", "S5stubborn", "S5announces"};
  const auto add_human = [&](const char* other, const char* target, double PairedComparison::*figure, double limit) {
    TargetLine line{10, target, "", Verdict::NotMeasured};
    const PairedComparison c = results.compared_with(
        kOurs, other, humans, results.budgets_of("S5own").empty() ? "" : results.budgets_of("S5own").front());
    if (c.instances > 0) {
      line.measured = formatted("%.3f [%.3f, %.3f], worst %.3f, n=%zu", c.ratio.value, c.ratio.low, c.ratio.high,
                                c.worst, c.instances);
      line.verdict = verdict((figure == nullptr ? c.ratio.high : c.*figure) <= limit);
    }
    lines.push_back(line);
  };
  add_human("tandem@clairvoyant", "S5: E[T] at most 1.15 of a clairvoyant robot's (upper end)", nullptr, 1.15);
  add_human("tandem@alone", "S5: never worse than a robot that ignores the person", &PairedComparison::worst, 1.0);
  const auto reproducible = results.micro_values("reproducible", "S1u");
  TargetLine equal{11, "equal seed and rollouts, equal searches, alone and two at a time", "", Verdict::NotMeasured};
  if (!reproducible.empty()) {
    equal.measured = *std::ranges::min_element(reproducible) == 1.0 ? "bit-identical" : "they differ";
    equal.verdict = verdict(*std::ranges::min_element(reproducible) == 1.0);
  }
  lines.push_back(equal);
  const auto p95_ms = results.figure("S1u", kOurs, budget, &RunRecord::replan_p95_ms);
  TargetLine replan{11, "S1u: a replan computes for at most 200 ms (p95; with transport 250 ms)", "",
                    Verdict::NotMeasured};
  if (!p95_ms.empty()) {
    replan.measured = formatted("%.1f ms at a budget of %s", *std::ranges::max_element(p95_ms), budget.c_str());
    replan.verdict = verdict(*std::ranges::max_element(p95_ms) <= 210.0);
  }
  lines.push_back(replan);
}

void add_row_12(const Results& results, std::vector<TargetLine>& lines) {
  TargetLine line{12, "S7: exact on at least 95 % of worlds of up to 8 sources at 200 ms, worst gap 2 %", "",
                  Verdict::NotMeasured};
  std::vector<double> gaps;
  for (const TaskRecord& task : results.tasks) {
    if (task.optimum_proven && task.key.most_sources <= 8) gaps.push_back(task.optimum_gap);
  }
  if (!gaps.empty()) {
    const auto exact = std::ranges::count_if(gaps, [](double gap) { return gap <= 1e-6; });
    const double share = static_cast<double>(exact) / static_cast<double>(gaps.size());
    const double worst = *std::ranges::max_element(gaps);
    line.measured = formatted("%.0f %% exact, worst gap %.2f %%, n=%zu proven optima of %zu worlds", 100.0 * share,
                              100.0 * worst, gaps.size(), results.tasks.size());
    line.verdict = verdict(share >= 0.95 && worst <= 0.02);
  }
  lines.push_back(line);
}

}  // namespace

std::vector<TargetLine> target_lines(const Results& results, const std::string& budget) {
  std::vector<TargetLine> lines;
  for (const char* family : {"S1u", "S1x", "S1u4"})
    lines.push_back(faster_than(results, 1, kPaper, family, budget, 0.80));
  for (const char* family : {"S1u", "S1x", "S1u4", "S1uR4"}) {
    lines.push_back(faster_than(results, 2, kPaperCorrected, family, budget, 0.84));
  }
  lines.push_back(faster_than(results, 3, kTunedGreedy, "S1u", budget, 0.96));
  lines.push_back(faster_than(results, 3, "greedy", "S1u", budget, 0.92));
  lines.push_back(faster_than(results, 3, "lawnmower", "S1u", budget, 0.80));
  add_row_3_worst(results, budget, lines);
  add_row_4(results, lines);
  add_row_5(results, lines);
  add_row_6(results, lines);
  add_row_7(results, lines);
  add_row_8_and_9(results, lines);
  add_row_10_and_11(results, budget, lines);
  add_row_12(results, lines);
  return lines;
}

}  // namespace tandem::bench
