// tandem-bench-calibration: how true and how honest calibrations are; see docs/calibration.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "bench/calibration/report.hpp"

int main(int argc, char** argv) {
  CLI::App app{"The calibration benchmark"};
  tandem::bench::CalibrationCampaign campaign;
  app.add_option("--data", campaign.data_folder, "Folder of docs/data.md")->required();
  app.add_option("--output", campaign.output, "Folder for REPORT.md")->required();
  app.add_option("--seeds", campaign.seeds, "Simulated drives")->check(CLI::Range(1, 10'000));
  CLI11_PARSE(app, argc, argv);
  try {
    tandem::bench::run_calibration_campaign(campaign);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-calibration: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
