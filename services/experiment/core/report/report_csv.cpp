#include "services/experiment/core/report/report_csv.hpp"

#include <cmath>
#include <set>

#include "services/common/csv.hpp"
#include "services/common/format.hpp"

namespace tandem::experiment {
namespace {

using Cells = std::vector<std::string>;

std::string number(double value) {
  return std::isfinite(value) ? formatted("%.6g", value) : "";
}

}  // namespace

std::string episodes_csv(std::span<const EpisodeLog> episodes, const Report& report) {
  std::set<std::string> fields;
  for (const EpisodeLog& episode : episodes) {
    for (const auto& [field, value] : episode.fields) fields.insert(field);
  }
  Cells head{"recording", "session"};
  head.insert(head.end(), fields.begin(), fields.end());
  head.insert(head.end(), {"outcome", "found_by"});
  for (const Measure& measure : measures()) head.emplace_back(measure.name);
  std::string csv = csv_line(head);
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    const EpisodeLog& episode = episodes[i];
    Cells cells{episode.name, episode.code};
    for (const std::string& field : fields) {
      const auto value = episode.fields.find(field);
      cells.push_back(value == episode.fields.end() ? "" : value->second);
    }
    cells.insert(cells.end(), {episode.outcome, episode.found_by});
    for (const Measure& measure : measures()) {
      const auto value = measure.of(report.episodes[i]);
      cells.push_back(value ? number(*value) : "");
    }
    csv += csv_line(cells);
  }
  return csv;
}

std::string progress_csv(const Report& report) {
  Cells head{"group", "time_s", "ongoing", "explored_robot", "explored"};
  for (const Role role : kRoles) head.emplace_back(name_of(role));
  std::string csv = csv_line(head);
  for (const GroupReport& group : report.groups) {
    for (std::size_t i = 0; i < group.explored.size(); ++i) {
      const MeanExploredAt& at = group.explored[i];
      Cells cells{group.name, number(at.time_s), std::to_string(at.ongoing), number(at.by_robot), number(at.by_all)};
      for (const std::size_t in : group.roles[i].in) cells.push_back(std::to_string(in));
      csv += csv_line(cells);
    }
  }
  return csv;
}

std::string my_pose_csv(const Report& report) {
  std::string csv = csv_line(
      {"group", "until_s", "episodes", "per_min", "deviation", "within", "threshold_s", "matching_threshold_s"});
  for (const GroupReport& group : report.groups) {
    for (const RateRow& row : group.my_pose) {
      csv += csv_line({group.name, number(row.until_s), std::to_string(row.rate.episodes), number(row.rate.per_min),
                       number(row.rate.per_min_deviation), number(row.rate.within), number(report.options.threshold_s),
                       group.matching_threshold_s > 0.0 ? number(group.matching_threshold_s) : ""});
    }
  }
  return csv;
}

std::string comparisons_csv(const Report& report) {
  std::string csv = csv_line({"measure", "anova_f", "df_between", "df_within", "anova_p", "eta_squared", "a", "b",
                              "pairs", "p", "p_holm", "hedges_g", "g_low", "g_high"});
  const auto add = [&](const Comparison& comparison) {
    const Anova& anova = comparison.anova;
    for (const PairComparison& pair : comparison.pairs) {
      csv += csv_line({comparison.measure, number(anova.f), std::to_string(anova.between), std::to_string(anova.within),
                       number(anova.p), number(anova.eta_squared), pair.a, pair.b, std::to_string(pair.pairs),
                       number(pair.p), number(pair.p_holm), number(pair.effect.g), number(pair.effect.low),
                       number(pair.effect.high)});
    }
  };
  for (const Comparison& comparison : report.measures) add(comparison);
  for (const Comparison& comparison : report.questions) add(comparison);
  return csv;
}

}  // namespace tandem::experiment
