#include "services/cli/localize_command.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <span>

#include "services/cli/command.hpp"
#include "services/cli/offline_localization.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/truth.hpp"
#include "services/common/file_io.hpp"
#include "services/localization/core/trajectory_picture.hpp"
#include "services/mapping/core/map_file.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem::cli {
namespace {

struct LocalizeOptions {
  std::string file;
  std::string map;
  std::string config;
  std::string truth;
  double truth_offset_s = 0.0;
  std::vector<double> start;
  bool global = false;
  std::vector<std::string> exclude;
  std::string scans;
  std::optional<double> kidnap_s;
  std::optional<std::int64_t> seed;
  std::string trajectory;
  std::string picture;
  bool json = false;
};

TimeWindows parse_windows(const std::vector<std::string>& texts) {
  TimeWindows windows;
  for (const std::string& text : texts) {
    const std::size_t colon = text.find(':');
    try {
      if (colon == std::string::npos) throw std::invalid_argument{text};
      windows.emplace_back(std::stod(text.substr(0, colon)), std::stod(text.substr(colon + 1)));
    } catch (const std::logic_error&) {
      throw WrongUse{"localize: --exclude wants FROM:TO in seconds, as 180:206,300:360, and not " + text};
    }
  }
  return windows;
}

/// The config file, if one is given, with what the command line says on top.
LocalizationConfig config_of(const LocalizeOptions& options, const Truth& truth) {
  LocalizationConfig config;
  if (!options.config.empty()) config = load_config<LocalizationConfig>(options.config);
  if (!options.scans.empty()) config.scans = options.scans;
  if (options.seed) config.seed = *options.seed;
  if (options.global) {
    config.start.clear();
    config.start_globally = true;
  } else if (!options.start.empty()) {
    config.start = options.start;
  } else if (config.start.empty() && !truth.poses.empty()) {
    const Pose2& first = truth.poses.front().map_from_base;
    config.start = {first.x, first.y, first.heading};
  }
  return config;
}

/// Names the parameters, not the run: start, seed and choice of scans are left out.
std::string hash_of(LocalizationConfig config) {
  const LocalizationConfig plain;
  config.seed = plain.seed;
  config.scans = plain.scans;
  config.start = plain.start;
  config.start_globally = plain.start_globally;
  config.last_pose_file = plain.last_pose_file;
  return sha256_hex(write_config(config)).substr(0, 16);
}

nlohmann::ordered_json update_times(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return {{"mean", 0.0}, {"p95", 0.0}};
  std::sort(milliseconds.begin(), milliseconds.end());
  const auto count = static_cast<double>(milliseconds.size());
  return {{"mean", std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0) / count},
          {"p95", milliseconds[milliseconds.size() * 95 / 100]}};
}

nlohmann::ordered_json report_of(const LocalizeOptions& options, const Truth& truth, const LocalizationConfig& config,
                                 const OfflineResult& result) {
  const TrajectoryErrors errors =
      errors_of(result.poses, truth.poses, options.truth_offset_s, parse_windows(options.exclude));
  std::vector<TimedPose> poses;
  for (const EstimatedPose& estimate : result.poses) poses.push_back(estimate.pose);
  if (options.kidnap_s) poses.resize(result.before_kidnapping);  // those after it may be of the same time again
  const RelationErrors relations =
      relation_errors_of(sorted_by_time(std::move(poses)), truth.relations, options.truth_offset_s);
  const auto not_ok = std::count_if(result.poses.begin(), result.poses.end(), [](const EstimatedPose& estimate) {
    return estimate.status != LocalizationStatus::Ok;
  });
  nlohmann::ordered_json faults = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < kInputFaultNames.size(); ++i) {
    const auto count = result.faults.count(static_cast<InputFault>(i));
    if (count > 0) faults[kInputFaultNames[i]] = count;
  }
  return {
      {"recording", options.file},
      {"map", options.map},
      {"scans", result.poses.size()},
      {"compared", errors.compared},
      {"rmse_m", errors.rmse_m},
      {"rmse_deg", errors.rmse_deg},
      {"rmse_kept_m", errors.rmse_kept_m},
      {"median_m", errors.median_m},
      {"max_m", errors.max_m},
      {"lost_share", errors.lost_share},
      {"relations_m", {{"mean", relations.mean_m}, {"std", relations.deviation_m}, {"compared", relations.compared}}},
      {"update_ms", update_times(result.update_ms)},
      {"nees", errors.nees},
      {"status_wrong_share", errors.status_wrong_share},
      {"status_not_ok", not_ok},
      {"faults", faults},
      {"map_scale", result.map_scale},
      {"config_hash", hash_of(config)},
      {"seed", config.seed}};
}

nlohmann::ordered_json kidnapping_report(const LocalizeOptions& options, const Truth& truth,
                                         const Kidnapping& kidnapping, const OfflineResult& result) {
  const auto after = std::span{result.poses}.subspan(result.before_kidnapping);
  std::vector<double> way_m{result.way_m.begin() + static_cast<std::ptrdiff_t>(result.before_kidnapping),
                            result.way_m.end()};
  const double driven_before_m = result.before_kidnapping > 0 ? result.way_m[result.before_kidnapping - 1] : 0.0;
  for (double& way : way_m) way -= driven_before_m;
  const Recovery recovery = recovery_of(after, way_m, kidnapping.put_down_at, truth.poses, options.truth_offset_s);
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  return {{"lifted_at_s", to_seconds(kidnapping.lifted_at.time_since_epoch())},
          {"put_down_at_s", to_seconds(kidnapping.put_down_at.time_since_epoch())},
          {"flagged_s", number(recovery.flagged_s)},
          {"recovered_s", number(recovery.recovered_s)},
          {"recovered_m", number(recovery.recovered_m)},
          {"ok_but_wrong", recovery.ok_but_wrong}};
}

