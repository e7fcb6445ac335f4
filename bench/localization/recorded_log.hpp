#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "services/localization/core/laser_scan.hpp"
#include "services/localization/core/odometry_history.hpp"
#include "services/localization/core/trajectory_file.hpp"
#include "services/mapping/core/occupancy_grid.hpp"

namespace tandem::bench {

using LogEvent = std::variant<OdometrySample, LaserScan>;

/// A real robot's log with a map of the place, and where another program says the robot was.
struct RecordedLog {
  std::string name;
  std::filesystem::path map_file;
  OccupancyGrid map;
  std::vector<LogEvent> events;  ///< in the log's order
  std::vector<TimedPose> truth;  ///< by time; empty where nobody knows
};

/// Odometry and scans of a CARMEN log, in its order. Throws where the file is missing.
[[nodiscard]] std::vector<LogEvent> events_of(const std::filesystem::path& file);

/// The logs of docs/data.md in `data_folder`: "intel", "fr079". Throws where a file is missing.
///
/// Of fr079 only scans 1, 3, 5, ...: the map was drawn from the others.
[[nodiscard]] RecordedLog load_log(const std::string& name, const std::filesystem::path& data_folder);

/// The logs of a Pioneer 3-DX with a short-range laser: "ist_17jun_2" and others, on their makers' map, without truth.
[[nodiscard]] RecordedLog load_pioneer3dx_log(const std::string& name, const std::filesystem::path& data_folder);

[[nodiscard]] Time time_of(const LogEvent& event);

/// When the robot has driven `way_m` further than at `from`, by the truth; at the end of the log if that is sooner.
[[nodiscard]] Time time_after_way(const RecordedLog& log, Time from, double way_m);

/// How far the robot drove between two times, by the truth [m].
[[nodiscard]] double way_between_m(const RecordedLog& log, Time from, Time until);

/// The log as if at `lifted` the robot had been carried, with still wheels and within a second, to where it was at
/// `put_down`; the times after that are moved so that they go on. Ends after `way_m` there.
[[nodiscard]] RecordedLog carried(const RecordedLog& log, Time lifted, Time put_down, double way_m);

}  // namespace tandem::bench
