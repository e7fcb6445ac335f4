#include "services/bus/events.hpp"

#include <unistd.h>

#include <atomic>

namespace tandem::bus {

std::string new_event_id(const std::string& who, const Clock& clock) {
  static std::atomic<std::uint64_t> count = 0;
  return who + "-" + std::to_string(to_stamp_ns(clock.now())) + "-" + std::to_string(getpid()) + "-" +
         std::to_string(++count);
}

std::vector<std::string> split_appliers(std::string_view appliers) {
  std::vector<std::string> names;
  while (!appliers.empty()) {
    const auto comma = appliers.find(',');
    names.emplace_back(appliers.substr(0, comma));
    appliers = comma == std::string_view::npos ? std::string_view{} : appliers.substr(comma + 1);
  }
  return names;
}

}  // namespace tandem::bus
