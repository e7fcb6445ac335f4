#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "services/localization/core/input_faults.hpp"
#include "services/localization/core/laser_scan.hpp"
#include "services/map_builder/core/map_builder_config.hpp"
#include "services/map_builder/core/odometry_track.hpp"

namespace tandem {

/// A scan that a map is built from.
struct MapScan {
  Time time{};                                  ///< by which scans and odometry are in order
  Time stamp{};                                 ///< as recorded
  std::optional<std::size_t> odometry_index{};  ///< of the sample that it belongs to
  std::optional<Pose2> motion{};  ///< from the scan before, by the wheels; none across a break of the odometry
  Eigen::Vector2d laser_in_base = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> endpoints_in_base{};  ///< of the beams that returned [m], in their order
};

/// All that a map is built from: what one robot measured on one drive.
struct Drive {
  std::vector<MapScan> scans;  ///< by time
  OdometryTrack odometry;
  std::size_t scans_seen = 0;  ///< in the recording, used or not
  InputFaults faults;          ///< what could not be used as it came
};

/// Gathers odometry and scans in the order of a recording.
///
/// A scan that came right after an odometry sample of the same stamp belongs to it: logs that were joined from both are
/// so. Refused and counted: odometry much older than the last, scans with too few returns, older than the last one, or
/// with the very same ranges although the robot drove on. Scans of a robot that stood still are thinned out in time.
class DriveLog {
 public:
  explicit DriveLog(const MapBuilderConfig& config) : config_(config) {}

  void add_odometry(const OdometrySample& sample);
  void add_scan(const LaserScan& scan);
  /// Ends the log: scans without odometry at their time are refused.
  [[nodiscard]] Drive take();

 private:
  [[nodiscard]] bool is_stuck(const LaserScan& scan);
  [[nodiscard]] bool is_worth_keeping(Time time) const;

  MapBuilderConfig config_;
  Drive drive_;
  std::vector<OdometrySample> samples_;
  std::vector<float> seen_ranges_m_;
  Pose2 seen_at_;
  Time last_scan_ = Time::min();
  std::optional<OdometrySample> kept_at_;
};

}  // namespace tandem
