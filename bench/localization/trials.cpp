#include "bench/localization/trials.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::bench {
namespace {

constexpr double kWarmUpM = 5.0;      ///< driven before the robot is carried away
constexpr double kCarriedM = 3.0;     ///< at least this far
constexpr int kGrounds = 200;         ///< places where it may be put down
constexpr double kEndMarginM = 12.0;  ///< way that must be left in the log at a start

const char* name_of(LocalizationStatus status) {
  if (status == LocalizationStatus::Ok) return "ok";
  return status == LocalizationStatus::Lost ? "lost" : "uncertain";
}

/// Judges the poses from `from` on.
Trial judged(const RecordedLog& log, const std::vector<RunStep>& steps, Time from) {
  Trial trial;
  trial.start_s = to_seconds(from.time_since_epoch());
  // Where nothing is said before, nothing is claimed.
  const bool was_silent = steps.empty() || steps.front().result.time >= from;
  for (const RunStep& step : steps) {
    if (step.result.time < from) continue;
    const auto truth = pose_at(log.truth, step.result.time);
    if (!truth) continue;
    ++trial.scans;
    trial.slowest_ms = std::max(trial.slowest_ms, step.longest_ms);
    const bool ok = step.result.status == LocalizationStatus::Ok;
    const bool right = is_right(step.result.map_from_base, *truth);
    const double way_m = way_between_m(log, from, step.result.time);
    if (ok && trial.settled_m < 0.0) trial.settled_m = way_m;
    if (!ok && trial.flagged_s < 0.0) {
      trial.flagged_s = was_silent && trial.scans == 1 ? 0.0 : to_seconds(step.result.time - from);
    }
    if (ok && !right) ++trial.wrong_ok;
    if (!right) trial.right_m = -1.0;
    if (ok && right && trial.right_m < 0.0) trial.right_m = way_m;
    trial.final_m = (step.result.map_from_base.position() - truth->position()).norm();
    trial.final_deg = std::abs(to_degrees(turn_between(step.result.map_from_base.heading, truth->heading)));
    trial.final_status = name_of(step.result.status);
  }
  return trial;
}

/// `count` times spread over the log, with way enough left after each.
std::vector<Time> spread(const RecordedLog& log, int count, double way_left_m) {
  const double all_m = way_between_m(log, Time{Duration::min()}, Time{Duration::max()});
  std::vector<Time> times;
  for (int i = 0; i < count; ++i) {
    times.push_back(time_after_way(log, log.truth.front().time, (all_m - way_left_m) * (i + 0.02) / count));
  }
  return times;
}

}  // namespace

bool is_right(const Pose2& estimate, const Pose2& truth) {
  return (estimate.position() - truth.position()).norm() <= 0.5 &&
         std::abs(to_degrees(turn_between(estimate.heading, truth.heading))) <= 10.0;
}

std::vector<Trial> global_trials(const RecordedLog& log, const LocalizationConfig& config, int count, double way_m) {
  std::vector<Trial> trials;
  for (const Time from : spread(log, count, way_m)) {
    RunOptions options{.config = config, .from = from, .until = time_after_way(log, from, way_m)};
    options.config.start.clear();
    options.config.start_globally = true;
    trials.push_back(judged(log, run_log(log, options), from));
  }
  return trials;
}

std::vector<Trial> kidnap_trials(const RecordedLog& log, const LocalizationConfig& config, int count, double way_m) {
  std::vector<Trial> trials;
  const std::vector<Time> places = spread(log, count, kEndMarginM);
  const std::vector<Time> grounds = spread(log, kGrounds, kEndMarginM);
  Rng rng{1};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Time start = places[i];
    const Time lifted = time_after_way(log, start, kWarmUpM);
    const Pose2 from = pose_at(log.truth, lifted).value_or(log.truth.back().map_from_base);
    Time put_down = grounds[rng.index(grounds.size())];
    while (true) {
      const auto to = pose_at(log.truth, put_down);
      if (to && (to->position() - from.position()).norm() > kCarriedM) break;
      put_down = grounds[rng.index(grounds.size())];
    }
    const RecordedLog spliced = carried(log, lifted, put_down, way_m);
    RunOptions options{.config = config, .from = start};
    const Pose2 first = pose_at(log.truth, start).value_or(Pose2{});
    options.config.start = {first.x, first.y, first.heading};
    trials.push_back(judged(spliced, run_log(spliced, options), lifted + std::chrono::milliseconds{1}));
  }
  return trials;
}

}  // namespace tandem::bench
