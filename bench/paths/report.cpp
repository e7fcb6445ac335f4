#include "bench/paths/report.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "bench/planning/report/plot.hpp"
#include "bench/planning/statistics/statistics.hpp"
#include "services/common/format.hpp"

namespace tandem::bench {
namespace {

bool is_ours(const PathRecord& record) {
  return record.planner.starts_with("ours");
}

/// What is known of one planner in one family, perhaps at one budget.
struct Figures {
  int asked = 0;
  std::vector<double> ratios;  ///< of the ways found, length to the shortest
  double time_ms = 0.0;        ///< mean
  double prepare_ms = 0.0;     ///< mean
};

Figures figures_of(const std::vector<PathRecord>& records) {
  Figures figures;
  for (const PathRecord& record : records) {
    ++figures.asked;
    figures.time_ms += record.budget_ms / static_cast<double>(records.size());
    figures.prepare_ms += record.prepare_ms / static_cast<double>(records.size());
    if (record.length_m > 0.0 && record.shortest_m > 0.0) figures.ratios.push_back(record.length_m / record.shortest_m);
  }
  return figures;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// "1.023", or "8/10, 1.16" where some have no way yet.
std::string cell(const Figures& figures) {
  if (figures.ratios.empty()) return formatted("0/%d", figures.asked);
  std::string ratio = formatted("%.3f", mean(figures.ratios));
  if (static_cast<int>(figures.ratios.size()) == figures.asked) return ratio;
  return formatted("%zu/%d, ", figures.ratios.size(), figures.asked) + ratio;
}

std::vector<PathRecord> those(std::span<const PathRecord> records, const auto& condition) {
  std::vector<PathRecord> chosen;
  std::ranges::copy_if(records, std::back_inserter(chosen), condition);
  return chosen;
}

/// In the order in which they were first met.
std::vector<std::string> names_of(std::span<const PathRecord> records, std::string PathRecord::*field) {
  std::vector<std::string> names;
  for (const PathRecord& record : records) {
    if (std::ranges::find(names, record.*field) == names.end()) names.push_back(record.*field);
  }
  return names;
}

std::string own_table(std::span<const PathRecord> ours) {
  std::string text =
      "| way | ready for the map, once, ms | found in ms | length / shortest | worst |\n|---|---|---|---|---|\n";
  for (const std::string& planner : names_of(ours, &PathRecord::planner)) {
    const Figures figures = figures_of(those(ours, [&](const PathRecord& r) { return r.planner == planner; }));
    const double worst = figures.ratios.empty() ? NAN : *std::ranges::max_element(figures.ratios);
    text += formatted("| %s | %.1f | %.3f | %s | %.3f |\n", planner.c_str(), figures.prepare_ms, figures.time_ms,
                      cell(figures).c_str(), worst);
  }
  return text;
}

std::string peer_table(std::span<const PathRecord> peers, const std::set<double>& budgets_ms) {
  std::string text = "| planner |";
  std::string line = "|---|";
  for (const double budget_ms : budgets_ms) {
    text += formatted(" %g ms |", budget_ms);
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const std::string& planner : names_of(peers, &PathRecord::planner)) {
    text += "| " + planner + " |";
    for (const double budget_ms : budgets_ms) {
      text += " " +
              cell(figures_of(those(
                  peers, [&](const PathRecord& r) { return r.planner == planner && r.budget_ms == budget_ms; }))) +
              " |";
    }
    text += "\n";
  }
  return text;
}

/// Mean ratio over processor time, only where all have a way: else those that are easy to find would stand alone.
std::string picture_of(std::span<const PathRecord> records, const std::set<double>& budgets_ms,
                       const std::string& family) {
  std::vector<Curve> curves;
  for (const std::string& planner : names_of(records, &PathRecord::planner)) {
    const auto all = those(records, [&](const PathRecord& r) { return r.planner == planner; });
    Curve curve{planner, {}};
    if (is_ours(all.front())) {
      const Figures figures = figures_of(all);
      if (static_cast<int>(figures.ratios.size()) == figures.asked)
        curve.points = {{std::max(figures.time_ms, 0.01), mean(figures.ratios)}};
    } else {
      for (const double budget_ms : budgets_ms) {
        const Figures figures = figures_of(those(all, [&](const PathRecord& r) { return r.budget_ms == budget_ms; }));
        if (static_cast<int>(figures.ratios.size()) == figures.asked)
          curve.points.emplace_back(budget_ms, mean(figures.ratios));
      }
    }
    if (!curve.points.empty()) curves.push_back(curve);
  }
  return plotted(curves, {.title = family + ": ways against the shortest",
                          .x_label = "processor time [ms]",
                          .y_label = "length / shortest",
                          .x_logarithmic = true});
}

}  // namespace

std::map<std::string, std::string> paths_report(std::span<const PathRecord> records, const ReportHead& head) {
  std::map<std::string, std::string> files;
  std::string text = "# How good the ways are\n\n" + head.date + ", commit " + head.commit + ", " + head.machine +
                     ".\n\n    " + head.command +
                     "\n\n"
                     "A way leads from where the robot of a planning instance starts to a place drawn at random, at "
                     "least half of the map's width away; one for each seed. The shortest way in any direction is "
                     "computed exactly, over the corners of the room that the robot's middle has (body radius less "
                     "0.02 m, on the map's cells). Lengths are shown as mean ratio to it, `n/m` where only n of m have "
                     "a way. Times are processor time.\n\n"
                     "Ours with clearance are the ways that robots take: a metre nearer to walls than preferred costs "
                     "up to three, so they are longer on purpose. Over lookouts: from the lookout nearest to the start "
                     "to that nearest to the goal, from one to another near one, as the legs of a plan join; all legs "
                     "were found before, in the time that it takes to make ready for the map (with views).\n";
  for (const std::string& family : names_of(records, &PathRecord::family)) {
    const auto all = those(records, [&](const PathRecord& r) { return r.family == family; });
    const auto peers = those(all, [](const PathRecord& r) { return !is_ours(r); });
    std::set<double> budgets_ms;
    for (const PathRecord& record : peers) budgets_ms.insert(record.budget_ms);
    text += "\n## " + family + "\n\n" + own_table(those(all, is_ours));
    if (peers.empty()) {
      text += "\nOMPL is not unpacked here (bench/paths/README.md): its part was not run.\n";
    } else {
      text += "\n" + peer_table(peers, budgets_ms) + "\n![" + family + "](" + family + ".svg)\n";
      files[family + ".svg"] = picture_of(all, budgets_ms, family);
    }
  }
  files["REPORT.md"] = text;
  return files;
}

}  // namespace tandem::bench
