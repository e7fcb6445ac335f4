#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace tandem {

/// A device on the network: a lidar's own port, a serial server, the simulator.
struct TcpDevice {
  std::string host;
  std::uint16_t port = 0;
};

/// A device file: a serial port, a USB serial port, or a pseudo-terminal.
struct SerialDevice {
  std::string path;
};

using Device = std::variant<TcpDevice, SerialDevice>;

/// The device that `name` says: "tcp://HOST:PORT" or "/dev/...". Throws ConfigError, with what is allowed, on any
/// other.
[[nodiscard]] Device parse_device(const std::string& name);

}  // namespace tandem
