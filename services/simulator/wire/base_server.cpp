#include "services/simulator/wire/base_server.hpp"

namespace tandem::simulator {

BaseServer::BaseServer(const std::string& address, std::uint16_t port, const std::string& pty_link)
    : listener_(port == 0 ? nullptr : std::make_unique<TcpListener>(address, port, "the base (P2OS)", "base_port")),
      pty_(pty_link.empty() ? nullptr : std::make_unique<PseudoTerminal>(pty_link, "base_pty")) {}

void BaseServer::receive(Simulation& simulation, Time now) {
  if (client_) receive_from(*client_, Host::Tcp, simulation, now);
  if (client_ && !client_->is_open()) {
    client_.reset();
    if (host_ == Host::Tcp) host_ = Host::Nobody;
  }
  if (!client_ && listener_) client_ = listener_->accept();
  if (pty_) receive_from(pty_->connection(), Host::Pty, simulation, now);
}

void BaseServer::receive_from(Connection& connection, Host host, Simulation& simulation, Time now) {
  const auto bytes = connection.read();
  if (bytes.empty()) return;
  host_ = host;
  send(connection, simulation.base_receive(bytes, now));
}

void BaseServer::report(Simulation& simulation, Time now) {
  const auto report = simulation.base_report(now);
  if (report.empty()) return;
  if (host_ == Host::Tcp && client_) send(*client_, report);
  if (host_ == Host::Pty) send(pty_->connection(), report);
}

void BaseServer::send(Connection& connection, const pioneer::Bytes& bytes) {
  constexpr std::size_t kUnread = 4096;  // nobody reads: a serial line would lose these bytes too
  connection.flush();
  if (connection.waiting() < kUnread) connection.write(bytes);
}

void BaseServer::add_descriptors(std::vector<int>& descriptors) const {
  if (client_) {
    descriptors.push_back(client_->descriptor());
  } else if (listener_) {
    descriptors.push_back(listener_->descriptor());
  }
  if (pty_) descriptors.push_back(pty_->descriptor());
}

}  // namespace tandem::simulator
