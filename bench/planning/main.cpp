// tandem-bench-planning: how good the planners are, and how fast; see docs/planner.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

#include "bench/planning/all_command.hpp"
#include "bench/planning/first_command.hpp"
#include "bench/planning/instance/families.hpp"
#include "bench/planning/run_command.hpp"
#include "bench/planning/scores/scores_command.hpp"
#include "services/planner/core/planners/registry.hpp"

int main(int argc, char** argv) {
  using namespace tandem::bench;
  CLI::App app{"The planning benchmark"};
  app.require_subcommand(1);
  std::function<int()> chosen;
  add_run_command(app, chosen);
  add_first_command(app, chosen);
  add_all_command(app, chosen);
  add_freeze_command(app, chosen);
  add_scores_command(app, chosen);
  app.add_subcommand("families", "Lists the families of instances")->callback([&] {
    chosen = [] {
      for (const FamilySpec& family : families()) {
        std::printf("%-12s %s\n", std::string(family.name).c_str(), std::string(family.what).c_str());
      }
      return EXIT_SUCCESS;
    };
  });
  app.add_subcommand("planners", "Lists the planners")->callback([&] {
    chosen = [] {
      for (const std::string& name : tandem::planner_names()) std::printf("%s\n", name.c_str());
      return EXIT_SUCCESS;
    };
  });
  CLI11_PARSE(app, argc, argv);
  try {
    return chosen();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tandem-bench-planning: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
