#pragma once

#include <memory>
#include <optional>
#include <string>

#include "services/bus/bus.hpp"
#include "services/bus/health.hpp"
#include "services/common/clock.hpp"
#include "services/common/site_config.hpp"
#include "services/simulator/core/simulator_config.hpp"
#include "services/simulator/phone.hpp"
#include "services/simulator/wire/base_server.hpp"
#include "services/simulator/wire/camera_server.hpp"
#include "services/simulator/wire/fault_server.hpp"
#include "services/simulator/wire/laser_server.hpp"

namespace tandem::simulator {

/// Runs the world in real time, 40 steps a second, and serves base, laser, camera and phone. One thread.
class SimulatorService {
 public:
  /// Throws when scenario or map cannot be used, or a port is taken.
  SimulatorService(const SimulatorConfig& config, const SiteConfig& site, bus::Bus& bus, Clock& clock);

  /// Serves clients until the next step of the world is due, then takes it.
  void step();
  /// Where everything listens, for the log.
  [[nodiscard]] std::string description() const;

 private:
  void wait_for_clients(Time until);
  void advance(Time now);
  void publish(Time now);
  [[nodiscard]] std::vector<FaultServer::Breakable> breakables();

  SiteConfig site_;
  Clock& clock_;
  Simulation simulation_;
  std::unique_ptr<Phone> phone_;  ///< None: nobody holds a phone.
  BaseServer base_;
  std::optional<LaserServer> laser_;
  std::optional<CameraServer> camera_;
  std::optional<FaultServer> faults_;
  bus::Writer<msg::GroundTruth, msg::GroundTruthPubSubType> ground_truth_;
  bus::HealthReporter health_;
  Time next_step_;
  Time next_truth_;
};

}  // namespace tandem::simulator
