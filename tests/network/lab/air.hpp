#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "services/common/random.hpp"
#include "services/common/time.hpp"

namespace tandem::test {

/// An Ethernet frame, from its destination address on.
using Frame = std::vector<std::uint8_t>;
using MacAddress = std::array<std::uint8_t, 6>;

/// What the air does to the frames that one host is to receive. By default: nothing.
struct Conditions {
  double loss = 0.0;                                ///< Share of frames lost at random, [0, 1].
  Duration dead_for{};                              ///< Bursts: nothing arrives for so long at the start of ...
  Duration dead_every{};                            ///< ... each such period; zero: no bursts.
  bool out = false;                                 ///< Nothing arrives at all.
  bool multicast = true;                            ///< False: frames to IPv4 multicast groups are dropped.
  double rate_bps = 0.0;                            ///< Bits per second that fit; 0: no limit.
  double burst_bytes = 0.0;                         ///< So much passes at once after a pause (token bucket).
  Duration queue = std::chrono::milliseconds{300};  ///< At that rate, a frame that would wait longer is lost.
  Duration delay{};                                 ///< Of every frame.
  Duration jitter{};                                ///< Up to so much more, uniform; the order is kept.
  double reordered = 0.0;                           ///< Share of frames held back so that later ones overtake them.
  Duration held_back = std::chrono::milliseconds{20};
  double duplicated = 0.0;  ///< Share of frames that arrive twice.
};

/// The air between the hosts of a laboratory: which frame reaches whom, and when. Equal seed and equal frames at equal
/// times, equal fate.
///
/// Like a switch that knows each host's address: unicast reaches its host alone, broadcast and multicast all others.
/// Only IPv4 and ARP are carried.
class Air {
 public:
  explicit Air(std::uint64_t seed) : seed_(seed) {}

  /// A further host; its number counts from 0.
  std::size_t add_host(const MacAddress& address);
  /// What `host` is to receive, from now on.
  void set(std::size_t host, const Conditions& conditions) { hosts_[host].conditions = conditions; }
  [[nodiscard]] const Conditions& conditions(std::size_t host) const { return hosts_[host].conditions; }

  /// A copy of a frame on its way.
  struct Delivery {
    Time at{};
    std::size_t to = 0;
  };
  /// The fate of `frame`, sent by host `from` at `now`: no, one or more deliveries. Times must not go back.
  [[nodiscard]] std::vector<Delivery> carry(const Frame& frame, std::size_t from, Time now);

  /// Frames and bytes that were sent by a host, and those that reached it.
  struct Count {
    std::uint64_t frames_sent = 0;
    std::uint64_t bytes_sent = 0;
    std::uint64_t frames_received = 0;
    std::uint64_t bytes_received = 0;
    std::uint64_t fragments_sent = 0;  ///< frames with a part of an IPv4 packet that was too large for one
  };
  [[nodiscard]] const Count& count(std::size_t host) const { return hosts_[host].count; }

 private:
  struct Host {
    MacAddress address{};
    Conditions conditions;
    Rng chance;
    Time queue_free{};     // when the last frame that was let in has been sent at the limited rate
    Time last_delivery{};  // jitter must not turn frames round
    Count count;
  };
  void receive(Host& host, std::size_t to, const Frame& frame, bool multicast, Time now,
               std::vector<Delivery>& deliveries) const;

  std::uint64_t seed_;
  std::vector<Host> hosts_;
};

}  // namespace tandem::test
