#include "bench/planning/loop/cpu_clock.hpp"

#include <ctime>

namespace tandem::bench {

double thread_cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

std::function<bool()> stop_after_cpu_ms(double budget_ms) {
  return [end_ms = thread_cpu_ms() + budget_ms] { return thread_cpu_ms() >= end_ms; };
}

}  // namespace tandem::bench
