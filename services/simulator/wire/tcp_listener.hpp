#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/simulator/wire/connection.hpp"

namespace tandem::simulator {

/// Takes TCP connections on one port.
class TcpListener {
 public:
  /// `purpose` and `config_key` stand in messages: "the base (P2OS)", "base_port". Port 0: any free one. Throws
  /// std::runtime_error, naming port and remedy, if the port is taken or the address is not ours.
  TcpListener(const std::string& address, std::uint16_t port, const std::string& purpose,
              const std::string& config_key);
  TcpListener(const TcpListener&) = delete;
  TcpListener& operator=(const TcpListener&) = delete;
  ~TcpListener();

  /// The next client that waits; none if nobody does.
  [[nodiscard]] std::optional<Connection> accept();
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace tandem::simulator
