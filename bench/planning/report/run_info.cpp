#include "bench/planning/report/run_info.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <thread>

namespace tandem::bench {

std::string date_of(Time time) {
  const std::time_t seconds = to_stamp_ns(time) / 1'000'000'000;
  std::tm date{};
  gmtime_r(&seconds, &date);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &date);
  return text.data();
}

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string model = "unknown processor";
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) {
      model = line.substr(line.find(':') + 2);
      break;
    }
  }
  return model + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores";
}

void PartProgress::show(const std::string& last, std::size_t left) {
  ++done_;
  const bool on_terminal = isatty(STDERR_FILENO) != 0;
  const std::size_t all = done_ + left;
  if (!on_terminal && left > 0 && done_ % 20 != 0) return;
  std::fprintf(stderr, on_terminal ? "\r%-12s %zu of %zu  %-60.60s" : "%-12s %zu of %zu  %s\n", what_.c_str(), done_,
               all, last.c_str());
  if (on_terminal && left == 0) std::fputc('\n', stderr);
}

}  // namespace tandem::bench
