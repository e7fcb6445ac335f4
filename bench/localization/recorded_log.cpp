#include "bench/localization/recorded_log.hpp"

#include <algorithm>
#include <optional>

#include "services/mapping/core/map_file.hpp"
#include "services/recorder/core/carmen_log.hpp"
#include "services/recorder/core/text_log.hpp"

namespace tandem::bench {
namespace {

const Pose2 kLaserOfPioneer3dx{0.1, 0.0, 0.0};  ///< as its makers measured it

LogEvent event_of(const carmen::Event& event) {
  if (const auto* odometry = std::get_if<carmen::Odometry>(&event)) {
    return OdometrySample{Time{from_seconds(odometry->time_s)}, odometry->odom_from_base, odometry->velocity, 0};
  }
  const auto& scan = std::get<carmen::Scan>(event);
  return LaserScan{.time = Time{from_seconds(scan.time_s)},
                   .base_from_laser = scan.base_from_laser,
                   .angle_min_rad = scan.angle_min_rad,
                   .angle_increment_rad = scan.angle_increment_rad,
                   .range_min_m = scan.range_min_m,
                   .range_max_m = scan.range_max_m,
                   .ranges_m = scan.ranges_m};
}

}  // namespace

Time time_of(const LogEvent& event) {
  return std::visit([](const auto& one) { return one.time; }, event);
}

std::vector<LogEvent> events_of(const std::filesystem::path& file) {
  std::vector<LogEvent> events;
  for (const carmen::Event& event : carmen::parse_log(carmen::read_log_file(file), file)) {
    events.push_back(event_of(event));
  }
  return events;
}

RecordedLog load_log(const std::string& name, const std::filesystem::path& data_folder) {
  RecordedLog log;
  log.name = name;
  log.map_file = data_folder / "maps" / (name == "fr079" ? "fr079_even.yaml" : name + "_full.yaml");
  log.map = load_map(log.map_file);
  const auto stem = data_folder / name / name;
  std::size_t scans = 0;
  for (LogEvent& event : events_of(stem.string() + ".odomscan.txt.gz")) {
    const bool drew_the_map = name == "fr079" && std::holds_alternative<LaserScan>(event) && scans++ % 2 == 0;
    if (!drew_the_map) log.events.push_back(std::move(event));
  }
  const std::string truth = stem.string() + ".reference.txt";
  log.truth = parse_trajectory(carmen::read_log_file(truth), truth);
  std::stable_sort(log.truth.begin(), log.truth.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return log;
}

RecordedLog load_pioneer3dx_log(const std::string& name, const std::filesystem::path& data_folder) {
  RecordedLog log;
  log.name = name;
  log.map_file = data_folder / "pioneer3dx" / "my_map2.yaml";
  log.map = load_map(log.map_file);
  const std::string file = (data_folder / "pioneer3dx" / (name + ".txt.gz")).string();
  for (const carmen::Event& event : parse_text_log(carmen::read_log_file(file), file, kLaserOfPioneer3dx)) {
    log.events.push_back(event_of(event));
  }
  return log;
}

Time time_after_way(const RecordedLog& log, Time from, double way_m) {
  double driven_m = 0.0;
  for (std::size_t i = 1; i < log.truth.size(); ++i) {
    if (log.truth[i - 1].time < from) continue;
    driven_m += (log.truth[i].map_from_base.position() - log.truth[i - 1].map_from_base.position()).norm();
    if (driven_m >= way_m) return log.truth[i].time;
  }
  return log.truth.back().time;
}

double way_between_m(const RecordedLog& log, Time from, Time until) {
  double driven_m = 0.0;
  for (std::size_t i = 1; i < log.truth.size(); ++i) {
    if (log.truth[i - 1].time < from || log.truth[i].time > until) continue;
    driven_m += (log.truth[i].map_from_base.position() - log.truth[i - 1].map_from_base.position()).norm();
  }
  return driven_m;
}

RecordedLog carried(const RecordedLog& log, Time lifted, Time put_down, double way_m) {
  constexpr Duration kCarrying = std::chrono::seconds{1};
  const Duration later = lifted + kCarrying - put_down;
  const Time end = time_after_way(log, put_down, way_m);
  RecordedLog result;
  result.name = log.name;
  result.map_file = log.map_file;
  result.map = log.map;
  std::optional<OdometrySample> at_lift;
  std::optional<OdometrySample> at_put_down;
  for (const LogEvent& event : log.events) {
    if (time_of(event) > lifted) continue;
    result.events.push_back(event);
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) at_lift = *odometry;
  }
  for (LogEvent event : log.events) {
    if (time_of(event) < put_down || time_of(event) > end) continue;
    if (auto* odometry = std::get_if<OdometrySample>(&event)) {
      if (!at_put_down) at_put_down = *odometry;
      odometry->odom_from_base =
          at_lift->odom_from_base * inverse(at_put_down->odom_from_base) * odometry->odom_from_base;
      odometry->time += later;
      result.events.emplace_back(*odometry);
    } else if (at_put_down) {
      std::get<LaserScan>(event).time += later;
      result.events.push_back(event);
    }
  }
  for (const TimedPose& pose : log.truth) {
    if (pose.time <= lifted) result.truth.push_back(pose);
  }
  for (const TimedPose& pose : log.truth) {
    if (pose.time >= put_down && pose.time <= end) result.truth.push_back({pose.time + later, pose.map_from_base});
  }
  return result;
}

}  // namespace tandem::bench
