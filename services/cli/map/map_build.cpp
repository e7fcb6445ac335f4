#include "services/cli/map/map_build.hpp"

#include <sys/resource.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "services/cli/command.hpp"
#include "services/cli/map/drive_recording.hpp"
#include "services/cli/map/kept_build.hpp"
#include "services/cli/progress.hpp"
#include "services/cli/truth.hpp"
#include "services/common/clock.hpp"
#include "services/common/file_io.hpp"
#include "services/common/version.hpp"
#include "services/localization/core/trajectory_picture.hpp"
#include "services/map_builder/core/map_builder.hpp"
#include "services/mapping/core/map_file.hpp"

namespace tandem::cli {
namespace {

constexpr double kReadingShare = 0.1;  ///< of the progress bar

/// Refuses before the work what would fail after it.
void check_output(const std::string& option, const std::string& file) {
  if (file.empty()) return;
  const auto folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw WrongUse{"map build: " + option + " " + file + ": there is no folder " + folder.string()};
  }
}

void check_options(const MapBuildOptions& options) {
  if (std::filesystem::path{options.output}.extension() != ".yaml") {
    throw WrongUse{"map build: --output wants a file that ends in .yaml, and not " + options.output};
  }
  check_output("--output", options.output);
  check_output("--trajectory", options.trajectory);
  check_output("--svg", options.picture);
}

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Processor time of the whole program [s].
double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// Says what is missing from a recording that makes no map.
void check_drive(const std::string& file, const RecordedDrive& recorded) {
  if (!recorded.drive.scans.empty()) return;
  std::string why = "it holds no scans";
  if (recorded.drive.scans_seen > 0) {
    why = "none of its " + std::to_string(recorded.drive.scans_seen) + " scans could be used";
    if (recorded.odometry == 0) why += ": it holds no odometry";
  }
  throw std::runtime_error{file + ": no map can be built from it: " + why};
}

std::string picture_of(const BuiltMap& map, const Truth& truth) {
  std::vector<PictureLink> closures;
  for (const MapClosure& closure : map.closures) {
    closures.push_back({closure.earlier.map_from_base.position(), closure.later.map_from_base.position()});
  }
  std::vector<TimedPose> true_way = truth.poses;
  const Pose2 map_from_truth = inverse(form_errors_of(map.scan_poses, truth.poses, 0.0).truth_from_map);
  for (TimedPose& pose : true_way) pose.map_from_base = map_from_truth * pose.map_from_base;
  return trajectory_picture(map.grid, map.scan_poses, {.truth = true_way, .closures = closures});
}

nlohmann::ordered_json faults_of(const RecordedDrive& recorded) {
  nlohmann::ordered_json faults = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < kInputFaultNames.size(); ++i) {
    const auto count = recorded.drive.faults.count(static_cast<InputFault>(i));
    if (count > 0) faults[kInputFaultNames[i]] = count;
  }
  if (recorded.damaged > 0) faults["damaged_messages"] = recorded.damaged;
  return faults;
}

nlohmann::ordered_json report_of(const MapBuildOptions& options, const MapBuilderConfig& config,
                                 const RecordedDrive& recorded, const BuiltMap& map, const Truth& truth,
                                 double seconds) {
  nlohmann::ordered_json report{{"recording", options.file}, {"output", options.output}};
  const RelationErrors relations = relation_errors_of(map.trajectory, truth.relations, options.truth_offset_s);
  const FormErrors form = form_errors_of(sorted_by_time(map.scan_poses), truth.poses, options.truth_offset_s);
  const auto known = [](std::size_t compared, double value) {
    return compared > 0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
  };
  report["relations_m"] = known(relations.compared, relations.mean_m);
  report["relations_deg"] = known(relations.compared, relations.mean_deg);
  report["relations_m_std"] = known(relations.compared, relations.deviation_m);
  report["relations_deg_std"] = known(relations.compared, relations.deviation_deg);
  report["relations_compared"] = relations.compared;
  report["form_rmse_m"] = known(form.compared, form.rmse_m);
  report["form_max_m"] = known(form.compared, form.max_m);
  report["closures"] = map.closures.size();
  report["closures_rejected"] = map.rejected;
  report["seconds"] = seconds;
  report["cpu_seconds"] = cpu_s();
  report["recorded_seconds"] = recorded.duration_s;
  report["peak_mb"] = peak_mb();
  report["scans"] = recorded.drive.scans_seen;
  report["scans_used"] = map.scan_poses.size();
  report["nodes"] = map.nodes;
  report["faults"] = faults_of(recorded);
  report["complete"] = true;  // else there is no report
  report["config_hash"] = hash_of(config);
  report["seed"] = options.seed.value_or(1);
  return report;
}

