#pragma once

#include <map>
#include <string>

#include "bench/planning/report/report_head.hpp"
#include "bench/planning/report/results.hpp"

namespace tandem::bench {

/// The files of a report by name: REPORT.md, the pictures it shows, runs.csv.
[[nodiscard]] std::map<std::string, std::string> report_files(const Results& results, const ReportHead& head);

/// The table of targets alone, as Markdown.
[[nodiscard]] std::string target_table(const Results& results);

}  // namespace tandem::bench
