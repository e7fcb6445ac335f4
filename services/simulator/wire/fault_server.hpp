#pragma once

#include <functional>
#include <string>
#include <vector>

#include "services/simulator/core/hardware_fault.hpp"
#include "services/simulator/wire/tcp_listener.hpp"

namespace tandem::simulator {

/// Takes orders to break and to mend the simulated hardware while it runs: lines "DEVICE FAULT" over TCP, answered by
/// "ok" or by what is wrong with them.
class FaultServer {
 public:
  /// A device that can be broken.
  struct Breakable {
    std::string name;  ///< "laser"
    std::function<void(HardwareFault)> set;
  };

  FaultServer(const std::string& address, std::uint16_t port, std::vector<Breakable> devices);

  void receive();
  void add_descriptors(std::vector<int>& descriptors) const;
  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

 private:
  struct Client {
    Connection connection;
    std::string line = {};
  };
  [[nodiscard]] std::string answer(const std::string& order) const;

  TcpListener listener_;
  std::vector<Breakable> devices_;
  std::vector<Client> clients_;
};

}  // namespace tandem::simulator
