#pragma once

#include <filesystem>

namespace tandem::bench {

/// What a run of the benchmark is asked for.
struct CalibrationCampaign {
  std::filesystem::path data_folder;
  std::filesystem::path output;  ///< gets REPORT.md
  int seeds = 100;
};

/// Calibrates simulated robots of seeds 1, 2, ... and the recorded logs, and writes the report. Says on standard error
/// what it is at.
void run_calibration_campaign(const CalibrationCampaign& campaign);

}  // namespace tandem::bench
