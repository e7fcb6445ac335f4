#pragma once

#include <filesystem>
#include <string>

namespace tandem::bench {

/// What a run of the benchmark is asked for.
struct CampaignOptions {
  std::filesystem::path data_folder;
  std::filesystem::path output;  ///< gets REPORT.md and the pictures
  int starts = 10;               ///< global starts and kidnappings per log
  int drives = 16;               ///< simulated drives per kind
};

/// Measures tracking, ablation, global localization, kidnapping and covariance with the default parameters, and writes
/// the report. Says on standard error what it is at.
void run_campaign(const CampaignOptions& options);

}  // namespace tandem::bench
