#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/bus/health.hpp"
#include "services/localization/core/latency_window.hpp"
#include "services/localization/core/localizer.hpp"

namespace tandem {

/// Feeds the localizer with every odometry sample, scan and hint in order of arrival, and publishes a pose per scan and
/// per odometry sample.
class LocalizationService {
 public:
  LocalizationService(const LocalizationConfig& config, const SiteConfig& site, bus::Bus& bus, const Clock& clock);

  /// Takes in all that came since the last step.
  ///
  /// In lockstep nothing is lost: inputs wait for the map, and a scan without a pose is answered too (no_pose), for the
  /// player waits for the answer to each.
  void step();

 private:
  using Odometry = bus::Received<msg::Odometry>;
  using Scan = bus::Received<msg::LaserScan>;

  void take_map();
  void begin_anew();
  void forget_after_restart();
  void take_hints();
  void feed(const std::vector<Odometry>& odometry, const std::vector<Scan>& scans);
  void localize(const msg::LaserScan& message);
  /// Stamps never go back: readers interpolate between poses in the order in which they come. So the pose of a scan
  /// that took longer than the odometry after it comes with that: carried on to its time.
  void publish(const LocalizationResult& result);
  /// Where the robot was when this service ended is where it may be.
  void recall(const std::string& map_sha256);
  void keep_last_pose();
  void report_memory();
  void report();
  [[nodiscard]] std::string fault_text();
  [[nodiscard]] std::string latency_text() const;

  LocalizationConfig config_;
  std::string robot_;
  bool lockstep_;
  const Clock& clock_;
  int epoch_;
  bus::Latest<msg::OccupancyGrid, msg::OccupancyGridPubSubType> maps_;
  bus::InOrder<msg::Odometry, msg::OdometryPubSubType> odometry_;
  bus::InOrder<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  bus::EventReceiver<msg::PoseHint, msg::PoseHintPubSubType> hints_;
  bus::Writer<msg::RobotPose, msg::RobotPosePubSubType> poses_;
  bus::HealthReporter health_;
  OccupancyGrid map_;
  std::string map_sha256_;
  std::optional<Localizer> localizer_;
  std::optional<LocalizationStatus> logged_;
  MemoryOutcome logged_memory_ = MemoryOutcome::None;
  Time published_{Duration::min()};  ///< stamp of the last pose
  LatencyWindow latency_;
  Time next_second_{};        ///< when faults and latency are looked at again
  InputFaults known_faults_;  ///< when they last were
  std::string new_faults_;    ///< that came in the second before
  std::string latency_shown_;
  Time next_keeping_{};  ///< of the last pose
};

}  // namespace tandem
