#include "bench/planning/loop/result_line.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

#include "bench/planning/statistics/statistics.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"

namespace tandem::bench {
namespace {

/// Shows each field of a record by name: writing and reading are visitors, so they cannot differ.
template <typename Record, typename Visitor>
void visit_fields(Record& record, Visitor&& field) {
  field("family", record.key.family);
  field("seed", record.key.seed);
  field("planner", record.key.planner);
  field("budget", record.key.budget);
  field("planner_seed", record.key.planner_seed);
  field("finished", record.finished);
  field("expected_time_s", record.expected_time_s);
  field("probability_left", record.probability_left);
  field("duration_s", record.duration_s);
  field("found_by_60_s", record.found_by_60_s);
  field("found_by_120_s", record.found_by_120_s);
  field("found_by_300_s", record.found_by_300_s);
  field("found_by_600_s", record.found_by_600_s);
  field("half_found_s", record.half_found_s);
  field("found95_s", record.found95_s);
  field("all_found_s", record.all_found_s);
  field("overlap", record.overlap);
  field("distance_m", record.distance_m);
  field("human_share", record.human_share);
  field("prepare_ms", record.prepare_ms);
  field("first_plan_ms", record.first_plan_ms);
  field("replan_p50_ms", record.replan_p50_ms);
  field("replan_p95_ms", record.replan_p95_ms);
  field("replan_p99_ms", record.replan_p99_ms);
  field("first_value_s", record.first_value_s);
  field("first_bound_s", record.first_bound_s);
  field("sweep_bound_s", record.sweep_bound_s);
  field("replans", record.replans);
  field("rollouts", record.rollouts);
  field("fallbacks", record.fallbacks);
  field("plan_change_m", record.plan_change_m);
}

}  // namespace

std::string budget_label(const PlanningBudget& budget) {
  char text[32];
  if (budget.rollouts) {
    std::snprintf(text, sizeof text, "%drollouts", *budget.rollouts);
  } else {
    std::snprintf(text, sizeof text, "%gms", budget.cpu_ms);
  }
  return text;
}

RunRecord record_of(const RunKey& key, const PlanningInstance& instance, const LoopResult& result) {
  RunRecord record;
  record.key = key;
  record.finished = result.finished;
  record.expected_time_s = result.score.expected_time_s;
  record.probability_left = result.score.probability_left;
  record.duration_s = result.duration_s;
  record.found_by_60_s = result.score.found_by_60_s;
  record.found_by_120_s = result.score.found_by_120_s;
  record.found_by_300_s = result.score.found_by_300_s;
  record.found_by_600_s = result.score.found_by_600_s;
  record.half_found_s = result.score.half_found_s;
  record.found95_s = result.score.found95_s;
  record.all_found_s = result.score.all_found_s;
  record.overlap = result.score.overlap;
  record.distance_m = result.score.distance_m;
  const double all_m = std::accumulate(record.distance_m.begin(), record.distance_m.end(), 0.0);
  for (std::size_t m = 0; m < record.distance_m.size(); ++m) {
    if (all_m > 0.0 && instance.searchers[m].id.starts_with("person"))
      record.human_share += record.distance_m[m] / all_m;
  }
  record.prepare_ms = result.prepare_ms;
  record.first_plan_ms = result.first_plan_ms;
  if (!result.replan_ms.empty()) {
    record.replan_p50_ms = quantile(result.replan_ms, 0.5);
    record.replan_p95_ms = quantile(result.replan_ms, 0.95);
    record.replan_p99_ms = quantile(result.replan_ms, 0.99);
  }
  record.first_value_s = result.first_value_s;
  record.first_bound_s = result.first_bound_s;
  record.sweep_bound_s = result.sweep_bound_s;
  record.replans = static_cast<int>(result.replan_ms.size());
  record.rollouts = result.rollouts;
  record.fallbacks = result.fallbacks;
  record.plan_change_m = result.plan_change_m;
  return record;
}

std::string to_line(const RunRecord& record) {
  nlohmann::ordered_json line;
  visit_fields(record, [&](const char* name, const auto& value) { line[name] = value; });
  return line.dump();
}

RunRecord from_line(std::string_view line) {
  RunRecord record;
  try {
    const auto json = nlohmann::json::parse(line);
    visit_fields(record, [&](const char* name, auto& value) { json.at(name).get_to(value); });
  } catch (const nlohmann::json::exception& error) {
    throw ConfigError(std::string("not a line of benchmark results: ") + error.what());
  }
  return record;
}

std::vector<RunRecord> read_records(const std::filesystem::path& file) {
  std::vector<RunRecord> records;
  if (!std::filesystem::exists(file)) return records;
  const std::string content = read_file(file);
  for (std::size_t begin = 0, end = 0; (end = content.find('\n', begin)) != std::string::npos; begin = end + 1) {
    records.push_back(from_line(std::string_view{content}.substr(begin, end - begin)));
  }
  return records;
}

}  // namespace tandem::bench
