#include "services/cli/study_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <thread>

#include "services/cli/command.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/scenario_files.hpp"
#include "services/cli/study/study_run.hpp"
#include "services/cli/up/run_folder.hpp"
#include "services/common/file_io.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/mapping/core/sha256.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct StudyOptions {
  std::string scenario = "brl";
  std::string config;
  std::string planner;
  std::string human = "obedient";
  std::uint64_t episodes = 20;
  std::uint64_t seed = 1;
  double budget_ms = 0.0;
  std::int64_t rollouts = -1;
  double limit_s = 0.0;
  unsigned threads = 0;
  std::string output;
  bool record = false;
  bool json = false;
  bool csv = false;
};

constexpr std::int64_t kNoLimit = 1'000'000;  ///< of rollouts, where time is the limit

StudyPlan plan_of(const StudyOptions& options) {
  const fs::path root = options.config.empty() ? default_config_root() : fs::path{options.config};
  const auto scenario = simulator::load_scenario(scenario_file(options.scenario, root));
  StudyPlan plan{.scenario = scenario, .map = load_map(scenario.map_file), .team = {}};
  plan.team.planner = load_config<PlannerConfig>(root / "simulation" / "laptop" / "planner.toml");
  plan.team.navigator = load_config<navigator::NavigatorConfig>(root / "simulation" / "robot" / "navigator.toml");
  plan.team.tracking = load_config<tracking::TrackingConfig>(root / "simulation" / "robot" / "tracker.toml");
  if (!options.planner.empty()) plan.team.planner.planner = options.planner;
  try {
    (void)make_planner(plan.team.planner.planner);
  } catch (const ConfigError& error) {
    throw WrongUse{std::string{"study: "} + error.what()};
  }
  if (options.rollouts >= 0) plan.team.planner.rollouts = options.rollouts;
  if (options.budget_ms > 0.0) plan.team.planner.rollouts = kNoLimit;
  if (options.limit_s > 0.0) plan.scenario.limit_s = options.limit_s;
  plan.human = options.human;
  plan.seed = options.seed;
  plan.episodes = options.episodes;
  plan.budget_ms = options.budget_ms;
  if (options.record) plan.recordings = fs::path{options.output} / "recordings";
  plan.threads = options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  return plan;
}

/// Names everything that makes the episodes what they are, but planner, human, seeds and budget.
std::string hash_of(const StudyPlan& plan) {
  PlannerConfig planner = plan.team.planner;
  planner.planner.clear();
  planner.rollouts = 0;
  const auto& scenario = plan.scenario;
  std::string text = write_config(planner) + write_config(plan.team.navigator) + write_config(plan.team.tracking) +
                     read_file(scenario.map_file) + scenario.name;
  for (const double value :
       {scenario.robot_start.x, scenario.robot_start.y, scenario.robot_start.heading, scenario.person_start.x,
        scenario.person_start.y, scenario.person_start.heading, scenario.tokens_min_distance_m, scenario.limit_s}) {
    text += " " + std::to_string(value);
  }
  if (scenario.tokens_in_map) {
    text += " at " + std::to_string(scenario.tokens_in_map->x()) + " " + std::to_string(scenario.tokens_in_map->y());
  }
  text += " " + std::to_string(scenario.passers_by) + " ";
  for (const CellState cell : plan.map.cells()) text += static_cast<char>('0' + static_cast<int>(cell));
  return sha256_hex(text).substr(0, 16);
}

void print_text(const StudyPlan& plan, const experiment::StudySettings& settings,
                std::span<const experiment::EpisodeResult> episodes) {
  const auto summary = experiment::summary_of(episodes);
  std::printf("%s, planner %s, human %s, seeds %llu to %llu: found %zu of %zu\n", settings.scenario.c_str(),
              settings.planner.c_str(), settings.human.c_str(), static_cast<unsigned long long>(plan.seed),
              static_cast<unsigned long long>(plan.seed + plan.episodes - 1), summary.found, summary.episodes);
  std::printf("time %.1f s (95 %%: %.1f to %.1f); explored at the find %.1f %% (robot %.1f %%, human %.1f %%)\n",
              summary.time_s.mean, summary.time_s.low, summary.time_s.high, 100.0 * summary.explored_at_find,
              100.0 * summary.explored_robot, 100.0 * summary.explored_human);
  std::printf("%.2f stops and %.2f near collisions an episode, %d collisions; robot idle for at most %.1f s\n",
              summary.stops, summary.near_collisions, summary.collisions, summary.longest_idle_s);
  std::printf("messages a minute:");
  for (const auto& [kind, count] : summary.messages_per_min) std::printf(" %s %.1f", kind.c_str(), count);
  std::printf("; roles:");
  for (const auto& [role, share] : summary.role_shares) std::printf(" %s %.0f %%", role.c_str(), 100.0 * share);
  std::printf("\n");
}

