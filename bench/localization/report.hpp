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

/// Measures tracking, ablation, global localization, kidnapping, logs without truth and covariance with the default
/// parameters, and MRPT's localizer beside it where that is installed, and writes the report. Says on standard error
/// what it is at.
void run_campaign(const CampaignOptions& options);

}  // namespace tandem::bench
