#include "tests/network/lab/laboratory.hpp"

#include <arpa/inet.h>
#include <linux/ethtool.h>
#include <linux/if_packet.h>
#include <linux/sockios.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <queue>
#include <stdexcept>
#include <system_error>

namespace tandem::test {
namespace {

constexpr std::size_t kLargestFrame = 2048;
constexpr int kSocketBuffer = 4 << 20;

MacAddress mac_of(std::size_t number) {
  return {2, 0, 0, 0, 0, static_cast<std::uint8_t>(number + 1)};
}

std::string text_of(const MacAddress& mac) {
  std::array<char, 18> text{};
  std::snprintf(text.data(), text.size(), "%02x:%02x:%02x:%02x:%02x:%02x", mac[0], mac[1], mac[2], mac[3], mac[4],
                mac[5]);
  return text.data();
}

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error{errno, std::generic_category(), what};
}

/// A frame must have its checksums when it is read from a raw socket: the interface leaves them to nobody.
void finish_checksums(const std::string& interface) {
  const int any = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ethtool_value off{ETHTOOL_STXCSUM, 0};
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  request.ifr_data = reinterpret_cast<char*>(&off);  // NOLINT: the interface of ioctl
  const int result = ioctl(any, SIOCETHTOOL, &request);
  close(any);
  if (result != 0) fail("checksums of " + interface);
}

/// ARP asks anew each second, three times, and is then silent for a while: a lost answer would be measured as a gap of
/// whatever is being tested.
void ask_again_for_addresses(const std::string& interface) {
  const std::string folder = "/proc/sys/net/ipv4/neigh/" + interface + "/";
  std::ofstream{folder + "retrans_time_ms"} << 100;
  std::ofstream{folder + "ucast_solicit"} << 20;
  std::ofstream{folder + "mcast_solicit"} << 20;
}

int raw_socket(const std::string& interface) {
  const int raw = socket(AF_PACKET, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, htons(ETH_P_ALL));
  if (raw < 0) fail("raw socket");
  sockaddr_ll place{};
  place.sll_family = AF_PACKET;
  place.sll_protocol = htons(ETH_P_ALL);
  place.sll_ifindex = static_cast<int>(if_nametoindex(interface.c_str()));
  const int on = 1;
  const bool ready = bind(raw, reinterpret_cast<sockaddr*>(&place), sizeof place) == 0 &&  // NOLINT: socket interface
                     setsockopt(raw, SOL_PACKET, PACKET_IGNORE_OUTGOING, &on, sizeof on) == 0;
  if (!ready) fail("raw socket at " + interface);
  setsockopt(raw, SOL_SOCKET, SO_RCVBUF, &kSocketBuffer, sizeof kSocketBuffer);  // what the machine allows of it
  return raw;
}

}  // namespace

LabHost::LabHost(std::string name, std::size_t number)
    : name_(std::move(name)), number_(number), address_("10.66.0." + std::to_string(number + 1)) {
  const std::string air_end = "air" + std::to_string(number);
  run_program({"ip", "link", "add", air_end, "type", "veth", "peer", "name", "wifi0", "address",
               text_of(mac_of(number)), "netns", namespace_.path()});
  run_program({"ip", "link", "set", air_end, "up"});
  run([&] {
    run_program({"ip", "link", "set", "lo", "up"});
    finish_checksums("wifi0");
    ask_again_for_addresses("wifi0");
    run_program({"ip", "address", "add", address_ + "/24", "dev", "wifi0"});
    run_program({"ip", "link", "set", "wifi0", "up"});
    add_routes();
  });
}

void LabHost::add_routes() const {
  run_program({"ip", "route", "replace", "224.0.0.0/4", "dev", "wifi0"});
}

void LabHost::change_address(const std::string& address) {
  run([&] {
    run_program({"ip", "address", "del", address_ + "/24", "dev", "wifi0"});
    run_program({"ip", "address", "add", address + "/24", "dev", "wifi0"});
    add_routes();
  });
  address_ = address;
}

void LabHost::interface_down() {
  run([] { run_program({"ip", "link", "set", "wifi0", "down"}); });
}

void LabHost::interface_up() {
  run([&] {
    run_program({"ip", "link", "set", "wifi0", "up"});
    add_routes();
  });
}

