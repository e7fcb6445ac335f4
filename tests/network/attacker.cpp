#include "tests/network/attacker.hpp"

#include <arpa/inet.h>
#include <linux/if_ether.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace tandem::test {
namespace {

using std::chrono::seconds;

std::size_t below(Rng& rng, std::size_t bound) {
  return static_cast<std::size_t>(rng.bits() % bound);
}

/// Appends the UDP payload of an IP packet if it is RTPS.
void append(std::vector<Seen>& seen, const Datagram& ip) {
  constexpr std::size_t kUdpHeader = 8;
  if (ip.size() < 20 || ip[0] >> 4 != 4 || ip[9] != IPPROTO_UDP) return;
  const std::size_t udp = (ip[0] & 0xFU) * 4U;
  if (ip.size() < udp + kUdpHeader + 4 || std::memcmp(&ip[udp + kUdpHeader], "RTPS", 4) != 0) return;
  const auto port = static_cast<std::uint16_t>(ip[udp + 2] << 8 | ip[udp + 3]);
  seen.push_back({port, {ip.begin() + static_cast<std::ptrdiff_t>(udp + kUdpHeader), ip.end()}});
}

}  // namespace

Sniffer::Sniffer(const LabHost& host)
    : socket_(host.run([] { return socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_ALL)); })) {
  if (socket_ < 0) throw std::system_error{errno, std::generic_category(), "a sniffer"};
}

Sniffer::~Sniffer() {
  close(socket_);
}

std::vector<Seen> Sniffer::listen(std::size_t count) const {
  std::vector<Seen> seen;
  const SteadyClock clock;
  const Time end = clock.now() + seconds{10};
  std::array<std::uint8_t, 65536> packet{};
  while (seen.size() < count && clock.now() < end) {
    pollfd waiting{socket_, POLLIN, 0};
    if (poll(&waiting, 1, 100) <= 0) continue;
    const ssize_t size = recv(socket_, packet.data(), packet.size(), 0);
    if (size > 0) append(seen, {packet.begin(), packet.begin() + size});
  }
  return seen;
}

Attacker::Attacker(const LabHost& host)
    : socket_(host.run([] { return socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0); })) {
  if (socket_ < 0) throw std::system_error{errno, std::generic_category(), "an attacker"};
}

Attacker::~Attacker() {
  close(socket_);
}

void Attacker::send(const Datagram& payload, const std::string& address, std::uint16_t port) const {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  inet_pton(AF_INET, address.c_str(), &to.sin_addr);
  // A port where nobody listens answers with an error, which the next call reports: it is sent all the same.
  std::ignore = sendto(socket_, payload.data(), payload.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
}

std::set<std::uint16_t> open_ports(const LabHost& host) {
  in_addr own{};
  inet_pton(AF_INET, host.address().c_str(), &own);
  std::set<std::uint16_t> ports;
  host.run([&] {
    std::ifstream file{"/proc/thread-self/net/udp"};
    std::string line;
    std::getline(file, line);  // names of the columns
    while (std::getline(file, line)) {
      // "  12: 0100420A:1D56 ...": address as the machine keeps it, and port
      const auto colon = line.find(':', line.find(':') + 1);
      const auto address = static_cast<in_addr_t>(std::stoul(line.substr(colon - 8, 8), nullptr, 16));
      const auto port = static_cast<std::uint16_t>(std::stoul(line.substr(colon + 1, 4), nullptr, 16));
      if (address == INADDR_ANY || address == own.s_addr) ports.insert(port);
    }
  });
  return ports;
}

Datagram noise(const Seen& /*seen*/, Rng& rng) {
  Datagram bytes(1 + below(rng, 1400));
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(rng.bits());
  return bytes;
}

Datagram truncated_header(const Seen& seen, Rng& rng) {
  Datagram bytes = seen.payload;
  bytes.resize(std::min<std::size_t>(bytes.size(), 1 + below(rng, 28)));
  return bytes;
}

Datagram mutated(const Seen& seen, Rng& rng) {
  Datagram bytes = seen.payload;
  const std::size_t from = below(rng, 4) == 0 ? 4 : 20;
  for (std::size_t changes = 1 + below(rng, 8); changes > 0 && bytes.size() > from; --changes) {
    const std::size_t at = from + below(rng, bytes.size() - from);
    if (below(rng, 10) == 0) {
      bytes.resize(at);
    } else {
      bytes[at] = below(rng, 3) == 0 ? 0xFF : static_cast<std::uint8_t>(rng.bits());
    }
  }
  return bytes;
}

}  // namespace tandem::test
