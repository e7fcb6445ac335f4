#include "bench/mapping/log_map.hpp"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>

#include "services/recorder/core/carmen_log.hpp"

namespace tandem::bench {
namespace {

constexpr double kIntelOffsetS = 976052857.337454;  ///< of the surveyed relations; docs/data.md
constexpr double kFr079OffsetS = 1211.445157;

double thread_cpu_s() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Begins a new measurement of the largest memory in use (Linux).
void reset_peak() {
  malloc_trim(0);
  std::ofstream{"/proc/self/clear_refs"} << 5;
}

double peak_mb() {
  std::ifstream status{"/proc/self/status"};
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024.0;
  }
  return 0.0;
}

}  // namespace

MappingLog load_mapping_log(const std::string& name, const std::filesystem::path& data_folder) {
  const std::string stem = (data_folder / name / name).string();
  MappingLog log{.name = name, .events = events_of(stem + ".odomscan.txt.gz"), .relations = {}, .truth = {}};
  const std::string truth = stem + ".reference.txt";
  log.truth = parse_trajectory(carmen::read_log_file(truth), truth);
  std::stable_sort(log.truth.begin(), log.truth.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  for (std::size_t i = 1; i < log.truth.size(); ++i) {
    log.way_m += (log.truth[i].map_from_base.position() - log.truth[i - 1].map_from_base.position()).norm();
  }
  log.has_clock = name != "frcampus";
  if (name == "frcampus") return log;
  log.relation_offset_s = name == "intel" ? kIntelOffsetS : kFr079OffsetS;
  const std::string relations = stem + ".relations.gz";
  log.relations = parse_relations(carmen::read_log_file(relations), relations);
  return log;
}

LogMap built(const MappingLog& log, const MapBuilderConfig& config) {
  reset_peak();
  const double before_s = thread_cpu_s();
  DriveLog drive_log{config};
  for (const LogEvent& event : log.events) {
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) {
      drive_log.add_odometry(*odometry);
    } else {
      drive_log.add_scan(std::get<LaserScan>(event));
    }
  }
  const Drive drive = drive_log.take();
  LogMap result{.map = build_map(drive, config), .scan_poses = {}};
  result.cpu_s = thread_cpu_s() - before_s;
  result.peak_mb = peak_mb();
  result.scans = drive.scans_seen;
  result.scan_poses = result.map.scan_poses;
  std::stable_sort(result.scan_poses.begin(), result.scan_poses.end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
  if (!drive.scans.empty()) result.recorded_s = to_seconds(drive.scans.back().time - drive.scans.front().time);
  return result;
}

}  // namespace tandem::bench
