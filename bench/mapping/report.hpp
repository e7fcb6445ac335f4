#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tandem::bench {

/// What a run of the benchmark is asked for.
struct MappingCampaign {
  std::filesystem::path data_folder;
  std::filesystem::path output;  ///< gets REPORT.md and the pictures
  std::vector<std::string> logs{"intel", "fr079", "frcampus"};
};

/// Builds each log's map with the default parameters, and without the parts whose gain is asked for, and writes the
/// report. Says on standard error what it is at.
void run_mapping_campaign(const MappingCampaign& campaign);

}  // namespace tandem::bench
