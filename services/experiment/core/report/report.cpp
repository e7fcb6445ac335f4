#include "services/experiment/core/report/report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace tandem::experiment {
namespace {

constexpr std::array kBeginnings_s{60.0, 90.0, 120.0, std::numeric_limits<double>::infinity()};

using Metrics = const EpisodeMetrics&;
using Value = std::optional<double>;

Value mean_if_any(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional{mean_of(values)};
}

Value if_known(const Distances& distances, double value) {
  return distances.known_s > 0.0 ? std::optional{value} : std::nullopt;
}

constexpr std::array kMeasures{
    Measure{"found", "", "Found", [](Metrics m) -> Value { return m.found ? 1.0 : 0.0; }},
    Measure{"time_s", "s", "Duration", [](Metrics m) -> Value { return m.time_s; }},
    Measure{"explored", "", "Explored at the end", [](Metrics m) -> Value { return m.explored; }},
    Measure{"explored_robot", "", "by the robot", [](Metrics m) -> Value { return m.explored_robot; }},
    Measure{"explored_human", "", "by the person", [](Metrics m) -> Value { return m.explored_human; }},
    Measure{"plans", "", "Plans", [](Metrics m) -> Value { return static_cast<double>(m.plans); }},
    Measure{"rejected", "", "Plans rejected", [](Metrics m) -> Value { return static_cast<double>(m.rejected); }},
    Measure{"answer_s", "s", "From Replan to a plan", [](Metrics m) -> Value { return mean_if_any(m.answer_s); }},
    Measure{"my_pose_per_min", "1/min", "My pose", [](Metrics m) -> Value { return m.my_pose_per_min; }},
    Measure{"longest_silence_s", "s", "Longest without My pose",
            [](Metrics m) -> Value { return m.longest_silence_s; }},
    Measure{"pose_age_at_plan_s", "s", "Age of My pose at a plan",
            [](Metrics m) -> Value { return mean_if_any(m.pose_age_at_plan_s); }},
    Measure{"robot_idle", "", "Robot idle", [](Metrics m) -> Value { return m.robot_idle; }},
    Measure{"human_idle", "", "Person idle", [](Metrics m) -> Value { return m.human_idle; }},
    Measure{"both_active", "", "Both active", [](Metrics m) -> Value { return m.both_active; }},
    Measure{"robot_distance_m", "m", "Robot's way", [](Metrics m) -> Value { return m.robot.distance_m; }},
    Measure{"human_distance_m", "m", "Person's way", [](Metrics m) -> Value { return m.human.distance_m; }},
    Measure{"robot_mean_mps", "m/s", "Robot's mean speed", [](Metrics m) -> Value { return m.robot.mean_mps; }},
    Measure{"robot_max_mps", "m/s", "Robot's highest speed", [](Metrics m) -> Value { return m.robot.max_mps; }},
    Measure{"robot_turning_rad", "rad", "Robot's turning", [](Metrics m) -> Value { return m.robot.turning_rad; }},
    Measure{"collisions", "", "Collisions", [](Metrics m) -> Value { return static_cast<double>(m.collisions); }},
    Measure{"stops", "", "Stops", [](Metrics m) -> Value { return m.stop_count; }},
    Measure{"slowed", "", "Slowed down", [](Metrics m) -> Value { return m.slowed; }},
    Measure{"teammate_nearest_m", "m", "Nearest to the teammate",
            [](Metrics m) -> Value { return if_known(m.teammate, m.teammate.nearest_m); }},
    Measure{"teammate_mean_m", "m", "Mean distance to the teammate",
            [](Metrics m) -> Value { return if_known(m.teammate, m.teammate.mean_m); }},
    Measure{"teammate_intimate", "", "Teammate within 0.45 m",
            [](Metrics m) -> Value { return if_known(m.teammate, m.teammate.intimate); }},
    Measure{"teammate_personal", "", "Teammate at 0.45-1.2 m",
            [](Metrics m) -> Value { return if_known(m.teammate, m.teammate.personal); }},
    Measure{"teammate_social", "", "Teammate at 1.2-3.6 m",
            [](Metrics m) -> Value { return if_known(m.teammate, m.teammate.social); }},
    Measure{"passers_by_nearest_m", "m", "Nearest to passers-by",
            [](Metrics m) -> Value { return if_known(m.passers_by, m.passers_by.nearest_m); }},
    Measure{"passers_by_intimate", "", "Passers-by within 0.45 m",
            [](Metrics m) -> Value { return if_known(m.passers_by, m.passers_by.intimate); }},
    Measure{"link_up", "", "Link up", [](Metrics m) -> Value { return m.link_up; }},
};

std::vector<const EpisodeLog*> chosen(std::span<const EpisodeLog> episodes, const std::vector<std::size_t>& indices) {
  std::vector<const EpisodeLog*> logs;
  for (const std::size_t index : indices) logs.push_back(&episodes[index]);
  return logs;
}

std::vector<GroupReport> groups_of(std::span<const EpisodeLog> episodes, const ReportOptions& options) {
  std::map<std::string, std::vector<std::size_t>> members;
  bool has_field = options.by.empty();
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    has_field = has_field || episodes[i].fields.contains(options.by);
    members[options.by.empty() ? "all" : field_of(episodes[i], options.by)].push_back(i);
  }
  if (!has_field) {
    std::set<std::string> known;
    for (const EpisodeLog& episode : episodes) {
      for (const auto& [field, value] : episode.fields) known.insert(field);
    }
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    throw std::invalid_argument("no episode has a field '" + options.by + "'; there are: " + names);
  }
  std::vector<GroupReport> groups;
  for (const auto& [name, indices] : members) {
    GroupReport group{.name = name, .episodes = indices};
    const auto logs = chosen(episodes, indices);
    group.found = static_cast<std::size_t>(std::ranges::count_if(logs, [](const auto* log) { return log->found(); }));
    for (const double until_s : kBeginnings_s) {
      group.my_pose.push_back({until_s, message_rate(logs, "my_pose", until_s, options.threshold_s)});
    }
    group.explored = mean_explored(logs, options.step_s);
    group.roles = roles_over_time(logs, options.step_s);
    groups.push_back(std::move(group));
  }
  return groups;
}

