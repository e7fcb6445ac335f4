#pragma once

#include <filesystem>
#include <string>

namespace tandem {

/// What every service understands on its command line.
struct ServiceOptions {
  std::string service;                  ///< "planner" for tandem-planner
  std::filesystem::path config_folder;  ///< holds site.toml and <service>.toml
  std::string clock = "steady";         ///< "steady", or "bus" to follow the clock topic (simulation, replay)
  bool lockstep = false;                ///< lossless topics for lockstep replay; implies clock "bus"
  std::string log_level = "info";

  [[nodiscard]] std::filesystem::path site_file() const { return config_folder / "site.toml"; }
  [[nodiscard]] std::filesystem::path config_file() const { return config_folder / (service + ".toml"); }
};

/// Parses the command line of `tandem-<service>` and starts logging. Ends the process for --help, --version (0) and for
/// wrong use (2), as every program of ours does.
[[nodiscard]] ServiceOptions parse_service_options(int argc, char** argv, const std::string& service,
                                                   const std::string& purpose);

}  // namespace tandem
