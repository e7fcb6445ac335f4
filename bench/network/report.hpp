#pragma once

#include <map>
#include <string>
#include <vector>

#include "bench/network/record.hpp"

namespace tandem::bench {

/// What stands at the head of the report.
struct NetworkRunInfo {
  std::string date;
  std::string commit;
  std::string machine;
  std::string command;
};

/// The files of the report, by name: REPORT.md and its pictures.
[[nodiscard]] std::map<std::string, std::string> network_report(const std::vector<NetworkRecord>& records,
                                                                const NetworkRunInfo& info);

/// The targets, what was measured, and whether that is enough.
[[nodiscard]] std::string network_targets(const std::vector<NetworkRecord>& records);

}  // namespace tandem::bench
