// tandem-bench-mapping: how true the maps are that are built from real logs; see docs/mapping.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "bench/mapping/report.hpp"

int main(int argc, char** argv) {
  CLI::App app{"The mapping benchmark"};
  tandem::bench::MappingCampaign campaign;
  app.add_option("--data", campaign.data_folder, "Folder of docs/data.md")->required();
  app.add_option("--output", campaign.output, "Folder for REPORT.md")->required();
  app.add_option("--logs", campaign.logs, "Only these: intel, fr079, frcampus")->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  try {
    tandem::bench::run_mapping_campaign(campaign);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-mapping: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
