#include "services/cli/report_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "services/cli/command.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/report/episode_reader.hpp"
#include "services/cli/report/report_page.hpp"
#include "services/common/file_io.hpp"
#include "services/experiment/core/report/report_csv.hpp"
#include "services/experiment/core/report/report_json.hpp"

namespace tandem::cli {
namespace {

namespace fs = std::filesystem;

struct ReportCommandOptions {
  std::vector<std::string> files;
  std::string output = "report.html";
  std::string csv;
  std::string title;
  experiment::ReportOptions report;
  bool without_replay = false;
  bool json = false;
};

/// The recordings that `files` name; a folder stands for those in it.
std::vector<fs::path> recordings_in(const std::vector<std::string>& files) {
  std::vector<fs::path> recordings;
  for (const fs::path file : files) {
    if (!fs::is_directory(file)) {
      recordings.push_back(file);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::directory_iterator(file)) {
      if (entry.path().extension() == ".mcap") inside.push_back(entry.path());
    }
    if (inside.empty()) throw std::runtime_error(file.string() + ": no .mcap file in this folder");
    std::ranges::sort(inside);
    recordings.insert(recordings.end(), inside.begin(), inside.end());
  }
  return recordings;
}

std::vector<experiment::EpisodeLog> read_all(const std::vector<fs::path>& recordings) {
  std::vector<experiment::EpisodeLog> episodes;
  Progress progress{"report"};
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const std::string file = recordings[i].string();
    mcap::Reader recording{mcap::file_source(file), file};
    auto some = read_episodes(recording, recordings[i].stem().string(), [&](double share) {
      progress.show((static_cast<double>(i) + share) / static_cast<double>(recordings.size()),
                    std::to_string(i + 1) + " of " + std::to_string(recordings.size()) + " recordings");
      return !stop_requested();
    });
    if (stop_requested()) throw Interrupted{};
    for (const std::string& damage : recording.damages()) {
      std::fprintf(stderr, "tandem: %s: damaged: %s\n", file.c_str(), damage.c_str());
    }
    if (some.empty()) std::fprintf(stderr, "tandem: %s: left out, no session ran in it\n", file.c_str());
    for (auto& episode : some) {
      const auto same = std::ranges::find_if(
          episodes, [&](const experiment::EpisodeLog& known) { return experiment::is_same_search(known, episode); });
      if (same == episodes.end()) {
        episodes.push_back(std::move(episode));
      } else {
        *same = experiment::merged(std::move(*same), std::move(episode));
      }
    }
  }
  return episodes;
}

void write_csv(const fs::path& folder, const std::vector<experiment::EpisodeLog>& episodes,
               const experiment::Report& report) {
  fs::create_directories(folder);
  write_file_atomically(folder / "episodes.csv", experiment::episodes_csv(episodes, report));
  write_file_atomically(folder / "progress.csv", experiment::progress_csv(report));
  write_file_atomically(folder / "my_pose.csv", experiment::my_pose_csv(report));
  write_file_atomically(folder / "comparisons.csv", experiment::comparisons_csv(report));
}

void run(const ReportCommandOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  const auto recordings = recordings_in(options.files);
  const auto episodes = read_all(recordings);
  if (episodes.empty()) throw std::runtime_error("no session ran in any of these recordings: nothing to report");
  experiment::Report report;
  try {
    report = experiment::make_report(episodes, options.report);
  } catch (const std::invalid_argument& error) {
    throw WrongUse{std::string{"report: "} + error.what()};
  }
  const std::string title = !options.title.empty() ? options.title
                            : episodes.size() == 1 ? "Search " + episodes.front().code
                                                   : std::to_string(episodes.size()) + " searches";
  const auto json_of = [&](bool with_replay) {
    return experiment::report_json(episodes, report, {.title = title, .with_replay = with_replay});
  };
  if (!options.csv.empty()) write_csv(options.csv, episodes, report);
  if (options.json) {
    std::puts(json_of(false).c_str());
    return;
  }
  const std::string page = report_page(json_of(!options.without_replay));
  write_file_atomically(options.output, page);
  const auto found = std::ranges::count_if(episodes, &experiment::EpisodeLog::found);
  std::printf("%s: %zu episodes, found in %td, %zu kB\n", options.output.c_str(), episodes.size(), found,
              page.size() / 1000);
}

}  // namespace

void add_report_command(CLI::App& tandem) {
  const auto options = std::make_shared<ReportCommandOptions>();
  CLI::App* command =
      add_command(tandem, "report", "Figures and numbers of recorded searches, as one HTML page and CSV files",
                  "tandem report study/*.mcap --by condition -o report.html --csv tables");
  command->add_option("RECORDING", options->files, "Recordings (.mcap), or folders of them")
      ->required()
      ->check(CLI::ExistingPath);
  command->add_option("-o,--output", options->output, "The page")->capture_default_str();
  command->add_option("--csv", options->csv, "Folder for episodes.csv, progress.csv, my_pose.csv, comparisons.csv");
  command->add_option("--title", options->title, "Title of the page");
  command->add_option("--by", options->report.by,
                      "Splits the episodes by this: condition, reminder, mode, or a question of the form");
  command->add_option("--pair", options->report.pair,
                      "Question that is answered alike by whoever belongs together: groups are then compared in pairs");
  command->add_option("--threshold", options->report.threshold_s, "Longest time between My pose messages [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--baseline", options->report.baseline,
                      "Group to whose share of messages within the threshold those of the others are matched");
  command->add_option("--step", options->report.step_s, "Step of the lines over time [s]")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--without-replay", options->without_replay, "A smaller page, without the episodes to play");
  command->add_flag("--json", options->json, "The numbers as JSON on standard output instead of the page");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
