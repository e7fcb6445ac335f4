#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "services/cli/up/supervisor.hpp"

namespace tandem::cli {

/// What a simulated run is made from.
struct SimulatedRun {
  std::filesystem::path config_root;  ///< holds simulation/, scenarios/, maps/
  std::filesystem::path folder;       ///< of this run; its configs, logs and state go here
  std::filesystem::path scenario;     ///< JSON file
  std::filesystem::path map;          ///< map_server YAML file: the scenario's, or another
  bool other_map = false;             ///< `map` is not the scenario's own
  std::uint64_t seed = 1;
  bool well_known_ports = false;  ///< prefer 8101, 10940, 8090 and 8443; else any free ones
  bool play = false;  ///< a real phone instead of the simulated person
  int robot_domain = 0;
  int laptop_domain = 0;
  int link_domain = 0;
  std::string robot = "robot1";
  std::string agent = "person1";
  std::string recording_name = "episode";
  std::filesystem::path recording_folder;
};

/// Where things of a run are.
struct RunFolder {
  std::filesystem::path robot_config;
  std::filesystem::path laptop_config;
  std::filesystem::path logs;
  std::filesystem::path participant_link;  ///< holds a usable pairing link once the gateway is up
  std::filesystem::path observer_link;
  int base_port = 0;
  int gateway_port = 0;
};

/// Writes the configs of both hosts: those of config/simulation with this run's domains, ports, paths and seed.
[[nodiscard]] RunFolder make_run_folder(const SimulatedRun& run);

/// The services of a host by role ("robot", "laptop", "both"), in the order in which they are started.
[[nodiscard]] std::vector<std::string> services_of(const std::string& role);

/// The processes of one host, each with --config `config_folder`; names are "<host>/<service>".
[[nodiscard]] std::vector<ProcessPlan> processes_of(const std::string& host, const std::vector<std::string>& services,
                                                    const std::filesystem::path& programs,
                                                    const std::filesystem::path& config_folder,
                                                    const std::filesystem::path& logs);

/// Where the services' programs are: beside this one, or in lib/tandem where it is installed.
[[nodiscard]] std::filesystem::path program_folder();

/// The folder with simulation/, scenarios/ and maps/: ./config, beside the build folder, or installed.
[[nodiscard]] std::filesystem::path default_config_root();

}  // namespace tandem::cli
