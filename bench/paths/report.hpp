#pragma once

#include <map>
#include <span>
#include <string>

#include "bench/paths/path_case.hpp"
#include "bench/planning/report/report_head.hpp"

namespace tandem::bench {

/// The report and its pictures by name: for each family and planner how often there was a way within each budget, and
/// how much longer than the shortest it was.
[[nodiscard]] std::map<std::string, std::string> paths_report(std::span<const PathRecord> records,
                                                              const ReportHead& head);

}  // namespace tandem::bench
