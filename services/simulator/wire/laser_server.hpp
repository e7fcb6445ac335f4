#pragma once

#include <string>
#include <vector>

#include "services/simulator/core/scip_device.hpp"
#include "services/simulator/core/simulation.hpp"
#include "services/simulator/wire/tcp_listener.hpp"

namespace tandem::simulator {

/// The simulated lidar on TCP. Each client has a dialogue of its own with the same turning mirror.
class LaserServer {
 public:
  LaserServer(const std::string& address, std::uint16_t port, scip::SensorParameters sensor, Time now);

  void receive(Time now);
  /// To be called after each simulation step, which began at `start` and lasted `length`: ends the turn if one ended.
  void step(Simulation& simulation, Time start, Duration length);
  void add_descriptors(std::vector<int>& descriptors) const;
  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

 private:
  struct Client {
    Connection connection;
    ScipDevice device;
  };

  [[nodiscard]] std::vector<Beam> beams_of(std::span<const ScanBeam> steps) const;

  TcpListener listener_;
  scip::SensorParameters sensor_;
  Time started_;
  Duration turn_period_;
  Time next_turn_end_;
  std::vector<Client> clients_;
};

}  // namespace tandem::simulator