std::vector<double> pooled_times(std::span<const EpisodeLog> episodes, const GroupReport& group) {
  std::vector<double> times;
  for (const std::size_t index : group.episodes) {
    const auto some = times_between_messages(episodes[index], "my_pose", episodes[index].duration_s);
    times.insert(times.end(), some.begin(), some.end());
  }
  return times;
}

void match_thresholds(std::span<const EpisodeLog> episodes, const ReportOptions& options,
                      std::vector<GroupReport>& groups) {
  if (options.baseline.empty()) return;
  const auto baseline = std::ranges::find(groups, options.baseline, &GroupReport::name);
  if (baseline == groups.end()) {
    throw std::invalid_argument("no group is called '" + options.baseline + "', which was to be the baseline");
  }
  const double share = share_within(pooled_times(episodes, *baseline), options.threshold_s);
  for (GroupReport& group : groups) {
    group.matching_threshold_s = matching_threshold_s(pooled_times(episodes, group), share);
  }
}

/// A value of some episodes, by episode.
using Values = std::map<std::size_t, double>;

std::vector<double> values_in(const GroupReport& group, const Values& values) {
  std::vector<double> some;
  for (const std::size_t index : group.episodes) {
    if (const auto value = values.find(index); value != values.end()) some.push_back(value->second);
  }
  return some;
}

/// b minus a, of the episodes of both groups with the same value of the pairing field; the mean where there are many.
std::vector<double> paired_differences(std::span<const EpisodeLog> episodes, const ReportOptions& options,
                                       const GroupReport& a, const GroupReport& b, const Values& values) {
  if (options.pair.empty()) return {};
  std::map<std::string, std::array<std::vector<double>, 2>> by_pair;
  for (const std::size_t side : {0U, 1U}) {
    for (const std::size_t index : (side == 0 ? a : b).episodes) {
      const auto value = values.find(index);
      const auto key = episodes[index].fields.find(options.pair);
      if (value == values.end() || key == episodes[index].fields.end()) continue;
      by_pair[key->second][side].push_back(value->second);
    }
  }
  std::vector<double> differences;
  for (const auto& [key, sides] : by_pair) {
    if (!sides[0].empty() && !sides[1].empty()) differences.push_back(mean_of(sides[1]) - mean_of(sides[0]));
  }
  return differences;
}

Comparison compared(std::span<const EpisodeLog> episodes, const ReportOptions& options,
                    const std::vector<GroupReport>& groups, std::string measure, const Values& values) {
  Comparison comparison{.measure = std::move(measure)};
  std::vector<std::vector<double>> of_groups;
  for (const GroupReport& group : groups) {
    of_groups.push_back(values_in(group, values));
    const auto& some = of_groups.back();
    comparison.groups.push_back({some.size(), mean_of(some), deviation_of(some), median_of(some)});
  }
  comparison.anova = anova(of_groups);
  std::vector<double> p_values;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      const auto differences = paired_differences(episodes, options, groups[a], groups[b], values);
      PairComparison pair{.a = groups[a].name, .b = groups[b].name, .pairs = differences.size()};
      pair.p = differences.empty() ? permutation_p(of_groups[a], of_groups[b]) : paired_permutation_p(differences);
      pair.effect = hedges_g(of_groups[a], of_groups[b]);
      p_values.push_back(pair.p);
      comparison.pairs.push_back(std::move(pair));
    }
  }
  const auto strict = holm_adjusted(p_values);
  for (std::size_t i = 0; i < strict.size(); ++i) comparison.pairs[i].p_holm = strict[i];
  return comparison;
}

std::optional<double> number_in(const std::string& words) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (error != std::errc{} || end != words.data() + words.size()) return std::nullopt;
  return value;
}

/// Answers that are numbers, by question and episode.
std::map<std::string, Values> answers_of(std::span<const EpisodeLog> episodes) {
  std::map<std::string, Values> answers;
  for (std::size_t i = 0; i < episodes.size(); ++i) {
    for (const auto& [field, words] : episodes[i].fields) {
      if (const auto value = number_in(words)) answers[field][i] = *value;
    }
  }
  return answers;
}

}  // namespace

std::span<const Measure> measures() {
  return kMeasures;
}

std::string field_of(const EpisodeLog& episode, const std::string& field) {
  const auto value = episode.fields.find(field);
  return value == episode.fields.end() || value->second.empty() ? "(none)" : value->second;
}

Report make_report(std::span<const EpisodeLog> episodes, const ReportOptions& options) {
  Report report{.options = options};
  for (const EpisodeLog& episode : episodes) report.episodes.push_back(metrics_of(episode));
  report.groups = groups_of(episodes, options);
  match_thresholds(episodes, options, report.groups);
  for (const Measure& measure : measures()) {
    Values values;
    for (std::size_t i = 0; i < report.episodes.size(); ++i) {
      if (const auto value = measure.of(report.episodes[i])) values[i] = *value;
    }
    report.measures.push_back(compared(episodes, options, report.groups, std::string{measure.name}, values));
  }
  for (const auto& [question, values] : answers_of(episodes)) {
    if (question == options.by || question == options.pair) continue;
    report.questions.push_back(compared(episodes, options, report.groups, question, values));
  }
  return report;
}

}  // namespace tandem::experiment
