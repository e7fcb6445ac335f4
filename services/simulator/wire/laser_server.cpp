#include "services/simulator/wire/laser_server.hpp"

#include <algorithm>
#include <utility>

namespace tandem::simulator {
namespace {

constexpr std::uint64_t kSeed = 7;  // of the noise on a line

}  // namespace

LaserServer::LaserServer(LaserServerOptions options, Time now)
    : options_(std::move(options)),
      listener_(options_.port == 0
                    ? nullptr
                    : std::make_unique<TcpListener>(options_.address, options_.port, "the laser", "laser_port")),
      pty_(options_.pty.empty() ? nullptr : std::make_unique<PseudoTerminal>(options_.pty, "laser_pty")),
      powered_(now) {
  if (pty_) serial_.emplace(dialogue(now));
}

LaserServer::Dialogue LaserServer::dialogue(Time now) const {
  auto device = make_laser_device(options_.model, powered_);
  const Time first_end = now + device->turn_period();
  Dialogue dialogue{std::move(device), FaultyLine{kSeed}, first_end};
  dialogue.line.set(fault_, now);
  return dialogue;
}

bool LaserServer::has_power(Time now) const {
  return fault_ != HardwareFault::Off && now >= powered_ + options_.boot;
}

void LaserServer::receive(Time now) {
  constexpr std::size_t kMostClients = 8;
  while (listener_ && has_power(now) && clients_.size() < kMostClients) {
    auto connection = listener_->accept();
    if (!connection) break;
    clients_.push_back({std::move(*connection), dialogue(now)});
  }
  for (auto& client : clients_) receive_from(client.connection, client.dialogue, now);
  std::erase_if(clients_, [](const Client& client) { return !client.connection.is_open(); });
  if (!serial_) return;
  serial_->device->set_line_rate(pty_->line_rate());
  receive_from(pty_->connection(), *serial_, now);
}

void LaserServer::receive_from(Connection& connection, Dialogue& dialogue, Time now) {
  const auto bytes = connection.read();
  if (has_power(now) && dialogue.line.hears(now)) {
    connection.write(dialogue.line.pass(dialogue.device->receive(bytes, now), now));
  }
  connection.flush();
}

void LaserServer::step(Simulation& simulation, Time start, Duration length) {
  const Time end = start + length;
  if (!has_power(end)) return;
  for (auto& client : clients_) end_turn(client.connection, client.dialogue, simulation, end);
  if (serial_) {
    serial_->device->set_line_rate(pty_->line_rate());
    end_turn(pty_->connection(), *serial_, simulation, end);
  }
}

void LaserServer::end_turn(Connection& connection, Dialogue& dialogue, Simulation& simulation, Time end) {
  constexpr std::size_t kUnread = 16'384;  // nobody reads: a serial line would lose these bytes too
  connection.write(dialogue.line.due(end));
  if (end < dialogue.next_turn_end) return;
  // A step may be shorter than a turn: then the beams are spread over the step, the turn's newest part.
  const Duration period = dialogue.device->turn_period();
  dialogue.next_turn_end = std::max(dialogue.next_turn_end + period, end + Duration{1});  // one in a step at most
  if (!dialogue.device->is_measuring() || connection.waiting() > kUnread) return;
  const auto measure = [&](std::span<const Beam> beams) { return measured(dialogue, simulation, beams); };
  connection.write(dialogue.line.pass_message(dialogue.device->end_turn(end - period, measure), end));
}

std::vector<double> LaserServer::measured(Dialogue& dialogue, Simulation& simulation,
                                          std::span<const Beam> beams) const {
  constexpr double kWrong = 0.5;
  if (fault_ == HardwareFault::Stuck && dialogue.last_ranges_m.size() == beams.size()) return dialogue.last_ranges_m;
  auto ranges_m = simulation.scan(beams);
  if (fault_ == HardwareFault::Wrong) {
    for (double& range_m : ranges_m) range_m *= kWrong;
  }
  dialogue.last_ranges_m = ranges_m;
  return ranges_m;
}

void LaserServer::set_fault(HardwareFault fault, Time now) {
  const bool was_off = fault_ == HardwareFault::Off;
  fault_ = fault;
  if (was_off && fault != HardwareFault::Off) {
    powered_ = now;
    clients_.clear();  // it knows nothing of connections it had
    if (serial_) serial_.emplace(dialogue(now));
  }
  for (auto& client : clients_) client.dialogue.line.set(fault, now);
  if (serial_) serial_->line.set(fault, now);
}

void LaserServer::add_descriptors(std::vector<int>& descriptors) const {
  if (listener_) descriptors.push_back(listener_->descriptor());
  for (const auto& client : clients_) descriptors.push_back(client.connection.descriptor());
  if (pty_) descriptors.push_back(pty_->descriptor());
}

}  // namespace tandem::simulator
