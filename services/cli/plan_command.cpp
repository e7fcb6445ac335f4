#include "services/cli/plan_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "services/cli/command.hpp"
#include "services/cli/plan/plan_report.hpp"
#include "services/cli/plan/plan_run.hpp"
#include "services/cli/progress.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/planner/remote/named_planner.hpp"

namespace tandem::cli {
namespace {

struct PlanOptions {
  std::string scenario;
  PlanRequest request;
  std::string picture;
  bool json = false;
};

void check_planner(const PlanningScenario& scenario, const std::string& planner) {
  if (!scenario.search && planner != "tandem") {
    throw WrongUse{"plan: " + scenario.name + " is a task without a search, which only the planner 'tandem' plans"};
  }
  if (is_other_program(planner)) return;
  try {
    (void)named_planner(planner, 0.0);
  } catch (const ConfigError& error) {
    throw WrongUse{std::string{"plan: "} + error.what() + ", exec:COMMAND"};
  }
}

PlannedScenario planned(const PlanningScenario& scenario, const PlanOptions& options) {
  Progress progress{"plan"};
  try {
    return plan_scenario(scenario, options.request, [&progress](double share) {
      progress.show(share);
      return !stop_requested();
    });
  } catch (const ConfigError& error) {
    throw ConfigError(options.scenario + ": " + error.what());
  }
}

void run(const PlanOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  const PlanningScenario scenario = load_planning_scenario(options.scenario);
  check_planner(scenario, options.request.planner);
  const PlannedScenario plan = planned(scenario, options);
  if (stop_requested()) throw Interrupted{};
  if (!options.picture.empty()) {
    write_file_atomically(options.picture, svg_of(picture_of(scenario, options.request, plan)));
  }
  const std::string text =
      options.json ? plan_json(scenario, options.request, plan) : plan_text(scenario, options.request, plan);
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_plan_command(CLI::App& tandem) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App* command = add_command(tandem, "plan", "Plan a search or a task for a team, once, and show the plan",
                                  "tandem plan config/scenarios/tasks/supermarket.json --rollouts 2000 "
                                  "--picture supermarket.svg");
  command->add_option("SCENARIO", options->scenario, "A file as config/scenarios/planning.schema.json describes it")
      ->required();
  command
      ->add_option("--planner", options->request.planner,
                   "Planner by name, perhaps with options, or exec:COMMAND (docs/planner_protocol.md)")
      ->capture_default_str();
  auto* budget = command
                     ->add_option("--budget-ms", options->request.budget_ms,
                                  "Processor time of the plan [ms], its preparation apart")
                     ->check(CLI::Range(0.1, 3600000.0))
                     ->capture_default_str();
  command->add_option("--rollouts", options->request.rollouts, "Rollouts of the plan instead; 0: the first plan")
      ->check(CLI::Range(0, 1000000000))
      ->excludes(budget);
  command->add_option("--seed", options->request.seed, "Of all random draws")->capture_default_str();
  command->add_flag("--json", options->json, "As JSON");
  command->add_option("--picture", options->picture, "Write a picture here, as SVG");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