Laboratory::Laboratory(const std::vector<std::string>& hosts, std::uint64_t seed) : air_(seed) {
  for (std::size_t number = 0; number < hosts.size(); ++number) {
    hosts_.push_back(std::make_unique<LabHost>(hosts[number], number));
    air_.add_host(mac_of(number));
    sockets_.push_back(raw_socket("air" + std::to_string(number)));
  }
  wake_ = eventfd(0, EFD_CLOEXEC);
  if (wake_ < 0) fail("eventfd");
  carrier_ = std::thread{[this] { carry_frames(); }};
}

Laboratory::~Laboratory() {
  std::ignore = eventfd_write(wake_, 1);
  carrier_.join();
  close(wake_);
  for (const int socket : sockets_) close(socket);
  // The other ends go with them: a namespace lives on as long as something in it does.
  for (const auto& host : hosts_) run_program({"ip", "link", "del", "air" + std::to_string(host->number())});
}

LabHost& Laboratory::host(const std::string& name) {
  const auto found = std::find_if(hosts_.begin(), hosts_.end(), [&](const auto& host) { return host->name() == name; });
  if (found == hosts_.end()) throw std::runtime_error("no host " + name + " in this laboratory");
  return **found;
}

std::string Laboratory::join_by_cable(const std::string& a, const std::string& b) {
  const std::string number = std::to_string(cables_++);
  const std::string end = "cable" + number;
  run_program({"ip", "link", "add", end, "netns", host(a).network_path(), "type", "veth", "peer", "name", end, "netns",
               host(b).network_path()});
  const std::string network = "10.67." + number + ".";
  for (const auto& [name, address] : {std::pair{a, network + "1"}, std::pair{b, network + "2"}}) {
    host(name).run([&] {
      run_program({"ip", "address", "add", address + "/24", "dev", end});
      run_program({"ip", "link", "set", end, "up"});
    });
  }
  return network + "2";
}

void Laboratory::set(const std::string& name, const Conditions& conditions) {
  const std::lock_guard lock{air_mutex_};
  air_.set(host(name).number(), conditions);
}

void Laboratory::set_all(const Conditions& conditions) {
  const std::lock_guard lock{air_mutex_};
  for (const auto& host : hosts_) air_.set(host->number(), conditions);
}

Air::Count Laboratory::count(const std::string& name) {
  const std::lock_guard lock{air_mutex_};
  return air_.count(host(name).number());
}

void Laboratory::carry_frames() {
  struct Waiting {
    Time at;
    std::uint64_t order;
    std::size_t to;
    Frame frame;
    bool operator>(const Waiting& other) const { return std::tie(at, order) > std::tie(other.at, other.order); }
  };
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
  std::uint64_t order = 0;
  std::vector<pollfd> sources;
  for (const int socket : sockets_) sources.push_back({socket, POLLIN, 0});
  sources.push_back({wake_, POLLIN, 0});
  Frame buffer(kLargestFrame);
  while (true) {
    timespec patience{1, 0};
    if (!waiting.empty()) {
      const auto left = std::max(Duration::zero(), waiting.top().at - clock_.now()).count();
      patience = {left / 1'000'000'000, left % 1'000'000'000};
    }
    ppoll(sources.data(), sources.size(), &patience, nullptr);
    if (sources.back().revents != 0) return;
    for (std::size_t from = 0; from < sockets_.size(); ++from) {
      while (true) {
        const ssize_t size = recv(sockets_[from], buffer.data(), buffer.size(), 0);
        if (size <= 0) break;
        const Frame frame{buffer.begin(), buffer.begin() + size};
        const std::lock_guard lock{air_mutex_};
        for (const auto& delivery : air_.carry(frame, from, clock_.now())) {
          waiting.push({delivery.at, order++, delivery.to, frame});
        }
      }
    }
    while (!waiting.empty() && waiting.top().at <= clock_.now()) {
      const Waiting& due = waiting.top();
      std::ignore = send(sockets_[due.to], due.frame.data(), due.frame.size(), 0);  // an interface may be down
      waiting.pop();
    }
  }
}

bool laboratory_is_required() {
  const char* required = std::getenv("TANDEM_REQUIRE_NETNS");
  return required != nullptr && std::string{required} == "1";
}

}  // namespace tandem::test
