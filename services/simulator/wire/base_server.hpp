#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "services/simulator/core/simulation.hpp"
#include "services/simulator/wire/pseudo_terminal.hpp"
#include "services/simulator/wire/tcp_listener.hpp"

namespace tandem::simulator {

/// The serial port of the simulated Pioneer, over TCP and over a pseudo terminal.
///
/// One TCP client at a time, as a serial port has one; the next is taken as soon as it has left. The controller knows
/// nothing of clients: a connection outlives its host, as on the real robot.
class BaseServer {
 public:
  BaseServer(const std::string& address, std::uint16_t port, const std::string& pty_link);

  /// Hands what clients sent to the controller, and its answers to whoever sent.
  void receive(Simulation& simulation, Time now);
  /// Sends the standard packet if it is due.
  void report(Simulation& simulation, Time now);
  void add_descriptors(std::vector<int>& descriptors) const;
  [[nodiscard]] std::uint16_t port() const { return listener_ ? listener_->port() : 0; }
  [[nodiscard]] std::string pty_path() const { return pty_ ? pty_->path() : ""; }

 private:
  enum class Host { Nobody, Tcp, Pty };

  void receive_from(Connection& connection, Host host, Simulation& simulation, Time now);
  void send(Connection& connection, const pioneer::Bytes& bytes);

  std::unique_ptr<TcpListener> listener_;
  std::unique_ptr<PseudoTerminal> pty_;
  std::optional<Connection> client_;
  Host host_ = Host::Nobody;  ///< Who spoke last: reports go there.
};

}  // namespace tandem::simulator
