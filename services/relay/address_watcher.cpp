#include "services/relay/address_watcher.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace tandem {

AddressWatcher::AddressWatcher() : socket_(socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE)) {
  sockaddr_nl place{};
  place.nl_family = AF_NETLINK;
  place.nl_groups = RTMGRP_LINK | RTMGRP_IPV4_IFADDR;
  const auto* any = reinterpret_cast<const sockaddr*>(&place);  // NOLINT: the socket interface
  if (socket_ < 0 || bind(socket_, any, sizeof place) != 0) {
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw std::runtime_error("changes of address cannot be watched: " + why);
  }
}

AddressWatcher::~AddressWatcher() {
  close(socket_);
}

bool AddressWatcher::changed() {
  std::array<char, 8192> message{};
  bool any = false;
  // ENOBUFS: the kernel had more to say than fits; something has changed.
  while (recv(socket_, message.data(), message.size(), 0) > 0 || errno == ENOBUFS || errno == EINTR) {
    any = true;
    errno = 0;
  }
  return any;
}

std::vector<InterfaceAddress> AddressWatcher::addresses() {
  std::vector<InterfaceAddress> present;
  ifaddrs* all = nullptr;
  if (getifaddrs(&all) != 0) return present;
  for (const ifaddrs* one = all; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET || (one->ifa_flags & IFF_UP) == 0) continue;
    std::array<char, INET_ADDRSTRLEN> text{};
    const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);  // NOLINT: the socket interface
    if (inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size()) == nullptr) continue;
    present.push_back({one->ifa_name, text.data()});
  }
  freeifaddrs(all);
  return present;
}

}  // namespace tandem