void print_text(const nlohmann::ordered_json& report) {
  std::printf("%zu scans, %.2f ms each\n", report["scans"].get<std::size_t>(),
              report["update_ms"]["mean"].get<double>());
  if (report["compared"] != 0) {
    std::printf("rmse %.3f m, %.2f deg; kept %.3f m; median %.3f m; largest %.2f m; lost %.2f %%\n",
                report["rmse_m"].get<double>(), report["rmse_deg"].get<double>(), report["rmse_kept_m"].get<double>(),
                report["median_m"].get<double>(), report["max_m"].get<double>(),
                100.0 * report["lost_share"].get<double>());
  }
  if (report["relations_m"]["compared"] != 0) {
    std::printf("relations %.3f m, deviation %.3f m\n", report["relations_m"]["mean"].get<double>(),
                report["relations_m"]["std"].get<double>());
  }
  for (const auto& [fault, count] : report["faults"].items()) {
    std::printf("bad input: %s, %llu times\n", fault.c_str(), count.get<unsigned long long>());
  }
  if (!report.contains("kidnap")) return;
  if (const auto& kidnap = report["kidnap"]; kidnap["recovered_s"].is_null()) {
    std::puts("kidnapped: not recovered");
  } else {
    std::printf("kidnapped: recovered after %.1f s and %.1f m\n", kidnap["recovered_s"].get<double>(),
                kidnap["recovered_m"].get<double>());
  }
}

void run(const LocalizeOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  const Truth truth = read_truth(options.truth);
  const LocalizationConfig config = config_of(options, truth);
  (void)parse_windows(options.exclude);
  if (!config.start.empty() && config.start.size() != 3) throw WrongUse{"localize: --start wants X,Y,THETA"};
  const OccupancyGrid map = load_map(options.map);
  mcap::Reader recording{mcap::file_source(options.file), options.file};

  std::optional<Kidnapping> kidnapping;
  if (options.kidnap_s) {
    kidnapping = kidnapping_at(recording, Time{from_seconds(*options.kidnap_s)}, truth.poses,
                               static_cast<std::uint64_t>(config.seed));
    if (!kidnapping) {
      throw std::runtime_error{options.file +
                               ": nowhere to carry the robot to: --kidnap wants a time at which there "
                               "are scans, and 20 s of scans at least 10 s and 3 m away from it"};
    }
  }

  Progress progress{"localize"};
  const OfflineResult result =
      localize_offline(recording, map, {.config = config, .kidnapping = kidnapping}, [&progress](double share) {
        progress.show(share);
        return !stop_requested();
      });
  if (stop_requested()) throw Interrupted{};
  if (result.poses.empty()) {
    throw std::runtime_error{options.file +
                             ": no pose was found: it needs odometry, scans and a start pose (--start X,Y,THETA, "
                             "--truth FILE, --global, or a pose hint in the recording)"};
  }
  if (!options.trajectory.empty()) {
    std::string text;
    for (const EstimatedPose& estimate : result.poses) text += trajectory_line(estimate.pose);
    write_file_atomically(options.trajectory, text);
  }
  if (!options.picture.empty()) {
    std::vector<TimedPose> poses;
    for (const EstimatedPose& estimate : result.poses) poses.push_back(estimate.pose);
    write_file_atomically(options.picture, trajectory_picture(map, poses, {.truth = truth.poses}));
  }
  auto report = report_of(options, truth, config, result);
  if (kidnapping) report["kidnap"] = kidnapping_report(options, truth, *kidnapping, result);
  if (options.json) {
    std::puts(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    print_text(report);
  }
  for (const std::string& damage : recording.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
}

}  // namespace

void add_localize_command(CLI::App& tandem) {
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::App* command =
      add_command(tandem, "localize", "Find the robot's poses of a recording on a map",
                  "tandem localize fr079.mcap --map fr079.yaml --scans odd --truth fr079.reference.txt --json");
  command->add_option("RECORDING", options->file, "Recording with odometry and scans (.mcap)")->required();
  command->add_option("--map", options->map, "map_server YAML file")->required();
  command->add_option("--config", options->config, "A localization.toml; default: built-in values");
  command->add_option("--truth", options->truth, "Lines of t x y theta, or a .relations file; plain or gzip");
  command->add_option("--truth-offset", options->truth_offset_s, "Truth time minus recording time [s]");
  auto* start = command->add_option("--start", options->start, "Start pose X,Y,THETA [m, m, rad]");
  start->delimiter(',')->expected(3);
  command->add_flag("--global", options->global, "Start anywhere on the map")->excludes(start);
  command->add_option("--exclude", options->exclude, "Windows A:B,... [s] left out of rmse_kept_m")->delimiter(',');
  command->add_option("--scans", options->scans, "all, or odd: scans 1, 3, 5, ... alone")
      ->check(CLI::IsMember({"all", "odd"}));
  command->add_option("--kidnap", options->kidnap_s,
                      "Carry the robot, at this time [s], to another place of the recording");
  command->add_option("--seed", options->seed, "Of all random draws");
  command->add_option("--trajectory", options->trajectory, "Write the poses here: lines of t x y theta");
  command->add_option("--svg", options->picture, "Draw the map with the estimated and the true way here");
  command->add_flag("--json", options->json, "Report as JSON");
  command->callback([options] { run(*options); });
}

}  // namespace tandem::cli
