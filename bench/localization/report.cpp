#include "bench/localization/report.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bench/localization/map_fit.hpp"
#include "bench/localization/mrpt_peer.hpp"
#include "bench/localization/simulated_nees.hpp"
#include "bench/localization/trials.hpp"
#include "services/common/config.hpp"
#include "services/common/file_io.hpp"
#include "services/common/format.hpp"
#include "services/common/version.hpp"
#include "services/localization/core/trajectory_picture.hpp"
#include "services/mapping/core/sha256.hpp"

namespace tandem::bench {
namespace {

constexpr double kReferenceM = 0.055;  ///< how good the reference poses are, by the surveyed relations
constexpr double kReferenceDeg = 1.0;  ///< ... at least
constexpr double kTrialWayM = 35.0;
constexpr double kKidnapWayM = 15.0;

/// Names the parameters, as `tandem localize` does.
std::string hash_of(LocalizationConfig config) {
  return sha256_hex(write_config(config)).substr(0, 16);
}

std::string tracking_row(const RecordedLog& log, LocalizationConfig config, const std::string& what,
                         const CampaignOptions& options) {
  const std::string hash = hash_of(config);
  const Pose2 first = log.truth.front().map_from_base;
  config.start = {first.x, first.y, first.heading};
  const std::vector<RunStep> steps = run_log(log, {.config = config});
  std::vector<EstimatedPose> estimates;
  std::vector<TimedPose> way;
  std::vector<double> times_ms;
  double mean_ms = 0.0;
  Eigen::Matrix3d reference = Eigen::Matrix3d::Zero();
  reference.diagonal() << kReferenceM * kReferenceM / 2.0, kReferenceM * kReferenceM / 2.0,
      std::pow(from_degrees(kReferenceDeg), 2);
  for (const RunStep& step : steps) {
    way.push_back({step.result.time, step.result.map_from_base});
    estimates.push_back({way.back(), step.result.covariance + reference, step.result.status});
    times_ms.push_back(step.update_ms);
    mean_ms += step.update_ms / static_cast<double>(steps.size());
  }
  std::sort(times_ms.begin(), times_ms.end());
  const TrajectoryErrors errors = errors_of(estimates, log.truth, 0.0, {});
  if (what == "default") {
    write_file_atomically(options.output / (log.name + ".svg"), trajectory_picture(log.map, way, {.truth = log.truth}));
  }
  return formatted("| %s | %s | %zu | %.4f / %.2f | %.2f | %.4f | %.2f | %.4f | %.2f, %.2f, %.2f | %s |\n",
                   log.name.c_str(), what.c_str(), errors.compared, errors.rmse_m, errors.rmse_deg, errors.max_m,
                   errors.lost_share, errors.nees, errors.status_wrong_share, mean_ms, times_ms[times_ms.size() / 2],
                   times_ms[times_ms.size() * 95 / 100], hash.c_str());
}

/// Rows of both localizers side by side, on the same scans and the same map.
std::string peer_rows(const RecordedLog& log, const LocalizationConfig& config) {
  const auto row = [&](const std::string& who, const std::vector<EstimatedPose>& poses, double update_ms,
                       const std::string& hash) {
    const TrajectoryErrors errors = errors_of(poses, log.truth, 0.0, {});
    return formatted("| %s | %s | %zu | %.3f / %.2f | %.2f | %.4f | %.2f | %s |\n", log.name.c_str(), who.c_str(),
                     errors.compared, errors.rmse_m, errors.rmse_deg, errors.max_m, errors.lost_share, update_ms,
                     hash.c_str());
  };
  LocalizationConfig started = config;
  const Pose2 first = log.truth.front().map_from_base;
  started.start = {first.x, first.y, first.heading};
  std::vector<EstimatedPose> ours;
  double update_ms = 0.0;
  const std::vector<RunStep> steps = run_log(log, {.config = started});
  for (const RunStep& step : steps) {
    ours.push_back({{step.result.time, step.result.map_from_base}, step.result.covariance, step.result.status});
    update_ms += step.update_ms / static_cast<double>(steps.size());
  }
  std::string rows = row("Tandem", ours, update_ms, hash_of(config));
  for (const std::size_t particles : {std::size_t{500}, std::size_t{2000}}) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("tandem_mrpt_" + log.name + "_" + std::to_string(particles));
    const PeerRun peer = run_mrpt(log, particles, folder);
    std::filesystem::remove_all(folder);
    std::vector<EstimatedPose> theirs;
    for (const TimedPose& pose : peer.poses) theirs.push_back({pose, Covariance3::Identity(), LocalizationStatus::Ok});
    rows += row("MRPT pf-localization, N = " + std::to_string(particles), theirs, peer.update_ms, "-");
  }
  return rows;
}

/// Logs of a robot of which nobody knows where it was, started anywhere.
std::string untold_rows(const LocalizationConfig& config, const CampaignOptions& options) {
  std::string rows;
  for (const char* name : {"ist_17jun_2", "ist_17jun_1", "ist_22jun_1", "ist_22jun_pm_2"}) {
    const RecordedLog log = load_pioneer3dx_log(name, options.data_folder);
    LocalizationConfig anywhere = config;
    anywhere.start_globally = true;
    const std::vector<RunStep> steps = run_log(log, {.config = anywhere});
    const MapFit fit = map_fit_of(log, steps);
    std::vector<TimedPose> way;
    for (const RunStep& step : steps) way.push_back({step.result.time, step.result.map_from_base});
    write_file_atomically(options.output / (log.name + ".svg"), trajectory_picture(log.map, way, {}));
    rows += formatted("| %s | %zu | %zu | %.3f | %.1f | %.3f | %.3f | %.2f | %s |\n", name, fit.scans, fit.poses,
                      fit.ok_share, fit.first_ok_s, fit.near_wall, fit.near_wall_ok, fit.update_ms,
                      hash_of(config).c_str());
  }
  return rows;
}

std::string trial_rows(const std::string& log, const std::string& what, const std::vector<Trial>& trials) {
  std::string rows;
  for (const Trial& trial : trials) {
    rows += formatted("| %s | %s | %.0f | %.1f | %.1f | %.1f | %d of %d | %.2f / %.1f | %s | %.0f |\n", log.c_str(),
                      what.c_str(), trial.start_s, trial.settled_m, trial.right_m, trial.flagged_s, trial.wrong_ok,
                      trial.scans, trial.final_m, trial.final_deg, trial.final_status.c_str(), trial.slowest_ms);
  }
  return rows;
}

/// Found: right and believed at the end; kidnapped: within 10 m and flagged within 2 s.
std::string trial_summary(const std::string& log, const std::string& what, const std::vector<Trial>& trials,
                          double within_m) {
  const auto found = std::count_if(trials.begin(), trials.end(),
                                   [&](const Trial& t) { return t.right_m >= 0.0 && t.right_m <= within_m; });
  const auto flagged = std::count_if(trials.begin(), trials.end(),
                                     [](const Trial& t) { return t.flagged_s >= 0.0 && t.flagged_s <= 2.0; });
  int wrong = 0;
  double way_m = 0.0;
  for (const Trial& trial : trials) {
    wrong += trial.wrong_ok;
    way_m += std::max(0.0, trial.right_m) / static_cast<double>(trials.size());
  }
  return formatted("| %s | %s | %td of %zu | %td of %zu | %.1f | %d |\n", log.c_str(), what.c_str(), found,
                   trials.size(), flagged, trials.size(), way_m, wrong);
}

std::string simulated_row(const LocalizationConfig& config, const DriveOptions& drive, const std::string& wheels,
                          int drives) {
  const SimulatedErrors e = simulated_errors(config, drive, static_cast<std::uint64_t>(drives));
  return formatted("| %s | %.2f | %.3g | %s | %zu | %.2f | %.4f, %.4f, %.5f | %.4f, %.4f, %.5f | %s |\n",
                   drive.corridor ? "blank corridor" : "hall", drive.resolution_m, drive.range_deviation_m,
                   wheels.c_str(), e.scans, e.nees, e.along_m, e.across_m, e.turn_rad, e.claimed_along_m,
                   e.claimed_across_m, e.claimed_turn_rad, hash_of(config).c_str());
}

std::string simulated_rows(const LocalizationConfig& config, int drives) {
  std::string rows;
  for (const bool corridor : {false, true}) {
    DriveOptions drive{.way_m = 25.0, .corridor = corridor, .wheels = config.wheels};
    for (const double deviation_m : {0.01, 0.02, 0.04}) {
      drive.range_deviation_m = deviation_m;
      rows += simulated_row(config, drive, "as said", drives);
    }
    drive.range_deviation_m = 0.02;
    DriveOptions coarse = drive;
    coarse.resolution_m = 0.1;
    rows += simulated_row(config, coarse, "as said", drives);
    DriveOptions better = drive;
    better.wheels = config.wheels.times(0.5);
    rows += simulated_row(config, better, "half as wrong as said", drives);
    DriveOptions crowded = drive;
    crowded.random_share = 0.15;
    rows += simulated_row(config, crowded, "as said; 15 % of beams at unmapped things", drives);
  }
  return rows;
}

}  // namespace

