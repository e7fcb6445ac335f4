#include "tests/support/simulated_team.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "services/cli/up/config_text.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/simulator/core/scenario.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;

/// Sets values in a service's config.
void set_in(const fs::path& file, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string toml = read_file(file);
  for (const auto& [key, value] : values) toml = cli::with_value(toml, key, value);
  write_file_atomically(file, toml);
}

/// Lets the relay of a host join the link in `network`.
void join(const fs::path& config, const HostNetwork& network) {
  if (network.link_address.empty()) return;
  std::string peers;
  for (const std::string& peer : network.peers) peers += (peers.empty() ? "" : ", ") + cli::toml_string(peer);
  set_in(config / "site.toml", {{"link_address", cli::toml_string(network.link_address)},
                                {"discovery", cli::toml_string("auto")},
                                {"peers", "[" + peers + "]"}});
}

double speed_of(const msg::GroundTruth& truth) {
  return std::max(std::abs(truth.left_wheel_mps()), std::abs(truth.right_wheel_mps()));
}

}  // namespace

SimulatedTeam::SimulatedTeam(const TeamOptions& options) : options_(options) {
  const fs::path root = fs::path{TANDEM_SOURCE_DIR} / "config";
  const fs::path scenario_file = root / "scenarios" / (options.scenario + ".json");
  const auto scenario = simulator::load_scenario(scenario_file);

  cli::SimulatedRun run;
  run.config_root = root;
  run.scenario = scenario_file;
  run.map = scenario.map_file;
  run.seed = options.seed;
  run.play = options.play;
  run.robot = options.robot;
  run.agent = options.agent;
  run.robot_domain = options.robot_domain;
  run.laptop_domain = options.laptop_domain;
  run.link_domain = options.link_domain;
  run.folder = home_ / "run";
  run.recording_folder = run.folder;
  folder_ = cli::make_run_folder(run);
  join(folder_.robot_config, options.robot_network);
  join(folder_.laptop_config, options.laptop_network);
  set_in(folder_.laptop_config / "gateway.toml", {{"address", cli::toml_string(options.gateway_address)},
                                                  {"link_host", cli::toml_string(options.gateway_address)}});
  laptop_site_ = load_config<SiteConfig>(folder_.laptop_config / "site.toml");
  const auto robot_site = load_config<SiteConfig>(folder_.robot_config / "site.toml");

  cli::EpisodePlan plan;
  plan.session_code = "test";
  plan.limit_s = 600.0;
  const simulator::Place place{load_map(run.map)};
  plan.robot_start = simulator::scene_of(scenario, place, simulator::MapChoice::OwnMap, options.seed).robot_start;

  const fs::path programs = fs::path{TANDEM_BINARY_DIR} / "bin";
  auto robot_services = cli::services_of("robot");
  robot_services.insert(robot_services.begin(), "simulator");
  const auto start = [&](const std::string& host, const std::vector<std::string>& services, const fs::path& config) {
    for (const auto& process : cli::processes_of(host, services, programs, config, folder_.logs)) {
      const std::string service = process.name.substr(process.name.find('/') + 1);
      const auto is_left_out = [&](const std::string& name) { return name == service || name == process.name; };
      if (std::any_of(options.without.begin(), options.without.end(), is_left_out)) continue;
      supervisor_.start(process);
      processes_.push_back(process.name);
      plan.needed.push_back(process.name);
    }
  };
  options.robot_network.run([&] {
    start(options.robot, robot_services, folder_.robot_config);
    robot_bus_ = std::make_unique<bus::Bus>(bus::host_domain(robot_site, "test"));
  });
  options.laptop_network.run([&] {
    start(laptop_site_.host, cli::services_of("laptop"), folder_.laptop_config);
    laptop_bus_ = std::make_unique<bus::Bus>(bus::host_domain(laptop_site_, "test"));
  });
  truth_ = std::make_unique<bus::InOrder<msg::GroundTruth, msg::GroundTruthPubSubType>>(
      robot_bus_->in_order(topic::kGroundTruth));
  episode_ = std::make_unique<cli::Episode>(*laptop_bus_, laptop_site_, plan, place.map());
}

SimulatedTeam::~SimulatedTeam() {
  stop();
}

void SimulatedTeam::stop() {
  supervisor_.stop_all(std::chrono::seconds{10});
}

std::filesystem::path SimulatedTeam::recording(const std::string& role) const {
  return home_ / "run" / (role == "robot" ? "episode-robot.mcap" : "episode.mcap");
}

bool SimulatedTeam::run_until(Duration timeout, const std::function<bool()>& condition) {
  return bus::wait_until(*robot_bus_, timeout,
                         [&] {
                           episode_->step();
                           for (auto& truth : truth_->take()) newest_truth_ = std::move(truth.message);
                           for (const auto& end : supervisor_.ended()) {
                             if (std::erase(processes_, end.name) > 0)
                               unexpected_end_ += end.name + ": " + end.last_log + "\n";
                           }
                           return !unexpected_end_.empty() || condition();
                         }) &&
         unexpected_end_.empty();
}

void SimulatedTeam::kill(const std::string& host, const std::string& service) {
  std::erase(processes_, host + "/" + service);
  supervisor_.signal(host + "/" + service, SIGKILL);
}

std::optional<double> SimulatedTeam::wheel_speed_mps() const {
  if (!newest_truth_) return std::nullopt;
  return speed_of(*newest_truth_);
}

SimulatedTeam::Standstill SimulatedTeam::watch_wheels(Duration duration) {
  constexpr double kTurning_mps = 0.005;
  const Time began = robot_bus_->clock().now();
  Standstill standstill;
  std::ignore = bus::wait_until(*robot_bus_, duration, [&] {
    episode_->step();
    for (auto& truth : truth_->take()) {
      if (speed_of(truth.message) > kTurning_mps) standstill.after_s = to_seconds(truth.received - began);
      newest_truth_ = std::move(truth.message);
    }
    return false;
  });
  return standstill;
}

std::string SimulatedTeam::last_words() const {
  std::string text = unexpected_end_ + "phase: " + episode_->view().phase + " " + episode_->reason() + "\n";
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_.logs, ignored)) {
    text += entry.path().filename().string() + ": " + cli::last_line(entry.path()) + "\n";
  }
  return text;
}

}  // namespace tandem::test
