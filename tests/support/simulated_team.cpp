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
void join_in(const HostNetwork& network, const fs::path& config) {
  if (!network.link) return;
  auto site = load_config<SiteConfig>(config / "site.toml");
  join(site, *network.link);
  write_file_atomically(config / "site.toml", write_config(site));
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
  join_in(options.robot_network, folder_.robot_config);
  join_in(options.laptop_network, folder_.laptop_config);
  set_in(folder_.laptop_config / "gateway.toml", {{"address", cli::toml_string(options.gateway_address)},
                                                  {"link_host", cli::toml_string(options.gateway_address)}});
  laptop_site_ = load_config<SiteConfig>(folder_.laptop_config / "site.toml");
  const auto robot_site = load_config<SiteConfig>(folder_.robot_config / "site.toml");

  cli::EpisodePlan plan;
  plan.session_code = "test";
  plan.limit_s = 600.0;
  const simulator::Place place{load_map(run.map)};
  robot_start_ = simulator::scene_of(scenario, place, simulator::MapChoice::OwnMap, options.seed).robot_start;
  plan.robot_start = robot_start_;

  const fs::path programs = fs::path{TANDEM_BINARY_DIR} / "bin";
  auto robot_services = cli::services_of("robot");
  robot_services.insert(robot_services.begin(), "simulator");
  const auto start = [&](const std::string& host, const std::vector<std::string>& services, const fs::path& config) {
    for (const auto& process : cli::processes_of(host, services, programs, config, folder_.logs)) {
      const std::string service = process.name.substr(process.name.find('/') + 1);
      const auto is_left_out = [&](const std::string& name) { return name == service || name == process.name; };
      if (std::any_of(options.without.begin(), options.without.end(), is_left_out)) continue;
      supervisor_.start(process);
      plans_.push_back(process);
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
  if (options.is_led) episode_ = std::make_unique<cli::Episode>(*laptop_bus_, laptop_site_, plan, place.map());
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
                           if (episode_) episode_->step();
                           for (auto& truth : truth_->take()) newest_truth_ = std::move(truth.message);
                           note_ends();
                           return !unexpected_end_.empty() || condition();
                         }) &&
         unexpected_end_.empty();
}

void SimulatedTeam::note_ends() {
  for (const auto& end : supervisor_.ended()) {
    if (std::erase(processes_, end.name) > 0) unexpected_end_ += end.name + ": " + end.last_log + "\n";
  }
}

void SimulatedTeam::kill(const std::string& host, const std::string& service) {
  const std::string name = host + "/" + service;
  std::erase(processes_, name);
  supervisor_.signal(name, SIGKILL);
  std::ignore = bus::wait_until(*robot_bus_, std::chrono::seconds{5}, [&] {
    note_ends();
    return !supervisor_.is_running(name);
  });
}

void SimulatedTeam::start_again(const std::string& host, const std::string& service) {
  const std::string name = host + "/" + service;
  const auto plan = std::find_if(plans_.begin(), plans_.end(), [&](const auto& one) { return one.name == name; });
  const HostNetwork& network = host == options_.robot ? options_.robot_network : options_.laptop_network;
  network.run([&] { supervisor_.start(*plan); });
  processes_.push_back(name);
}

std::vector<std::string> SimulatedTeam::services(const std::string& host) const {
  std::vector<std::string> names;
  for (const std::string& process : processes_) {
    const std::string service = process.substr(process.find('/') + 1);
    if (process == host + "/" + service && service != "simulator") names.push_back(service);
  }
  return names;
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
    if (episode_) episode_->step();
    for (auto& truth : truth_->take()) {
      if (speed_of(truth.message) > kTurning_mps) standstill.after_s = to_seconds(truth.received - began);
      newest_truth_ = std::move(truth.message);
    }
    return false;
  });
  return standstill;
}

std::string SimulatedTeam::last_words() const {
  std::string text = unexpected_end_;
  if (episode_) text += "phase: " + episode_->view().phase + " " + episode_->reason() + "\n";
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_.logs, ignored)) {
    text += entry.path().filename().string() + ": " + cli::last_line(entry.path()) + "\n";
  }
  return text;
}

}  // namespace tandem::test
