#include "bench/planning/run_command.hpp"

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/planning/instance/scenario_file.hpp"
#include "bench/planning/loop/run_plan.hpp"
#include "bench/planning/records/resumable.hpp"
#include "bench/planning/statistics/statistics.hpp"
#include "services/common/file_io.hpp"
#include "services/common/stop_signal.hpp"

namespace tandem::bench {
namespace {

struct RunArguments {
  std::vector<std::string> families{"S1u"};
  std::string seeds = "1:6";
  std::vector<std::string> planners{"greedy15"};
  std::string budgets = "200";
  std::string baseline;
  std::string results;
  int threads = 1;
};

void print_head() {
  std::printf("%-12s %8s %-28s %-8s %8s %7s %7s %7s %7s %7s %6s %6s %5s\n", "family", "seed", "planner", "budget",
              "E[T] s", "T95 s", "bound", "left", "first", "p95 ms", "plans", "overl", "fallb");
}

void print_record(const RunRecord& r) {
  std::printf("%-12s %8llu %-28s %-8s %8.2f %7.1f %7.1f %7.1e %7.1f %7.1f %6d %6.2f %5d\n", r.key.family.c_str(),
              static_cast<unsigned long long>(r.key.seed), r.key.planner.c_str(), r.key.budget.c_str(),
              r.expected_time_s, r.found95_s, r.first_bound_s, r.probability_left, r.first_plan_ms, r.replan_p95_ms,
              r.replans, r.overlap, r.fallbacks);
  std::fflush(stdout);
}

/// The mean of each planner and its ratio to the baseline, instance by instance.
void print_summary(const std::vector<RunRecord>& records, const std::string& baseline) {
  std::map<std::pair<std::string, std::string>,
           std::map<std::pair<std::string, std::string>, std::map<std::uint64_t, double>>>
      by_case;  // (family, budget) -> (planner) -> seed -> E[T]
  for (const RunRecord& r : records) {
    by_case[{r.key.family, r.key.budget}][{r.key.planner, ""}][r.key.seed] = r.expected_time_s;
  }
  for (const auto& [which, planners] : by_case) {
    std::printf("\n%s at %s: ratio to %s, with its 95 %% interval\n", which.first.c_str(), which.second.c_str(),
                baseline.c_str());
    const auto base = planners.find({baseline, ""});
    for (const auto& [planner, values] : planners) {
      std::vector<double> ours;
      std::vector<double> theirs;
      double sum_s = 0.0;
      for (const auto& [seed, value] : values) {
        sum_s += value;
        if (base == planners.end() || !base->second.contains(seed)) continue;
        ours.push_back(value);
        theirs.push_back(base->second.at(seed));
      }
      const PairedComparison c = compared(ours, theirs, Rng{1});
      std::printf(
          "  %-32s n=%-3zu mean E[T] %8.2f s  ratio %.4f [%.4f, %.4f]  worst %.3f  win/tie/loss %d/%d/%d  p=%.3g\n",
          planner.first.c_str(), values.size(), sum_s / static_cast<double>(values.size()), c.ratio.value, c.ratio.low,
          c.ratio.high, c.worst, c.wins, c.ties, c.losses, c.p);
    }
  }
}

int run(const RunArguments& arguments) {
  const auto requests =
      all_runs(arguments.families, parse_seeds(arguments.seeds), arguments.planners, parse_budgets(arguments.budgets));
  const StopSignal stop;
  print_head();
  const auto records =
      resumed<RunRecord>(requests, made_run, [](const RunRecord& record, std::size_t) { print_record(record); },
                         {arguments.results, arguments.threads, [&] { return stop.requested(); }});
  print_summary(records, arguments.baseline.empty() ? arguments.planners.front() : arguments.baseline);
  return stop.requested() ? 130 : 0;
}

}  // namespace

void add_run_command(CLI::App& app, std::function<int()>& chosen) {
  auto arguments = std::make_shared<RunArguments>();  // shared: the command's callback outlives this function
  auto* command = app.add_subcommand("run", "Searches with planners in the loop; see docs/planner.md");
  command->add_option("--family", arguments->families, "Families of instances")->delimiter(',')->capture_default_str();
  command->add_option("--seeds", arguments->seeds, "Instances: 1:6 or 1,4,7:9")->capture_default_str();
  command->add_option("--planner", arguments->planners, "NAME[:key=value,...], as often as there are planners")
      ->capture_default_str();
  command->add_option("--budget-ms", arguments->budgets, "Processor time of each plan, 50,200; or rollouts, 500r")
      ->capture_default_str();
  command->add_option("--baseline", arguments->baseline, "Planner that the others are compared to; else the first");
  command->add_option("--results", arguments->results, "File to append to; what it holds is not run again");
  command->add_option("--threads", arguments->threads)->check(CLI::Range(1, 64))->capture_default_str();
  command->callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

void add_freeze_command(CLI::App& app, std::function<int()>& chosen) {
  struct Arguments {
    std::vector<std::string> families{"S1u"};
    std::string seeds = "1";
    std::string output;
  };
  auto arguments = std::make_shared<Arguments>();  // shared: as above
  auto* command = app.add_subcommand("freeze", "Writes instances as planning scenarios, FAMILY_SEED.json");
  command->add_option("--family", arguments->families, "Families of instances")->delimiter(',')->capture_default_str();
  command->add_option("--seeds", arguments->seeds, "Instances: 1:6 or 1,4,7:9")->capture_default_str();
  command->add_option("--output", arguments->output, "Folder")->required();
  command->callback([arguments, &chosen] {
    chosen = [arguments] {
      for (const auto& family : arguments->families) {
        for (const std::uint64_t seed : parse_seeds(arguments->seeds)) {
          const auto file = std::filesystem::path(arguments->output) / (family + "_" + std::to_string(seed) + ".json");
          write_file_atomically(file, scenario_json(instance_of(family, seed)));
          std::printf("%s\n", file.c_str());
        }
      }
      return 0;
    };
  });
}

}  // namespace tandem::bench