void run_campaign(const CampaignOptions& options) {
  std::filesystem::create_directories(options.output);
  const LocalizationConfig config;
  const bool beside_mrpt = has_mrpt();
  std::string tracking;
  std::string peers;
  std::string summaries;
  std::string trials;
  for (const char* name : {"intel", "fr079"}) {
    std::fprintf(stderr, "%s\n", name);
    const RecordedLog log = load_log(name, options.data_folder);
    tracking += tracking_row(log, config, "default", options);
    for (const auto& [scans, what] : {std::pair{1, "one scan refined"}, std::pair{0, "filter alone"}}) {
      LocalizationConfig less = config;
      less.window_scans = scans;
      tracking += tracking_row(log, less, what, options);
    }
    if (beside_mrpt) peers += peer_rows(log, config);
    const auto global = global_trials(log, config, options.starts, kTrialWayM);
    summaries += trial_summary(name, "global start", global, kTrialWayM);
    trials += trial_rows(name, "global start", global);
    const auto kidnapped = kidnap_trials(log, config, options.starts, kKidnapWayM);
    summaries += trial_summary(name, "kidnapped", kidnapped, 10.0);
    trials += trial_rows(name, "kidnapped", kidnapped);
  }
  std::fprintf(stderr, "pioneer3dx\n");
  const std::string untold = untold_rows(config, options);
  std::fprintf(stderr, "simulation\n");
  const std::string simulated = simulated_rows(config, options.drives);

  const std::string report =
      "# How well the robot finds itself\n\nCommit " + commit().substr(0, 12) + ", parameters " + hash_of(config) +
      ".\n\n    ./run bench localization --starts " + std::to_string(options.starts) + " --drives " +
      std::to_string(options.drives) +
      "\n\n## Tracking\n\nWhole logs, faults included; fr079: odd scans on the map of "
      "the even ones. The reference is good to 5 to 6 cm and 1 degree, and the normalised error (NEES, 1 is honest) "
      "takes it as that wrong. Times: thread CPU time per update; mean, median, 95 %. The rows below *default* are the "
      "ablation of the Ceres stage.\n\n"
      "| log | stage | scans | RMSE m / deg | largest m | lost | NEES | status wrong | update ms | parameters |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n" +
      tracking + "\n## Beside MRPT\n\n" +
      (beside_mrpt ? "The same scans, odometry, maps and starts through `pf-localization` (how: "
                     "bench/localization/README.md). CPU time per update is that of its whole process.\n\n"
                     "| log | localizer | scans | RMSE m / deg | largest m | lost | update ms | parameters |\n"
                     "|---|---|---|---|---|---|---|---|\n" +
                         peers
                   : std::string{"Not run: `pf-localization` is not installed (bench/localization/README.md).\n"}) +
      "\n![intel](intel.svg)\n![fr079](fr079.svg)\n\n## Finding itself\n\nGlobal starts: segments of 35 m without a "
      "start "
      "pose; found: right (0.5 m, 10 degrees) and ok to the end. Kidnapped: the log goes on elsewhere while the wheels "
      "stood still for a second; found within 10 m, flagged (not ok) within 2 s of the lift. Wrong: scans with status "
      "ok "
      "and a wrong pose.\n\n| log | trial | found | flagged | mean way m | wrong |\n|---|---|---|---|---|---|\n" +
      summaries +
      "\n| log | trial | at s | ok after m | right after m | flagged after s | ok but wrong | last error m / deg | "
      "last "
      "status | slowest ms |\n|---|---|---|---|---|---|---|---|---|---|\n" +
      trials +
      "\n## Without a known truth\n\nA Pioneer 3-DX with a short-range laser, on the map that its makers drew; started "
      "anywhere. Near a wall: share of beams that end within 0.2 m of an occupied cell.\n\n"
      "| log | scans | poses | ok | first ok s | near a wall | ... while ok | update ms | parameters |\n"
      "|---|---|---|---|---|---|---|---|---|\n" +
      untold + "\n## Covariance\n\nSimulated drives with exact truth, " + std::to_string(options.drives) +
      " of 25 m in each row; scans are cast against walls at any angle, 3 % of the beams end at unmapped things. "
      "Wheels "
      "and start err as the parameters say (`forward_per_m` ... `drift_rad`, `start_deviation_m`), for the covariance "
      "is "
      "what follows from them; where the wheels are better than said, it is larger than the error in the direction "
      "that "
      "only they tell. Errors and claimed deviations along, across (m), turn (rad).\n\n"
      "| place | cells m | range noise m | wheels | scans | NEES | errors | claimed | parameters |\n"
      "|---|---|---|---|---|---|---|---|---|\n" +
      simulated;
  write_file_atomically(options.output / "REPORT.md", report);
}

}  // namespace tandem::bench