void run(const StudyOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  if (options.record && options.output.empty()) throw WrongUse{"study: --record needs --output, a folder for them"};
  if (options.json && options.csv) throw WrongUse{"study: --json or --csv, not both"};
  if (options.budget_ms > 0.0 && options.rollouts >= 0) throw WrongUse{"study: --budget-ms or --rollouts, not both"};
  const auto& humans = experiment::human_names();
  if (std::ranges::find(humans, options.human) == humans.end()) {
    std::string names;
    for (const auto& name : humans) names += (names.empty() ? "" : ", ") + name;
    throw WrongUse{"study: no human '" + options.human + "'; there are: " + names};
  }
  const StudyPlan plan = plan_of(options);
  const experiment::StudySettings settings{.scenario = plan.scenario.name,
                                           .planner = plan.team.planner.planner,
                                           .human = plan.human,
                                           .seed = plan.seed,
                                           .rollouts = plan.team.planner.rollouts,
                                           .budget_ms = plan.budget_ms,
                                           .config_hash = hash_of(plan)};
  if (!options.output.empty()) fs::create_directories(options.output);
  if (options.record) fs::create_directories(plan.recordings);
  StudyFile file =
      options.output.empty() ? StudyFile{settings} : StudyFile{settings, fs::path{options.output} / "episodes.jsonl"};
  {
    Progress progress{"study"};
    play_study(plan, file, [&](std::uint64_t finished) {
      progress.show(static_cast<double>(finished) / static_cast<double>(plan.episodes),
                    std::to_string(finished) + " of " + std::to_string(plan.episodes) + " episodes");
      return !stop_requested();
    });
  }
  const auto episodes = file.episodes(plan.seed, plan.episodes);
  if (episodes.size() < plan.episodes) {
    if (!options.output.empty()) {
      std::fprintf(stderr, "tandem: %zu of %llu episodes are kept in %s; the same command goes on\n", episodes.size(),
                   static_cast<unsigned long long>(plan.episodes), options.output.c_str());
    }
    throw Interrupted{};
  }
  const std::string json = experiment::study_json(settings, episodes) + "\n";
  if (!options.output.empty()) {
    write_file_atomically(fs::path{options.output} / "study.json", json);
    write_file_atomically(fs::path{options.output} / "study.csv", experiment::study_csv(episodes));
  }
  if (options.json) {
    std::fputs(json.c_str(), stdout);
  } else if (options.csv) {
    std::fputs(experiment::study_csv(episodes).c_str(), stdout);
  } else {
    print_text(plan, settings, episodes);
  }
}

}  // namespace

void add_study_command(CLI::App& tandem) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command = add_command(tandem, "study", "Play whole searches in process and say how they went",
                                  "tandem study --scenario brl --planner tandem --human obedient --episodes 100 "
                                  "--seed 1 --output results --json");
  command->add_option("--scenario", options->scenario, "A name, or a JSON file")->capture_default_str();
  command->add_option("--config", options->config, "Folder with scenarios/ and simulation/");
  command->add_option("--planner", options->planner, "Planner by name, perhaps with options (default: of the config)");
  command->add_option("--human", options->human, "obedient, late, own, stubborn, random or announces")
      ->capture_default_str();
  command->add_option("--episodes", options->episodes, "How many")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seed", options->seed, "Seed of the first episode; the next ones follow")
      ->capture_default_str();
  command->add_option("--budget-ms", options->budget_ms, "Processor time of each plan [ms]")
      ->check(CLI::Range(0.1, 600000.0));
  command->add_option("--rollouts", options->rollouts, "Rollouts of each plan (default: of the config)")
      ->check(CLI::Range(0, 1000000));
  command->add_option("--limit-s", options->limit_s, "Give up after so many seconds (default: the scenario's)")
      ->check(CLI::Range(1.0, 36000.0));
  command->add_option("--threads", options->threads, "Episodes at a time (default: one a processor core)")
      ->check(CLI::Range(1, 256));
  command->add_option("--output", options->output,
                      "Folder for episodes.jsonl, study.json, study.csv; a run goes on there");
  command->add_flag("--record", options->record,
                    "Records each episode in the folder recordings of --output, for tandem report");
  command->add_flag("--json", options->json, "As JSON");
  command->add_flag("--csv", options->csv, "The episodes as CSV");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
