#include "bench/calibration/recorded_drive.hpp"

#include <algorithm>

#include "bench/localization/recorded_log.hpp"
#include "robot/pioneer/core/robot_parameters.hpp"
#include "services/recorder/core/carmen_log.hpp"

namespace tandem::bench {
namespace {

/// Where docs/data.md says that the wheels missed the motion.
TimeWindows slip_windows(const std::string& name) {
  if (name != "fr079") return {};
  return {{181.5, 184.5}, {196.5, 199.5}, {301.5, 310.5}, {397.5, 400.5}};
}

std::vector<TimedPose> reference_of(const std::string& name, const std::filesystem::path& data_folder) {
  const std::string file = (data_folder / name / (name + ".reference.txt")).string();
  std::vector<TimedPose> poses = parse_trajectory(carmen::read_log_file(file), file);
  std::stable_sort(poses.begin(), poses.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return poses;
}

Drive drive_until(const std::vector<LogEvent>& events, Time end) {
  DriveLog log{{}};
  for (const LogEvent& event : events) {
    if (time_of(event) > end) continue;
    if (const auto* odometry = std::get_if<OdometrySample>(&event)) log.add_odometry(*odometry);
    if (const auto* scan = std::get_if<LaserScan>(&event)) log.add_scan(*scan);
  }
  return log.take();
}

}  // namespace

HalvedLog halved_log(const std::string& name, const std::filesystem::path& data_folder, double way_m) {
  const auto events = events_of(data_folder / name / (name + ".odomscan.txt.gz"));
  const auto reference = reference_of(name, data_folder);
  const Time middle = reference.front().time + (reference.back().time - reference.front().time) / 2;
  const Drive first_half = drive_until(events, middle);
  const auto pairs = motion_pairs(first_half, {}, [](double) { return true; });
  const double half_track_m = 1.0 / pioneer::robot_parameters("p2dx")->half_track_per_m;
  HalvedLog result{.name = name};
  result.found = calibrated(first_half.odometry, pairs, {.half_track_m = half_track_m});

  const OdometryTrack all = drive_until(events, Time::max()).odometry;
  const auto second_half =
      std::partition_point(reference.begin(), reference.end(), [&](const auto& pose) { return pose.time <= middle; });
  const std::vector<TimedPose> judged{second_half, reference.end()};
  const auto errors = [&](const WheelUse& use) {
    return relative_errors_of(all, use, judged, way_m, slip_windows(name));
  };
  result.before = errors({.half_track_m = half_track_m});
  result.wheels = errors({.wheels = result.found.wheels, .half_track_m = half_track_m});
  result.after = errors({.wheels = result.found.wheels,
                         .base_from_laser = result.found.base_from_laser,
                         .laser_clock_s = result.found.laser_clock_s,
                         .half_track_m = half_track_m});
  return result;
}

}  // namespace tandem::bench
