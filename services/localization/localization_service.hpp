#pragma once

#include <optional>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/events.hpp"
#include "services/bus/health.hpp"
#include "services/localization/core/localizer.hpp"

namespace tandem {

/// Feeds the localizer with every odometry sample, scan and hint in order of arrival, and publishes a pose per scan.
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
  void forget_after_restart();
  void take_hints();
  void feed(const std::vector<Odometry>& odometry, const std::vector<Scan>& scans);
  void localize(const msg::LaserScan& message);
  void report();

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
  std::optional<Localizer> localizer_;
  std::optional<LocalizationStatus> logged_;
};

}  // namespace tandem
