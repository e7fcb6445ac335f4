#include "bench/planning/scores/scores_command.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench/planning/records/resumable.hpp"
#include "bench/planning/scores/frozen_score.hpp"
#include "services/common/file_io.hpp"
#include "services/common/stop_signal.hpp"
#include "services/planner/core/planners/registry.hpp"

namespace tandem::bench {
namespace {

struct ScoresArguments {
  std::string folder = "bench/planning/scenarios";
  std::vector<std::string> planners;
  bool write = false;
  int threads = 1;
};

std::vector<FrozenScore> made(const std::vector<std::string>& planners, const ScoresArguments& arguments,
                              const StopSignal& stop) {
  std::vector<FrozenScoreRequest> requests;
  for (const std::string& scenario : frozen_scenarios(arguments.folder)) {
    for (const std::string& planner : planners) requests.push_back(frozen_score_request(scenario, planner));
  }
  return resumed<FrozenScore>(requests, made_frozen_score,
                              [](const FrozenScore& score, std::size_t left) {
                                std::fprintf(stderr, "%-8s %-32s %9.2f s, %zu to go\n", score.key.scenario.c_str(),
                                             score.key.planner.c_str(), score.search_s, left);
                              },
                              {{}, arguments.threads, [&] { return stop.requested(); }});
}

int show_scores(const ScoresArguments& arguments) {
  const StopSignal stop;
  const auto file = std::filesystem::path{arguments.folder} / "scores.jsonl";
  std::vector<FrozenScore> scores;
  if (arguments.write) {
    scores = made(planner_names(), arguments, stop);
    if (stop.requested()) return 130;
    std::string lines;
    for (const FrozenScore& score : scores) lines += to_line(score) + '\n';
    write_file_atomically(file, lines);
  } else {
    scores = read_lines<FrozenScore>(file);
  }
  std::vector<std::string> others;  // not among those that are kept
  for (const std::string& planner : arguments.planners) {
    if (std::ranges::find(scores, planner, [](const FrozenScore& score) { return score.key.planner; }) == scores.end())
      others.push_back(planner);
  }
  const auto more = made(others, arguments, stop);
  scores.insert(scores.end(), more.begin(), more.end());
  std::printf("%s", score_table(scores, "tandem").c_str());
  return stop.requested() ? 130 : 0;
}

}  // namespace

void add_scores_command(CLI::App& app, std::function<int()>& chosen) {
  auto arguments = std::make_shared<ScoresArguments>();  // shared: the command's callback outlives this function
  auto* command = app.add_subcommand("scores", "How planners do on the frozen scenarios");
  command->add_option("--planner", arguments->planners,
                      "Also this planner, NAME[:key=value,...] or exec:COMMAND; as often as there are planners");
  command->add_flag("--write", arguments->write, "Compute the scores of all our planners anew, and keep them");
  command->add_option("--scenarios", arguments->folder, "Folder of the scenarios and of scores.jsonl")
      ->capture_default_str();
  command->add_option("--threads", arguments->threads)->check(CLI::Range(1, 64))->capture_default_str();
  command->callback([arguments, &chosen] { chosen = [arguments] { return show_scores(*arguments); }; });
}

}  // namespace tandem::bench
