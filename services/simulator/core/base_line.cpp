#include "services/simulator/core/base_line.hpp"

#include <utility>

#include "robot/pioneer/core/sip.hpp"

namespace tandem::simulator {
namespace {

using pioneer::Bytes;

constexpr Duration kDelay = std::chrono::milliseconds{400};
constexpr Duration kOnAndOff = std::chrono::seconds{1};
constexpr int kOneIn = 5;
constexpr std::size_t kTypeAt = 3;

/// `packet` with counters that jump about, in good form.
Bytes displaced(const Bytes& packet, Rng& rng) {
  pioneer::PacketReceiver receiver;
  receiver.push(packet, Time{});
  const auto received = receiver.next();
  auto sip = received ? pioneer::decode_sip(*received) : std::nullopt;
  if (!sip) return packet;
  sip->x = static_cast<std::uint16_t>(rng.index(0x8000));
  sip->y = static_cast<std::uint16_t>(rng.index(0x8000));
  return pioneer::framed(pioneer::encode_sip(*sip));
}

}  // namespace

void BaseLine::set_fault(HardwareFault fault, Time now) {
  fault_ = fault;
  since_ = now;
  held_.clear();
}

bool BaseLine::is_cut(Time now) const {
  const bool pausing = (now - since_) / kOnAndOff % 2 == 0;
  return fault_ == HardwareFault::Off || (fault_ == HardwareFault::Intermittent && pausing);
}

Bytes BaseLine::to_controller(std::span<const std::uint8_t> bytes, Time now) {
  if (is_cut(now)) return {};
  return {bytes.begin(), bytes.end()};
}

Bytes BaseLine::to_host(Bytes packet, Time now) {
  if (is_cut(now)) return {};
  packet = spoiled(std::move(packet));
  add_noise(packet);
  if (fault_ != HardwareFault::Delayed) return packet;
  if (!packet.empty()) held_.push_back({std::move(packet), now + kDelay});
  Bytes arrived;
  for (; !held_.empty() && held_.front().until <= now; held_.pop_front()) {
    arrived.insert(arrived.end(), held_.front().bytes.begin(), held_.front().bytes.end());
  }
  return arrived;
}

Bytes BaseLine::spoiled(Bytes packet) {
  const bool is_sip = packet.size() > kTypeAt && pioneer::packet_type::is_sip(packet[kTypeAt]);
  if (fault_ == HardwareFault::Garbage) {
    for (auto& byte : packet) byte = static_cast<std::uint8_t>(rng_.bits());
  }
  if (!is_sip) return packet;
  if (fault_ == HardwareFault::Stuck && !last_.empty()) return last_;
  if (fault_ == HardwareFault::Wrong) return displaced(packet, rng_);
  if (fault_ == HardwareFault::Slow && ++packets_ % kOneIn != 0) return {};
  last_ = packet;
  return packet;
}

void BaseLine::add_noise(Bytes& packet) {
  if (packet.empty() || noise_ <= 0.0) return;
  if (rng_.uniform() < noise_) packet[rng_.index(packet.size())] ^= static_cast<std::uint8_t>(1 + rng_.index(255));
  if (rng_.uniform() < noise_) {
    Bytes garbage(1 + rng_.index(40));
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>(rng_.bits());
    packet.insert(packet.begin(), garbage.begin(), garbage.end());
  }
}

}  // namespace tandem::simulator
