#pragma once

#include <optional>
#include <string>

#include "robot/laser/laser_driver.hpp"
#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"

namespace tandem {

/// Publishes the laser's scans, and how the laser is.
class LaserService {
 public:
  LaserService(const LaserConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& timer, const Clock& mission);

  /// Waits for the device at most 50 ms and publishes what came.
  void step();
  [[nodiscard]] const LaserCondition& condition() const { return driver_.condition(); }

 private:
  void report();
  [[nodiscard]] std::string complaint_now();

  LaserDriver driver_;
  Clock& timer_;
  std::string robot_;
  Pose2 base_from_laser_;
  bus::Writer<msg::LaserScan, msg::LaserScanPubSubType> scans_;
  bus::HealthReporter health_;
  std::uint64_t sequence_number_ = 0;
  LaserCondition logged_;
  std::uint64_t damaged_ = 0;
  std::optional<Time> last_damage_;
  std::string complaint_;
};

}  // namespace tandem
