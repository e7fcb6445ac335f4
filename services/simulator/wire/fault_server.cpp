#include "services/simulator/wire/fault_server.hpp"

#include <algorithm>
#include <utility>

namespace tandem::simulator {

FaultServer::FaultServer(const std::string& address, std::uint16_t port, std::vector<Breakable> devices)
    : listener_(address, port, "the faults", "fault_port"), devices_(std::move(devices)) {}

void FaultServer::receive() {
  constexpr std::size_t kMostClients = 4;
  constexpr std::size_t kMostCharacters = 100;
  while (clients_.size() < kMostClients) {
    auto connection = listener_.accept();
    if (!connection) break;
    clients_.push_back({std::move(*connection)});
  }
  for (Client& client : clients_) {
    for (const std::uint8_t byte : client.connection.read()) {
      if (byte == '\n') {
        client.connection.write(answer(std::exchange(client.line, {})) + "\n");
      } else if (byte != '\r' && client.line.size() < kMostCharacters) {
        client.line.push_back(static_cast<char>(byte));
      }
    }
    client.connection.flush();
  }
  std::erase_if(clients_, [](const Client& client) { return !client.connection.is_open(); });
}

std::string FaultServer::answer(const std::string& order) const {
  const auto space = order.find(' ');
  const std::string name = order.substr(0, space);
  const auto device =
      std::find_if(devices_.begin(), devices_.end(), [&](const Breakable& one) { return one.name == name; });
  if (device == devices_.end()) {
    std::string names;
    for (const Breakable& one : devices_) names += (names.empty() ? "" : ", ") + one.name;
    return "no device \"" + name + "\"; there are " + names;
  }
  const auto fault = space == std::string::npos ? std::nullopt : hardware_fault(order.substr(space + 1));
  if (!fault) return "say \"" + name + " FAULT\", one of " + hardware_fault_names();
  device->set(*fault);
  return "ok";
}

void FaultServer::add_descriptors(std::vector<int>& descriptors) const {
  descriptors.push_back(listener_.descriptor());
  for (const Client& client : clients_) descriptors.push_back(client.connection.descriptor());
}

}  // namespace tandem::simulator
