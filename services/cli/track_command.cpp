#include "services/cli/track_command.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "services/cli/command.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/track/offline_tracking.hpp"
#include "services/common/config.hpp"
#include "services/recorder/core/carmen_log.hpp"

namespace tandem::cli {
namespace {

struct TrackOptions {
  std::string file;
  std::string truth;
  std::string config;
  bool json = false;
};

nlohmann::json number_or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::ordered_json report_of(const TrackingRun& run) {
  const double whole_ms = std::accumulate(run.scan_ms.begin(), run.scan_ms.end(), 0.0);
  nlohmann::ordered_json report;
  report["recall"] = number_or_null(run.people.recall());
  report["median_m"] = number_or_null(run.people.median_m());
  report["false_per_scan"] = run.people.false_per_moment();
  report["id_switches"] = run.people.id_switches();
  report["scan_ms"] =
      run.scan_ms.empty() ? nlohmann::json() : nlohmann::json(whole_ms / static_cast<double>(run.scan_ms.size()));
  report["scans"] = run.scan_ms.size();
  report["annotations"] = run.people.annotations();
  if (run.to_follow > 0) {
    report["followed_share"] = static_cast<double>(run.followed) / static_cast<double>(run.to_follow);
    report["followed_median_m"] = number_or_null(tracking::median_of(run.teammate_error_m));
    report["named"] = run.named;
  }
  return report;
}

void run(const TrackOptions& options) {
  std::ignore = stop_requested();  // from now on Ctrl-C ends it in order
  const auto config =
      options.config.empty() ? tracking::TrackingConfig{} : load_config<tracking::TrackingConfig>(options.config);
  std::vector<Annotation> truth;
  if (!options.truth.empty()) {
    truth = parse_annotations(carmen::read_log_file(options.truth), options.truth);
    if (truth.empty()) throw std::runtime_error(options.truth + ": no PERSON line");
  }
  mcap::Reader recording{mcap::file_source(options.file), options.file};
  Progress progress{"tracking"};
  const TrackingRun result = track_offline(recording, config, truth, [&](double share) {
    progress.show(share);
    return !stop_requested();
  });
  if (stop_requested()) throw Interrupted{};
  if (result.scan_ms.empty()) throw std::runtime_error(options.file + ": no scan in it could be used");
  const auto report = report_of(result);
  if (options.json) {
    std::puts(report.dump(2).c_str());
    return;
  }
  for (const auto& [key, value] : report.items()) std::printf("%-18s %s\n", key.c_str(), value.dump().c_str());
}

}  // namespace

void add_track_command(CLI::App& tandem) {
  const auto options = std::make_shared<TrackOptions>();
  CLI::App* command = add_command(tandem, "track", "Follow people in a recording's scans, and score it by annotations",
                                  "tandem track outdoor.mcap --truth outdoor.txt.gz --json");
  command->add_option("FILE", options->file, "Recording (.mcap) with scans")->required();
  command->add_option(
      "--truth", options->truth,
      "Lines of PERSON t id x y, in the laser's frame; plain or gzip. Without it every track counts as false");
  command->add_option("--config", options->config, "tracker.toml instead of the defaults");
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
