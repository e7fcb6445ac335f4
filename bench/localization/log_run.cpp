#include "bench/localization/log_run.hpp"

#include <ctime>

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
  for (const LogEvent& event : log.events) {
    const Time time = time_of(event);
    if (time < options.from || time > options.until) continue;
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) {
      localizer.add_odometry(*odometry);
      continue;
    }
    const double before = thread_cpu_ms();
    auto result = localizer.add_scan(std::get<LaserScan>(event));
    if (result) steps.push_back({std::move(*result), thread_cpu_ms() - before});
  }
  return steps;
}

}  // namespace tandem::bench
