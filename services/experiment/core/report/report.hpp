#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "services/experiment/core/report/episode_log.hpp"
#include "services/experiment/core/report/episode_metrics.hpp"
#include "services/experiment/core/report/message_rate.hpp"
#include "services/experiment/core/report/role_timeline.hpp"
#include "services/experiment/core/report/search_progress.hpp"
#include "services/experiment/core/report/statistics.hpp"

namespace tandem::experiment {

/// What a report is asked for.
struct ReportOptions {
  std::string by = {};        ///< field that splits the episodes into groups; empty: one group
  std::string pair = {};      ///< field that is equal for what belongs together (a participant); empty: no pairs
  double threshold_s = 10.0;  ///< of the time between *My pose* messages (paper 8.4.1)
  std::string baseline =
      {};               ///< group whose share within the threshold the others' thresholds are matched to, or empty
  double step_s = 5.0;  ///< of lines over time
};

/// A number over the episodes of a group.
struct GroupValue {
  std::size_t n = 0;
  double mean = 0.0;
  double deviation = 0.0;
  double median = 0.0;
};

/// A row of Table 1: the first `until_s` of each episode; infinite: all of it.
struct RateRow {
  double until_s = 0.0;
  MessageRate rate = {};
};

struct GroupReport {
  std::string name = {};                   ///< value of the field; "all" without one
  std::vector<std::size_t> episodes = {};  ///< indices into the report's
  std::size_t found = 0;
  std::vector<RateRow> my_pose = {};  ///< of 60, 90, 120 s and of all
  double matching_threshold_s = 0.0;  ///< that gives this group the baseline's share; 0: no baseline
  std::vector<MeanExploredAt> explored = {};
  std::vector<RolesAt> roles = {};
};

/// Two groups, one measure.
struct PairComparison {
  std::string a = {};
  std::string b = {};
  double p = 1.0;          ///< permutation test; of pairs where there are
  double p_holm = 1.0;     ///< among the pairs of this measure
  std::size_t pairs = 0;   ///< 0: the groups were compared as independent
  EffectSize effect = {};  ///< of b against a
};

/// One measure over all groups.
struct Comparison {
  std::string measure = {};             ///< name of a metric, or a question of a form
  std::vector<GroupValue> groups = {};  ///< in the order of the report's
  Anova anova = {};
  std::vector<PairComparison> pairs = {};
};

struct Report {
  ReportOptions options = {};
  std::vector<EpisodeMetrics> episodes = {};  ///< in the order of the logs
  std::vector<GroupReport> groups = {};       ///< by name
  std::vector<Comparison> measures = {};
  std::vector<Comparison> questions = {};  ///< of answers that are numbers; "layer ..." is no question
};

/// A number of an episode that a report compares and lists; `unit` is "" for shares and counts.
struct Measure {
  std::string_view name;
  std::string_view unit;
  std::string_view words;
  std::optional<double> (*of)(const EpisodeMetrics&);  ///< none: what it is made of was not recorded
};
[[nodiscard]] std::span<const Measure> measures();

/// Throws std::invalid_argument when `options` name a field or a group that no episode has.
[[nodiscard]] Report make_report(std::span<const EpisodeLog> episodes, const ReportOptions& options);

/// The value of `field` in an episode; "(none)" where it has none.
[[nodiscard]] std::string field_of(const EpisodeLog& episode, const std::string& field);

}  // namespace tandem::experiment
