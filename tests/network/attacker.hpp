#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "services/common/random.hpp"
#include "tests/network/lab/laboratory.hpp"

namespace tandem::test {

using Datagram = std::vector<std::uint8_t>;

/// A datagram as it was seen on the air, and the port it went to.
struct Seen {
  std::uint16_t port = 0;
  Datagram payload;
};

/// Listens at a host's interface to RTPS messages, both ways.
class Sniffer {
 public:
  explicit Sniffer(const LabHost& host);
  ~Sniffer();
  Sniffer(const Sniffer&) = delete;
  Sniffer& operator=(const Sniffer&) = delete;

  /// The next `count` messages, or what passes within ten seconds.
  [[nodiscard]] std::vector<Seen> listen(std::size_t count) const;

 private:
  int socket_;
};

/// Sends datagrams from a host of the laboratory.
class Attacker {
 public:
  explicit Attacker(const LabHost& host);
  ~Attacker();
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  void send(const Datagram& payload, const std::string& address, std::uint16_t port) const;

 private:
  int socket_;
};

/// UDP ports of a host that can be reached from the air: sockets bound to its address there or to any.
[[nodiscard]] std::set<std::uint16_t> open_ports(const LabHost& host);

// Datagrams made of one that was `seen`.

/// Anything, of any length.
[[nodiscard]] Datagram noise(const Seen& seen, Rng& rng);
/// The first bytes of the message, within the header of the message or of its first submessage.
[[nodiscard]] Datagram truncated_header(const Seen& seen, Rng& rng);
/// The message with one to eight bytes changed, or cut, behind its header; one in four pretends to be of another vendor
/// or participant as well.
[[nodiscard]] Datagram mutated(const Seen& seen, Rng& rng);

}  // namespace tandem::test
