#pragma once

#include <optional>
#include <string>

#include "robot/pioneer/base_diagnosis.hpp"
#include "robot/pioneer/base_link.hpp"
#include "robot/pioneer/gate_feed.hpp"
#include "robot/pioneer/gated_base.hpp"
#include "services/bus/health.hpp"
#include "services/mapping/core/map_zones.hpp"

namespace tandem {

/// The base: odometry out, velocities in, and the safety gate between them and the wheels. One thread does it all, so
/// that a gate that hangs sends no pulse either, and the firmware's watchdog stops the robot.
class BaseService {
 public:
  BaseService(const BaseConfig& config, const MapZones& zones, const SiteConfig& site, bus::Bus& bus, Clock& timer,
              const Clock& mission);
  ~BaseService();
  BaseService(const BaseService&) = delete;
  BaseService& operator=(const BaseService&) = delete;

  /// Waits for the controller for a moment, and does what is to be done: a cycle 20 times a second, and at once on a
  /// contact, a command or a STOP.
  void step();

 private:
  void take(const pioneer::SessionEvent& event);
  void log_event(const pioneer::SessionEvent& event);
  void publish_motion(const pioneer::StatusReceived& status);
  void cycle();
  void publish_status(const safety::GateDecision& decision, Time now);
  void log_changes(const safety::GateDecision& decision);
  void mark_driving(bool driving);

  BaseConfig config_;
  std::string robot_;
  Clock& timer_;
  const Clock& mission_;
  BaseLink link_;
  GatedBase base_;
  BaseDiagnosis diagnosis_;
  GateFeed feed_;
  Time next_cycle_{};
  Time last_cycle_{};
  bool asked_ = false;  ///< for something that the gate has not answered yet
  Time next_status_{};
  msg::BaseStatus last_status_;
  std::string last_trouble_ = "connecting";
  safety::Causes last_causes_;
  bool marked_ = false;

  bus::Writer<msg::Odometry, msg::OdometryPubSubType> odometry_writer_;
  bus::Writer<msg::SonarRanges, msg::SonarRangesPubSubType> sonar_writer_;
  bus::Writer<msg::BaseStatus, msg::BaseStatusPubSubType> status_writer_;
  bus::HealthReporter health_;
};

}  // namespace tandem
