#pragma once

#include <memory>
#include <string>
#include <vector>

#include "services/simulator/core/hardware_fault.hpp"
#include "services/simulator/core/laser_device.hpp"
#include "services/simulator/core/simulation.hpp"
#include "services/simulator/wire/pseudo_terminal.hpp"
#include "services/simulator/wire/tcp_listener.hpp"

namespace tandem::simulator {

/// Where a simulated laser is reached, and what it is.
struct LaserServerOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: not over TCP
  std::string pty = {};    ///< A link to a pseudo terminal; empty: none.
  std::string model = "utm-30lx";
  Duration boot = {};  ///< Silent for so long after it gets power.
};

/// The simulated laser on TCP and a pseudo terminal. Each client has a dialogue of its own with the same place.
class LaserServer {
 public:
  LaserServer(LaserServerOptions options, Time now);

  void receive(Time now);
  /// To be called after each simulation step, which began at `start` and lasted `length`: ends the turns that ended.
  void step(Simulation& simulation, Time start, Duration length);
  /// Breaks or mends it. A laser that was off comes back as one that was just switched on.
  void set_fault(HardwareFault fault, Time now);

  void add_descriptors(std::vector<int>& descriptors) const;
  [[nodiscard]] std::uint16_t port() const { return listener_ ? listener_->port() : 0; }

 private:
  /// A device with what stands between it and its host.
  struct Dialogue {
    std::unique_ptr<LaserDevice> device;
    FaultyLine line;
    Time next_turn_end;
    std::vector<double> last_ranges_m = {};
  };
  struct Client {
    Connection connection;
    Dialogue dialogue;
  };

  [[nodiscard]] Dialogue dialogue(Time now) const;
  void receive_from(Connection& connection, Dialogue& dialogue, Time now);
  void end_turn(Connection& connection, Dialogue& dialogue, Simulation& simulation, Time end);
  [[nodiscard]] std::vector<double> measured(Dialogue& dialogue, Simulation& simulation,
                                             std::span<const Beam> beams) const;
  [[nodiscard]] bool has_power(Time now) const;

  LaserServerOptions options_;
  std::unique_ptr<TcpListener> listener_;
  std::vector<Client> clients_;
  std::unique_ptr<PseudoTerminal> pty_;
  std::optional<Dialogue> serial_;  ///< At the pseudo terminal.
  HardwareFault fault_ = HardwareFault::None;
  Time powered_;
};

}  // namespace tandem::simulator
