#include "services/cli/up_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "services/bus/domain_lease.hpp"
#include "services/cli/command.hpp"
#include "services/cli/scenario_files.hpp"
#include "services/cli/up/episode.hpp"
#include "services/cli/up/run_folder.hpp"
#include "services/cli/up/screen.hpp"
#include "services/cli/up/supervisor.hpp"
#include "services/common/clock.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/simulator/core/scenario.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct UpOptions {
  std::string config;
  std::vector<std::string> only;
  std::string scenario;
  std::string map;
  std::uint64_t seed = 1;
  bool play = false;
  bool headless = false;
  double limit_s = 0.0;
  std::string json_file;
  std::string output = ".";
};

bool is_wanted(const std::vector<std::string>& only, const std::string& service) {
  return only.empty() || std::find(only.begin(), only.end(), service) != only.end();
}

/// Throws when a process ended that should not have.
void check_processes(Supervisor& supervisor) {
  for (const auto& end : supervisor.ended()) {
    throw std::runtime_error(end.name + " ended (exit " + std::to_string(end.code) + "): " + end.last_log);
  }
}

nlohmann::json report_of(const Episode& episode, const SimulatedRun& run, const simulator::Scenario& scenario,
                         double processor_cores) {
  const EpisodeView& view = episode.view();
  return {{"found", episode.phase() == Episode::Phase::Found},
          {"found_by", view.found_by},
          {"time_s", view.time_s},
          {"explored", view.explored},
          {"explored_robot", view.explored_robot},
          {"explored_human", view.explored_human},
          {"robot_distance_m", view.robot_distance_m},
          {"human_distance_m", view.human_distance_m},
          {"recording", (run.recording_folder / (run.recording_name + ".mcap")).string()},
          {"picture", (run.recording_folder / (run.recording_name + ".png")).string()},
          {"stops", view.stops},
          {"messages", view.messages},
          {"cpu_cores", processor_cores},
          {"scenario", scenario.name},
          {"seed", run.seed},
          {"reason", episode.reason()}};
}

/// A whole episode on simulated hardware, both hosts on this machine.
void simulate(const UpOptions& options) {
  const fs::path root = options.config.empty() ? default_config_root() : fs::path{options.config};
  const fs::path file = scenario_file(options.scenario, root);
  const auto scenario = simulator::load_scenario(file);

  SimulatedRun run;
  run.config_root = root;
  run.scenario = file;
  run.other_map = !options.map.empty();
  run.map = run.other_map ? fs::path{options.map} : scenario.map_file;
  run.seed = options.seed;
  run.play = options.play;
  run.recording_folder = options.output;
  run.folder = fs::path{options.output} / "run.d";
  fs::create_directories(run.recording_folder);
  fs::remove_all(run.folder);
  // A recording of an earlier run is not appended to.
  for (const auto* suffix : {".mcap", "-robot.mcap", ".png"})
    fs::remove(run.recording_folder / (run.recording_name + suffix));

  const bus::DomainLease domains{3, bus::DomainLease::kFirstForDemos};
  run.robot_domain = domains[0];
  run.laptop_domain = domains[1];
  run.link_domain = domains[2];
  // They belong to the first run on this machine: two that start together would both find them free.
  run.well_known_ports = run.robot_domain == bus::DomainLease::kFirstForDemos;

  const simulator::Place place{load_map(run.map)};
  const auto scene = simulator::scene_of(
      scenario, place, run.other_map ? simulator::MapChoice::OtherMap : simulator::MapChoice::OwnMap, run.seed);

  const RunFolder folder = make_run_folder(run);
  const auto laptop_site = load_config<SiteConfig>(folder.laptop_config / "site.toml");
  auto robot_services = services_of("robot");
  robot_services.insert(robot_services.begin(), "simulator");
  const auto laptop_services = services_of("laptop");

  Supervisor supervisor;
  EpisodePlan plan;
  plan.session_code = "demo-" + scenario.name + "-" + std::to_string(run.seed);
  plan.limit_s = options.limit_s > 0.0 ? options.limit_s : scenario.limit_s;
  plan.robot_start = scene.robot_start;
  const auto start = [&](const std::string& host, const std::vector<std::string>& services, const fs::path& config) {
    for (const auto& process : processes_of(host, services, program_folder(), config, folder.logs)) {
      const std::string service = process.name.substr(process.name.find('/') + 1);
      if (!is_wanted(options.only, service)) continue;
      supervisor.start(process);
      plan.needed.push_back(process.name);
    }
  };
  start(run.robot, robot_services, folder.robot_config);
  start(laptop_site.host, laptop_services, folder.laptop_config);

  bus::Bus laptop{bus::host_domain(laptop_site, "up")};
  Episode episode{laptop, laptop_site, plan, place.map()};
  Screen screen{options.headless};
  SteadyClock clock;
  const Time began = clock.now();
  const double processor_s_before = Supervisor::processor_seconds();  // of whatever built us in this process
  bool link_shown = false;
  while (!episode.is_over()) {
    laptop.wait(std::chrono::milliseconds{200});
    episode.step();
    check_processes(supervisor);
    if (options.play && !link_shown && fs::exists(folder.participant_link)) {
      screen.say("Open on your phone, or in a browser here: " + read_file(folder.participant_link));
      link_shown = true;
    }
    screen.show(episode.view(), clock.now());
    if (stop_requested()) episode.abort("interrupted");
  }
  screen.finish(episode.view());
  // The end of the session and the last belief still have to reach the recorders.
  clock.wait_until(clock.now() + std::chrono::seconds{1}, [] { return false; });
  const double elapsed_s = to_seconds(clock.now() - began);
  supervisor.stop_all(std::chrono::seconds{20});
  const double cores = (Supervisor::processor_seconds() - processor_s_before) / elapsed_s;

  write_file_atomically(run.recording_folder / (run.recording_name + ".png"), picture_of(episode.view()));
  const auto report = report_of(episode, run, scenario, cores);
  if (!options.json_file.empty()) write_file_atomically(options.json_file, report.dump(2) + "\n");
  screen.report(episode.view(), episode.reason(), report["recording"], report["picture"], cores);
  if (stop_requested()) throw Interrupted();
  if (episode.phase() != Episode::Phase::Found) throw Failed();
}

