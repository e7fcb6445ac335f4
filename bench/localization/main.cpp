// tandem-bench-localization: how well the robot finds itself on real logs; see docs/localization.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "bench/localization/report.hpp"

int main(int argc, char** argv) {
  CLI::App app{"The localization benchmark"};
  tandem::bench::CampaignOptions options;
  app.add_option("--data", options.data_folder, "Folder of docs/data.md")->required();
  app.add_option("--output", options.output, "Folder for REPORT.md")->required();
  app.add_option("--starts", options.starts, "Global starts and kidnappings per log")->capture_default_str();
  app.add_option("--drives", options.drives, "Simulated drives per kind")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    tandem::bench::run_campaign(options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-localization: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
