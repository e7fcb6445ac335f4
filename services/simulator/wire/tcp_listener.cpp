#include "services/simulator/wire/tcp_listener.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace tandem::simulator {
namespace {

[[noreturn]] void fail(int descriptor, int error, const std::string& place, const std::string& purpose,
                       const std::string& config_key) {
  if (descriptor >= 0) ::close(descriptor);
  std::string what = "cannot listen on " + place + " for " + purpose + ": ";
  if (error == EADDRINUSE) {
    what += "the port is taken; stop the program that uses it (ss -ltnp shows it), or set " + config_key +
            " in simulator.toml";
  } else {
    what += std::generic_category().message(error) + "; see address and " + config_key + " in simulator.toml";
  }
  throw std::runtime_error(what);
}

}  // namespace

TcpListener::TcpListener(const std::string& address, std::uint16_t port, const std::string& purpose,
                         const std::string& config_key) {
  const std::string place = address + ":" + std::to_string(port);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  if (::inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1) fail(-1, EINVAL, place, purpose, config_key);
  const int descriptor = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor < 0) fail(-1, errno, place, purpose, config_key);
  const int on = 1;
  ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (::bind(descriptor, reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0 || ::listen(descriptor, 8) != 0) {
    fail(descriptor, errno, place, purpose, config_key);
  }
  socklen_t size = sizeof name;
  ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&name), &size);
  descriptor_ = descriptor;
  port_ = ntohs(name.sin_port);
}

TcpListener::~TcpListener() {
  ::close(descriptor_);
}

std::optional<Connection> TcpListener::accept() {
  const int client = ::accept4(descriptor_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (client < 0) return std::nullopt;
  const int on = 1;
  ::setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return Connection{client};
}

}  // namespace tandem::simulator
