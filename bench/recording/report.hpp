#pragma once

#include <string>
#include <vector>

#include "bench/planning/report/report_head.hpp"

namespace tandem::bench {

/// One target, what was measured, and whether that is enough.
struct RecordingRow {
  std::string target;
  std::string measured;
  bool is_met = false;
};

/// The table of all rows, for the terminal and the report.
[[nodiscard]] std::string recording_table(const std::vector<RecordingRow>& rows);

/// REPORT.md.
[[nodiscard]] std::string recording_report(const std::vector<RecordingRow>& rows, const ReportHead& head);

}  // namespace tandem::bench
