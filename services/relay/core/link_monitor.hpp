#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "services/common/time.hpp"

namespace tandem {

/// One heartbeat as it travels between two relays. Times are of the sender's clock.
struct Heartbeat {
  std::string host;
  std::uint64_t sequence_number = 0;
  Time sent{};
  // What the sender last heard from the receiver, returned so that the receiver can measure.
  std::string heard_host;
  std::uint64_t heard_sequence_number = 0;
  Time heard_sent{};  ///< the receiver's own stamp
  Duration held{};    ///< how long the sender kept it before this answer
};

/// How the link to one peer is.
struct LinkState {
  std::string peer;  ///< empty while none was heard
  bool up = false;
  bool one_way = false;  ///< we hear the peer, it does not hear us
  double heard_age_s = 0.0;
  double round_trip_s = 0.0;    ///< smoothed
  double loss = 0.0;            ///< [0, 1] over the last heartbeats of the peer
  double clock_offset_s = 0.0;  ///< the peer's clock minus ours, from the exchange with the shortest round trip
};

/// Measures the link by heartbeats both ways, as NTP does: four stamps of an exchange give round trip and offset,
///   round_trip = (t4 - t1) - (t3 - t2),  offset = ((t2 - t1) + (t3 - t4)) / 2,
/// with t1, t4 our clock and t2, t3 the peer's.
class LinkMonitor {
 public:
  /// The link counts as lost when no heartbeat came for `timeout`.
  LinkMonitor(std::string own_host, Duration timeout) : own_host_(std::move(own_host)), timeout_(timeout) {}

  /// The next heartbeat to send at `now`.
  [[nodiscard]] Heartbeat next_heartbeat(Time now);
  /// A heartbeat of another host arrived at `now`. Own ones and repetitions are ignored.
  void heard(const Heartbeat& heartbeat, Time now);
  [[nodiscard]] LinkState state(Time now) const;
  /// The peer's clock minus ours, once measured.
  [[nodiscard]] std::optional<Duration> clock_offset() const;

 private:
  struct Exchange {
    Duration round_trip;
    Duration offset;
  };
  std::string own_host_;
  Duration timeout_;
  std::uint64_t sent_ = 0;
  std::optional<Heartbeat> last_heard_;
  Time last_heard_at_{};
  std::optional<Time> peer_heard_us_at_;     // our clock: when we sent what the peer last confirmed
  std::deque<Exchange> exchanges_;           // the last ones; the shortest round trip has the best offset
  std::deque<std::uint64_t> heard_numbers_;  // for the loss
  double round_trip_s_ = 0.0;
};

}  // namespace tandem
