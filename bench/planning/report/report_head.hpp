#pragma once

#include <string>

namespace tandem::bench {

/// Where and how the figures of a report came to be.
struct ReportHead {
  std::string date;
  std::string commit;
  std::string machine;
  std::string command;
};

/// Today, this program on this machine.
[[nodiscard]] ReportHead report_head(const std::string& command);

}  // namespace tandem::bench
