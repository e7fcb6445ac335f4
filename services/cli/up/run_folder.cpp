#include "services/cli/up/run_folder.hpp"

#include <stdexcept>
#include <utility>

#include "services/cli/up/config_text.hpp"
#include "services/cli/up/ports.hpp"
#include "services/common/file_io.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;
constexpr const char* kLoopback = "127.0.0.1";

/// The config of one host, being written.
class HostConfig {
 public:
  HostConfig(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) { fs::create_directories(to_); }

  /// Copies `service`.toml with `values` set.
  void write(const std::string& service, const std::vector<std::pair<std::string, std::string>>& values = {}) const {
    const std::string file = service + ".toml";
    std::string toml = fs::exists(from_ / file) ? read_file(from_ / file) : "";
    for (const auto& [key, value] : values) toml = with_value(toml, key, value);
    write_file_atomically(to_ / file, toml);
  }

 private:
  fs::path from_;
  fs::path to_;
};

std::string tcp(int port) {
  return toml_string("tcp://" + std::string{kLoopback} + ":" + std::to_string(port));
}

std::string path_value(const fs::path& path) {
  return toml_string(fs::absolute(path).string());
}

}  // namespace

RunFolder make_run_folder(const SimulatedRun& run) {
  RunFolder made;
  made.robot_config = run.folder / "robot";
  made.laptop_config = run.folder / "laptop";
  made.logs = run.folder / "logs";
  made.participant_link = fs::absolute(run.folder / "participant.link");
  made.observer_link = fs::absolute(run.folder / "observer.link");
  const auto port = [&](int well_known) { return free_tcp_port(kLoopback, run.well_known_ports ? well_known : 0); };
  made.base_port = port(8101);
  const int laser_port = port(10940);
  const int camera_port = port(8090);
  made.gateway_port = port(8443);
  fs::create_directories(made.logs);

  const std::string seed = std::to_string(run.seed);
  const std::vector<std::pair<std::string, std::string>> team{{"robot", toml_string(run.robot)},
                                                              {"agent", toml_string(run.agent)},
                                                              {"link_domain", std::to_string(run.link_domain)}};

  const HostConfig robot{run.config_root / "simulation" / "robot", made.robot_config};
  auto robot_site = team;
  robot_site.emplace_back("host", toml_string(run.robot));
  robot_site.emplace_back("host_domain", std::to_string(run.robot_domain));
  robot.write("site", robot_site);
  std::vector<std::pair<std::string, std::string>> simulator{
      {"scenario", path_value(run.scenario)},
      {"map", run.other_map ? path_value(run.map) : toml_string("")},
      {"seed", seed},
      {"person", toml_string(run.play ? "none" : "scenario")},
      {"phone_pairing_file", run.play ? toml_string("") : toml_string(made.participant_link.string())},
      {"base_port", std::to_string(made.base_port)},
      {"laser_port", std::to_string(laser_port)},
      {"camera_port", std::to_string(camera_port)}};
  robot.write("simulator", simulator);
  robot.write("base", {{"device", tcp(made.base_port)}, {"map", path_value(run.map)}});
  robot.write("laser", {{"device", tcp(laser_port)}});
  robot.write("camera", {{"source", toml_string("http://" + std::string{kLoopback} + ":" + std::to_string(camera_port) +
                                                "/stream.mjpeg")}});
  robot.write("map-server", {{"map", path_value(run.map)}});
  robot.write("localization", {{"seed", seed}});
  robot.write("tracker");
  robot.write("navigator");
  robot.write("relay");
  robot.write("recorder",
              {{"folder", path_value(run.recording_folder)}, {"name", toml_string(run.recording_name + "-robot")}});

  const HostConfig laptop{run.config_root / "simulation" / "laptop", made.laptop_config};
  auto laptop_site = team;
  laptop_site.emplace_back("host", toml_string("laptop-of-" + run.robot));
  laptop_site.emplace_back("host_domain", std::to_string(run.laptop_domain));
  laptop.write("site", laptop_site);
  laptop.write("map-server", {{"map", path_value(run.map)}});
  laptop.write("planner", {{"seed", seed}});
  laptop.write("relay");
  laptop.write("gateway", {{"address", toml_string(kLoopback)},
                           {"port", std::to_string(made.gateway_port)},
                           {"link_host", toml_string("localhost")},
                           {"state_folder", path_value(run.folder / "gateway")},
                           {"participant_link_file", toml_string(made.participant_link.string())},
                           {"observer_link_file", toml_string(made.observer_link.string())}});
  laptop.write("recorder", {{"folder", path_value(run.recording_folder)}, {"name", toml_string(run.recording_name)}});
  return made;
}

std::vector<std::string> services_of(const std::string& role) {
  const std::vector<std::string> robot{"recorder",     "relay",   "map-server", "base",  "laser",
                                       "localization", "tracker", "navigator",  "camera"};
  const std::vector<std::string> laptop{"recorder", "relay", "map-server", "planner", "gateway"};
  if (role == "robot") return robot;
  if (role == "laptop") return laptop;
  auto both = robot;
  both.insert(both.end(), {"planner", "gateway"});
  return both;
}

std::vector<ProcessPlan> processes_of(const std::string& host, const std::vector<std::string>& services,
                                      const fs::path& programs, const fs::path& config_folder, const fs::path& logs) {
  std::vector<ProcessPlan> plans;
  for (const auto& service : services) {
    plans.push_back({host + "/" + service,
                     programs / ("tandem-" + service),
                     {"--config", config_folder.string()},
                     logs / (host + "-" + service + ".log")});
  }
  return plans;
}

fs::path program_folder() {
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path installed = own / ".." / "lib" / "tandem";
  return fs::exists(installed / "tandem-relay") ? fs::weakly_canonical(installed) : own;
}

fs::path default_config_root() {
  for (const auto& candidate :
       {fs::path{"config"}, program_folder() / ".." / ".." / "config", fs::path{"/usr/share/tandem"}}) {
    if (fs::exists(candidate / "simulation")) return fs::weakly_canonical(candidate);
  }
  throw std::runtime_error("no config/simulation here; name the folder with --config");
}

}  // namespace tandem::cli
