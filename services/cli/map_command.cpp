#include "services/cli/map_command.hpp"

#include <CLI/CLI.hpp>

#include "services/cli/command.hpp"
#include "services/cli/map/map_build.hpp"
#include "services/cli/map/map_report.hpp"

namespace tandem::cli {
namespace {

void add_build(CLI::App& map) {
  const auto options = std::make_shared<MapBuildOptions>();
  CLI::App* build = add_command(map, "build", "Build a map from a recording's odometry and scans",
                                "tandem map build intel.mcap --output intel.yaml --svg intel.svg");
  build->add_option("RECORDING", options->file, "Recording with odometry and scans (.mcap)")->required();
  build->add_option("-o,--output", options->output, "map_server YAML file to write; the image goes beside it")
      ->required();
  build->add_option("--config", options->config, "A map-builder.toml; default: built-in values");
  build->add_option("--truth", options->truth, "A .relations file, or lines of t x y theta; plain or gzip");
  build->add_option("--truth-offset", options->truth_offset_s, "Truth time minus recording time [s]");
  build->add_option("--seed", options->seed, "Taken for uniformity: nothing is drawn, every seed gives the same map");
  build->add_option("--trajectory", options->trajectory, "Write the robot's poses here: lines of t x y theta");
  build->add_option("--svg", options->picture, "Draw the map with the way and the closures here");
  build->add_flag("--fresh", options->fresh, "Start anew, although a stopped build of this map could be gone on with");
  build->add_flag("--json", options->json, "Report as JSON");
  build->callback([options] { run_map_build(*options); });
}

void add_check(CLI::App& map) {
  const auto options = std::make_shared<MapCheckOptions>();
  CLI::App* check =
      add_command(map, "check", "Say what is wrong with a map, where, and what to do", "tandem map check intel.yaml");
  check->add_option("MAP", options->file, "map_server YAML file")->required();
  check->add_flag("--json", options->json, "Report as JSON");
  check->callback([options] { run_map_check(*options); });
}

}  // namespace

void add_map_command(CLI::App& tandem) {
  CLI::App* map = add_command(tandem, "map", "Build maps, and check them", "tandem map check intel.yaml");
  map->require_subcommand(1);
  add_build(*map);
  add_check(*map);
}

}  // namespace tandem::cli
