#pragma once

#include <ctime>

namespace tandem::cli {

/// Processor time that the calling thread has used so far [ms]: other programs do not count.
[[nodiscard]] inline double thread_cpu_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace tandem::cli