/// The services of this host, until Ctrl-C.
void run_services(const UpOptions& options) {
  const fs::path config = options.config.empty() ? "/etc/tandem" : options.config;
  const auto site = load_config<SiteConfig>(config / "site.toml");
  Supervisor supervisor;
  for (const auto& process : processes_of(site.host, services_of(site.role), program_folder(), config,
                                          fs::path{options.output} / "run.d" / "logs")) {
    if (is_wanted(options.only, process.name.substr(process.name.find('/') + 1))) supervisor.start(process);
  }
  std::fprintf(stderr, "tandem: the services of %s run; logs are in %s/run.d/logs; Ctrl-C ends them\n",
               site.host.c_str(), options.output.c_str());
  SteadyClock clock;
  while (!stop_requested()) {
    check_processes(supervisor);
    clock.wait_until(clock.now() + std::chrono::milliseconds{200}, stop_requested);
  }
  supervisor.stop_all(std::chrono::seconds{20});
}

}  // namespace

void add_up_command(CLI::App& tandem) {
  auto options = std::make_shared<UpOptions>();
  auto* command = add_command(tandem, "up", "Run the services of this host, or a whole search on simulated hardware",
                              "tandem up --simulate brl --seed 3");
  command->add_option("--config", options->config, "Folder with site.toml and one TOML file per service");
  command->add_option("--only", options->only, "Start these services alone")->delimiter(',');
  command->add_option("--simulate", options->scenario, "Play this scenario: a name, or a JSON file");
  command->add_option("--map", options->map, "A map_server YAML file instead of the scenario's own");
  command->add_option("--seed", options->seed, "Decides where the object lies, and all noise")->capture_default_str();
  command->add_flag("--play", options->play, "You are the person: pair your phone or browser");
  command->add_flag("--headless", options->headless, "Lines instead of a live picture");
  command->add_option("--limit-s", options->limit_s, "Give up after so many seconds (default: the scenario's)");
  command->add_option("--json", options->json_file, "Write the result to this file");
  command->add_option("--output", options->output, "Folder for recording, picture and run.d")->capture_default_str();
  command->callback([options] { options->scenario.empty() ? run_services(*options) : simulate(*options); });
}

}  // namespace tandem::cli
