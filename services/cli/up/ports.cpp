#include "services/cli/up/ports.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

namespace tandem::cli {
namespace {

/// The port bound, or -1.
int bound_port(const std::string& address, int port) {
  const int socket_fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (socket_fd < 0) return -1;
  const int yes = 1;
  setsockopt(socket_fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, address.c_str(), &name.sin_addr);
  int result = -1;
  if (bind(socket_fd, reinterpret_cast<sockaddr*>(&name), sizeof name) == 0 && listen(socket_fd, 1) == 0) {
    socklen_t length = sizeof name;
    getsockname(socket_fd, reinterpret_cast<sockaddr*>(&name), &length);
    result = ntohs(name.sin_port);
  }
  close(socket_fd);
  return result;
}

}  // namespace

int free_tcp_port(const std::string& address, int preferred) {
  if (const int port = bound_port(address, preferred); port >= 0) return port;
  const int port = bound_port(address, 0);
  if (port < 0) throw std::runtime_error("no free TCP port on " + address);
  return port;
}

}  // namespace tandem::cli
