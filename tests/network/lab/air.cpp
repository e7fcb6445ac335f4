#include "tests/network/lab/air.hpp"

#include <algorithm>

namespace tandem::test {
namespace {

constexpr std::size_t kHeaderSize = 14;

bool is_carried(const Frame& frame) {
  if (frame.size() < kHeaderSize) return false;
  const bool ipv4 = frame[12] == 0x08 && frame[13] == 0x00;
  const bool arp = frame[12] == 0x08 && frame[13] == 0x06;
  return ipv4 || arp;
}

bool goes_to_many(const Frame& frame) {
  return (frame[0] & 1) != 0;
}

bool is_ipv4_multicast(const Frame& frame) {
  return frame[0] == 0x01 && frame[1] == 0x00 && frame[2] == 0x5E;
}

bool is_fragment(const Frame& frame) {
  constexpr std::size_t kFragmentation = kHeaderSize + 6;  // flags and offset in IPv4's header
  const bool ipv4 = frame[12] == 0x08 && frame[13] == 0x00;
  if (!ipv4 || frame.size() < kFragmentation + 2) return false;
  return (frame[kFragmentation] & 0x3f) != 0 || frame[kFragmentation + 1] != 0;  // more to come, or not the first
}

}  // namespace

std::size_t Air::add_host(const MacAddress& address) {
  hosts_.push_back({address, {}, Rng{seed_ + hosts_.size()}, {}, {}, {}});
  return hosts_.size() - 1;
}

std::vector<Air::Delivery> Air::carry(const Frame& frame, std::size_t from, Time now) {
  std::vector<Delivery> deliveries;
  if (!is_carried(frame)) return deliveries;
  ++hosts_[from].count.frames_sent;
  hosts_[from].count.bytes_sent += frame.size();
  if (is_fragment(frame)) ++hosts_[from].count.fragments_sent;
  for (std::size_t to = 0; to < hosts_.size(); ++to) {
    if (to == from) continue;
    const bool meant =
        goes_to_many(frame) || std::equal(hosts_[to].address.begin(), hosts_[to].address.end(), frame.begin());
    if (meant) receive(hosts_[to], to, frame, is_ipv4_multicast(frame), now, deliveries);
  }
  return deliveries;
}

void Air::receive(Host& host, std::size_t to, const Frame& frame, bool multicast, Time now,
                  std::vector<Delivery>& deliveries) const {
  const Conditions& conditions = host.conditions;
  // Every frame draws the same numbers, so that one condition does not change the chance of another.
  const double loss = host.chance.uniform();
  const double jitter = host.chance.uniform();
  const double reordering = host.chance.uniform();
  const double duplication = host.chance.uniform();
  if (conditions.out || loss < conditions.loss || (multicast && !conditions.multicast)) return;
  if (conditions.dead_every > Duration::zero() &&
      now.time_since_epoch() % conditions.dead_every < conditions.dead_for) {
    return;
  }
  Time at = now;
  if (conditions.rate_bps > 0.0) {
    const auto sending = [&](double bytes) { return from_seconds(8.0 * bytes / conditions.rate_bps); };
    const Time begin = std::max(now - sending(conditions.burst_bytes), host.queue_free);
    if (begin - now > conditions.queue) return;
    host.queue_free = begin + sending(static_cast<double>(frame.size()));
    at = std::max(now, host.queue_free);
  }
  at += conditions.delay + Duration{static_cast<std::int64_t>(jitter * static_cast<double>(conditions.jitter.count()))};
  if (reordering < conditions.reordered) {
    at += conditions.held_back;
  } else {
    at = std::max(at, host.last_delivery);
    host.last_delivery = at;
  }
  const int copies = duplication < conditions.duplicated ? 2 : 1;
  for (int i = 0; i < copies; ++i) {
    ++host.count.frames_received;
    host.count.bytes_received += frame.size();
    deliveries.push_back({at, to});
  }
}

}  // namespace tandem::test
