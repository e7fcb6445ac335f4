#include "services/simulator/wire/laser_server.hpp"

namespace tandem::simulator {

LaserServer::LaserServer(const std::string& address, std::uint16_t port, scip::SensorParameters sensor, Time now)
    : listener_(address, port, "the laser (SCIP 2.0)", "laser_port"),
      sensor_(std::move(sensor)),
      started_(now),
      turn_period_(from_seconds(scip::turn_period_s(sensor_))),
      next_turn_end_(now + turn_period_) {}

void LaserServer::receive(Time now) {
  constexpr std::size_t kMostClients = 8;
  while (clients_.size() < kMostClients) {
    auto connection = listener_.accept();
    if (!connection) break;
    clients_.push_back({std::move(*connection), ScipDevice{sensor_, started_}});
  }
  for (auto& client : clients_) {
    client.connection.write(client.device.receive(client.connection.read(), now));
    client.connection.flush();
  }
  std::erase_if(clients_, [](const Client& client) { return !client.connection.is_open(); });
}

void LaserServer::step(Simulation& simulation, Time start, Duration length) {
  if (start + length < next_turn_end_) return;
  // One step may be shorter than a turn: then the beams are spread over the step, the turn's newest part.
  const Time turn_start = start + length - turn_period_;
  next_turn_end_ += turn_period_;
  if (next_turn_end_ <= start + length) next_turn_end_ = start + length + turn_period_;
  for (auto& client : clients_) {
    if (!client.device.is_measuring()) continue;
    client.connection.write(client.device.end_turn(
        turn_start, [&](std::span<const ScanBeam> steps) { return simulation.scan(beams_of(steps)); }));
  }
}

std::vector<Beam> LaserServer::beams_of(std::span<const ScanBeam> steps) const {
  std::vector<Beam> beams;
  beams.reserve(steps.size());
  for (const auto& one : steps) {
    beams.push_back({scip::angle_of_step(sensor_, one.step), one.step / sensor_.steps_per_turn});
  }
  return beams;
}

void LaserServer::add_descriptors(std::vector<int>& descriptors) const {
  descriptors.push_back(listener_.descriptor());
  for (const auto& client : clients_) descriptors.push_back(client.connection.descriptor());
}

}  // namespace tandem::simulator
