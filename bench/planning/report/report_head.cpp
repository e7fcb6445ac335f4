#include "bench/planning/report/report_head.hpp"

#include <array>
#include <ctime>
#include <fstream>
#include <thread>

#include "services/common/clock.hpp"
#include "services/common/version.hpp"

namespace tandem::bench {
namespace {

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

}  // namespace

ReportHead report_head(const std::string& command) {
  return {date_of(SteadyClock{}.now()), commit(), machine(), command};
}

}  // namespace tandem::bench
