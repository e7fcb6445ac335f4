#include "bench/planning/all_command.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/planning/records/resumable.hpp"
#include "bench/planning/report/campaign.hpp"
#include "bench/planning/report/report.hpp"
#include "bench/planning/report/run_info.hpp"
#include "services/common/file_io.hpp"
#include "services/common/stop_signal.hpp"

namespace tandem::bench {
namespace {

struct AllArguments {
  CampaignOptions campaign;
  std::string output;
  int threads = 2;
};

int run_all(const AllArguments& arguments) {
  const std::filesystem::path output = arguments.output;
  std::filesystem::create_directories(output);
  const StopSignal stop;
  const Campaign campaign = campaign_of(arguments.campaign);
  const auto control = [&](const char* file, int threads) {
    return RunControl{output / file, threads, [&] { return stop.requested(); }};
  };
  Results results;
  PartProgress figures("figures");  // one at a time: they measure speed and memory
  results.micro = resumed<MicroRecord>(
      campaign.micro, measured,
      [&](const MicroRecord& record, std::size_t left) { figures.show(record.key.measure, left); },
      control("micro.jsonl", 1));
  PartProgress first_plans("first plans");
  results.first_plans = resumed<FirstPlanRecord>(
      campaign.first_plans, made_first_plan,
      [&](const FirstPlanRecord& record, std::size_t left) {
        first_plans.show(record.key.family + " " + record.key.planner, left);
      },
      control("first_plans.jsonl", arguments.threads));
  PartProgress tasks("tasks");
  results.tasks = resumed<TaskRecord>(
      campaign.tasks, made_task_run,
      [&](const TaskRecord& record, std::size_t left) { tasks.show("seed " + std::to_string(record.key.seed), left); },
      control("tasks.jsonl", arguments.threads));
  PartProgress searches("searches");
  results.runs = resumed<RunRecord>(
      campaign.runs, made_run,
      [&](const RunRecord& record, std::size_t left) {
        searches.show(record.key.family + " " + record.key.planner + " " + record.key.budget, left);
      },
      control("runs.jsonl", arguments.threads));
  std::string command = "./run bench planning";
  if (arguments.campaign.quick) command += " --quick";
  for (const int row : arguments.campaign.rows) command += " --rows " + std::to_string(row);
  if (arguments.campaign.first_seed != 1) command += " --first-seed " + std::to_string(arguments.campaign.first_seed);
  for (const auto& [name, content] : report_files(results, report_head(command))) {
    write_file_atomically(output / name, content);
  }
  std::printf("%s\nThe report is %s.\n", target_table(results).c_str(), (output / "REPORT.md").c_str());
  if (stop.requested()) std::printf("Stopped early; the same command goes on.\n");
  return stop.requested() ? 130 : 0;
}

}  // namespace

void add_all_command(CLI::App& app, std::function<int()>& chosen) {
  auto arguments = std::make_shared<AllArguments>();  // shared: the command's callback outlives this function
  auto* command = app.add_subcommand("all", "Everything, and a report; goes on where it was stopped");
  command->add_flag("--quick", arguments->campaign.quick, "Few instances: at most 10 minutes on two cores");
  command->add_option("--rows", arguments->campaign.rows, "Only what these rows of the targets need")->delimiter(',');
  command
      ->add_option("--first-seed", arguments->campaign.first_seed,
                   "Of the instances; 1000001: nothing was tuned on them")
      ->capture_default_str();
  command->add_option("--ablation", arguments->campaign.ablations, "Options of tandem that switch a part off, often");
  command->add_option("--threads", arguments->threads)->check(CLI::Range(1, 64))->capture_default_str();
  command->add_option("--output", arguments->output, "Folder of results and report")->required();
  command->callback([arguments, &chosen] { chosen = [arguments] { return run_all(*arguments); }; });
}

}  // namespace tandem::bench
