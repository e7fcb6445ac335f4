#include "services/common/service_options.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "services/common/logging.hpp"
#include "services/common/version.hpp"

namespace tandem {

ServiceOptions parse_service_options(int argc, char** argv, const std::string& service, const std::string& purpose) {
  ServiceOptions options;
  options.service = service;
  options.config_folder = "/etc/tandem";
  const std::string program = "tandem-" + service;
  CLI::App app{purpose, program};
  app.footer("Example: " + program + " --config config/simulation/robot");
  app.set_version_flag("--version", program + " " + version_line());
  app.add_option("--config", options.config_folder, "Folder with site.toml and " + service + ".toml")
      ->capture_default_str();
  app.add_option("--clock", options.clock, "Whose time: the machine's, or the clock topic's")
      ->check(CLI::IsMember({"steady", "bus"}))
      ->capture_default_str();
  app.add_flag("--lockstep", options.lockstep, "Lossless topics, for lockstep replay");
  app.add_option("--log-level", options.log_level)
      ->check(CLI::IsMember({"debug", "info", "warn", "error"}))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    std::exit(code == 0 ? EXIT_SUCCESS : 2);
  }
  if (options.lockstep) options.clock = "bus";
  start_logging(service, options.log_level);
  return options;
}

}  // namespace tandem
