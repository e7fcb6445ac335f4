#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::cli {

/// What became of one topic.
struct CsvExport {
  std::string topic;
  std::uint64_t rows = 0;
  std::uint64_t broken = 0;  ///< messages that are not what the schema says
  std::string problem;       ///< why it has no file; empty if it has
};

/// Writes `folder`/<topic>.csv for each topic that is chosen by the patterns `topics` (all, if there are none): log
/// time, publish time, sequence, then the message's fields as the recording's own IDL names them. Throws FileError.
[[nodiscard]] std::vector<CsvExport> export_csv(mcap::Reader& reader, const std::filesystem::path& folder,
                                                const std::vector<std::string>& topics,
                                                const std::function<bool(double share)>& keep_going);

}  // namespace tandem::cli
