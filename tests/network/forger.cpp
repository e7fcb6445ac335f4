#include "tests/network/forger.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace tandem::test {
namespace {

constexpr int kFirstPort = 7400;
constexpr int kPortsOfADomain = 250;
constexpr int kMostWriters = 80;
constexpr int kMostIds = 30;  // of participants on one host
constexpr int kMostTries = 200;

using Bytes = std::vector<std::uint8_t>;

sockaddr_in place(const std::string& address, int port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, address.c_str(), &place.sin_addr);
  return place;
}

}  // namespace

Forger::Forger(const LabHost& at, int domain) : domain_(domain) {
  at.run([&] {
    socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    const timeval patience{3, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    ip_mreq group{};
    inet_pton(AF_INET, "239.255.0.1", &group.imr_multiaddr);
    inet_pton(AF_INET, at.address().c_str(), &group.imr_interface);
    const sockaddr_in here = place("0.0.0.0", kFirstPort + kPortsOfADomain * domain);
    if (socket_ < 0 || bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0 ||  // NOLINT
        setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) != 0) {
      throw std::system_error{errno, std::generic_category(), "the group of a domain"};
    }
  });
}

Forger::~Forger() {
  close(socket_);
}

bool Forger::overhear(const std::string& address) {
  const sockaddr_in wanted = place(address, 0);
  for (int i = 0; i < kMostTries; ++i) {
    std::array<std::uint8_t, 2048> message{};
    sockaddr_in from{};
    socklen_t length = sizeof from;
    const auto size = recvfrom(socket_, message.data(), message.size(), 0, reinterpret_cast<sockaddr*>(&from), &length);
    if (size < 0) return false;
    if (size < 20 || from.sin_addr.s_addr != wanted.sin_addr.s_addr) continue;
    std::copy_n(message.begin() + 8, prefix_.size(), prefix_.begin());
    return true;
  }
  return false;
}

void Forger::forge(const std::string& address, const Bytes& payload, std::int64_t number) const {
  send_as_each_writer(address, [&](RtpsDatagram& datagram) { datagram.data(number, payload); });
}

void Forger::forge_end(const std::string& address, const std::array<std::uint8_t, 16>& key, std::int64_t number) const {
  constexpr std::uint8_t kParameters = 0x02;
  Bytes parameters{0x70, 0, 16, 0};  // key hash
  parameters.insert(parameters.end(), key.begin(), key.end());
  const Bytes ended{0x71, 0, 4, 0, 0, 0, 0, 3,  // status: disposed and unregistered
                    1,    0, 0, 0};             // the last
  parameters.insert(parameters.end(), ended.begin(), ended.end());
  send_as_each_writer(address, [&](RtpsDatagram& datagram) { datagram.data(number, parameters, kParameters); });
}

void Forger::forge_gap(const std::string& address, std::int64_t first, std::int64_t last) const {
  send_as_each_writer(address, [&](RtpsDatagram& datagram) { datagram.gap(first, last); });
}

void Forger::send_as_each_writer(const std::string& address, const std::function<void(RtpsDatagram&)>& say) const {
  for (int number = 1; number <= kMostWriters; ++number) {
    for (const std::uint8_t kind : {std::uint8_t{2}, std::uint8_t{3}}) {  // with and without key
      RtpsDatagram datagram{prefix_};
      say(datagram.between({0, 0, static_cast<std::uint8_t>(number), kind}, {}));
      for (int id = 0; id < kMostIds; ++id) {
        const sockaddr_in to = place(address, kFirstPort + kPortsOfADomain * domain_ + 11 + 2 * id);
        sendto(socket_, datagram.bytes().data(), datagram.bytes().size(), 0,
               reinterpret_cast<const sockaddr*>(&to),  // NOLINT
               sizeof to);
      }
    }
  }
}

}  // namespace tandem::test