void print_text(const nlohmann::ordered_json& report, const OccupancyGrid& grid) {
  std::printf("%s: %.1f x %.1f m from %zu of %zu scans, %zu closures, %zu rejected\n",
              report["output"].get<std::string>().c_str(), grid.width() * grid.resolution_m(),
              grid.height() * grid.resolution_m(), report["scans_used"].get<std::size_t>(),
              report["scans"].get<std::size_t>(), report["closures"].get<std::size_t>(),
              report["closures_rejected"].get<std::size_t>());
  std::printf("%.1f s, %.1f s of it computing, for %.0f s of recording; %.0f MB at most; parameters %s\n",
              report["seconds"].get<double>(), report["cpu_seconds"].get<double>(),
              report["recorded_seconds"].get<double>(), report["peak_mb"].get<double>(),
              report["config_hash"].get<std::string>().c_str());
  if (!report["relations_m"].is_null()) {
    std::printf("relations %.4f +- %.4f m, %.3f +- %.3f deg\n", report["relations_m"].get<double>(),
                report["relations_m_std"].get<double>(), report["relations_deg"].get<double>(),
                report["relations_deg_std"].get<double>());
  }
  if (!report["form_rmse_m"].is_null()) {
    std::printf("laid onto the truth: rmse %.3f m, largest %.2f m\n", report["form_rmse_m"].get<double>(),
                report["form_max_m"].get<double>());
  }
  for (const auto& [name, count] : report["faults"].items()) {
    std::fprintf(stderr, "not used: %s %zu\n", name.c_str(), count.get<std::size_t>());
  }
}

void write_results(const MapBuildOptions& options, const BuiltMap& map, const Truth& truth) {
  save_map(map.grid, options.output);
  if (!options.trajectory.empty()) write_file_atomically(options.trajectory, trajectory_text(map.trajectory));
  if (!options.picture.empty()) write_file_atomically(options.picture, picture_of(map, truth));
}

/// The map; where it is stopped, what is done is kept for the next time, and Interrupted thrown.
BuiltMap built_or_kept(const MapBuildOptions& options, const MapBuilderConfig& config, const Drive& drive,
                       const std::function<bool(const BuildProgress&)>& keep_going) {
  KeptBuild kept{options.output, key_of(drive, config, version_line())};
  if (options.fresh) KeptBuild::remove(options.output);
  MapBuild build{drive, config, kept.state(drive, config)};
  while (!build.is_done() && keep_going(build.progress())) {
    build.advance();
    kept.save_when_due(build.state());
  }
  if (build.is_done()) {
    if (auto map = build.drawn(keep_going)) return *std::move(map);
  }
  kept.save(build.state());
  std::fprintf(stderr, "tandem: stopped after %zu of %zu scans%s\n", build.state().graph.places.size(),
               drive.scans.size(), kept.how_to_go_on().c_str());
  throw Interrupted{};
}

}  // namespace

void run_map_build(const MapBuildOptions& options) {
  (void)stop_requested();  // from here on Ctrl-C is asked for
  check_options(options);
  const Truth truth = read_truth(options.truth);
  const auto config = options.config.empty() ? MapBuilderConfig{} : load_config<MapBuilderConfig>(options.config);
  const SteadyClock clock;
  const Time started = clock.now();

  std::optional<RecordedDrive> recorded;
  std::optional<BuiltMap> map;
  {
    Progress progress{"map build"};
    mcap::Reader recording{mcap::file_source(options.file), options.file};
    recorded = read_drive(recording, config, [&](double share) {
      progress.show(kReadingShare * share, "reading");
      return !stop_requested();
    });
    if (stop_requested()) throw Interrupted{};  // nothing is there yet that would be lost
    for (const std::string& damage : recording.damages()) std::fprintf(stderr, "tandem: %s\n", damage.c_str());
    check_drive(options.file, *recorded);
    map = built_or_kept(options, config, recorded->drive, [&](const BuildProgress& now) {
      progress.show(kReadingShare + (1.0 - kReadingShare) * now.share, now.step);
      return !stop_requested();
    });
  }
  write_results(options, *map, truth);
  KeptBuild::remove(options.output);
  const auto report = report_of(options, config, *recorded, *map, truth, to_seconds(clock.now() - started));
  if (options.json) {
    std::puts(report.dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    print_text(report, map->grid);
  }
}

}  // namespace tandem::cli
