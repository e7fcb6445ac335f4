#include "bench/localization/log_run.hpp"

#include <algorithm>
#include <ctime>
#include <optional>

namespace tandem::bench {
namespace {

double thread_cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::vector<RunStep> run_log(const RecordedLog& log, const RunOptions& options) {
  Localizer localizer{log.map, options.config};
  std::vector<RunStep> steps;
  double spent_ms = 0.0;  // since the last pose: odometry too may go on with a search
  double longest_ms = 0.0;
  for (const LogEvent& event : log.events) {
    const Time time = time_of(event);
    if (time < options.from || time > options.until) continue;
    std::optional<LocalizationResult> result;
    const double before = thread_cpu_ms();
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) {
      localizer.add_odometry(*odometry);
    } else {
      result = localizer.add_scan(std::get<LaserScan>(event));
    }
    const double took_ms = thread_cpu_ms() - before;
    spent_ms += took_ms;
    longest_ms = std::max(longest_ms, took_ms);
    if (!result) continue;
    steps.push_back({std::move(*result), spent_ms, longest_ms});
    spent_ms = 0.0;
    longest_ms = 0.0;
  }
  return steps;
}

}  // namespace tandem::bench
