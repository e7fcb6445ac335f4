#include "bench/planning/first_command.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "bench/planning/loop/first_plan.hpp"
#include "bench/planning/loop/run_plan.hpp"
#include "services/common/stop_signal.hpp"

namespace tandem::bench {
namespace {

struct FirstArguments {
  std::vector<std::string> families{"S1u"};
  std::string seeds = "1:6";
  std::vector<std::string> planners{"tandem"};
  std::vector<double> budgets_ms{50.0, 200.0, 1000.0};
};

/// One line for each plan, and for each planner the geometric mean over the instances of a family.
void print_first_plans(const FirstArguments& arguments, const std::string& family, const std::string& planner,
                       const StopSignal& stop) {
  std::vector<double> log_sums(arguments.budgets_ms.size(), 0.0);
  int count = 0;
  for (const std::uint64_t seed : parse_seeds(arguments.seeds)) {
    if (stop.requested()) return;
    const FirstPlanRecord first = made_first_plan({{family, seed, planner, 1}, arguments.budgets_ms});
    std::printf("%-8s %8llu %-40s first %7.1f ms %9.2f s;", family.c_str(), static_cast<unsigned long long>(seed),
                planner.c_str(), first.first_plan_ms, first.first_value_s);
    for (std::size_t i = 0; i < first.values_s.size(); ++i) {
      std::printf(" %9.2f", first.values_s[i]);
      log_sums[i] += std::log(first.values_s[i]);
    }
    std::printf("\n");
    std::fflush(stdout);
    ++count;
  }
  std::printf("%-8s     mean %-40s                            ", family.c_str(), planner.c_str());
  for (const double sum : log_sums) std::printf(" %9.2f", std::exp(sum / count));
  std::printf("\n");
}

int run(const FirstArguments& arguments) {
  const StopSignal stop;
  for (const std::string& family : arguments.families) {
    for (const std::string& planner : arguments.planners) print_first_plans(arguments, family, planner, stop);
  }
  return stop.requested() ? 130 : 0;
}

}  // namespace

void add_first_command(CLI::App& app, std::function<int()>& chosen) {
  auto arguments = std::make_shared<FirstArguments>();  // shared: the command's callback outlives this function
  auto* command = app.add_subcommand("first", "First plans, and how they get better with time: to tune options by");
  command->add_option("--family", arguments->families, "Families of instances")->delimiter(',')->capture_default_str();
  command->add_option("--seeds", arguments->seeds, "Instances: 1:6 or 1,4,7:9")->capture_default_str();
  command->add_option("--planner", arguments->planners, "NAME[:key=value,...], as often as there are planners")
      ->capture_default_str();
  command->add_option("--budget-ms", arguments->budgets_ms, "Processor times at which a plan is asked for, ascending")
      ->delimiter(',')
      ->capture_default_str();
  command->callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace tandem::bench
