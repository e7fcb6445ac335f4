#pragma once

#include <map>
#include <string>

#include "bench/planning/report/results.hpp"

namespace tandem::bench {

/// Where and how the figures came to be.
struct ReportHead {
  std::string date;
  std::string commit;
  std::string machine;
  std::string command;
};

/// The files of a report by name: REPORT.md, the pictures it shows, runs.csv.
[[nodiscard]] std::map<std::string, std::string> report_files(const Results& results, const ReportHead& head);

/// The table of targets alone, as Markdown.
[[nodiscard]] std::string target_table(const Results& results);

}  // namespace tandem::bench
