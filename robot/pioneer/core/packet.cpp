#include "robot/pioneer/core/packet.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace tandem::pioneer {
namespace {

constexpr std::uint8_t kHeader0 = 0xFA;
constexpr std::uint8_t kHeader1 = 0xFB;
constexpr std::size_t kMinCount = 3;
constexpr std::size_t kMaxCount = 200;
constexpr std::uint8_t kPositive = 0x3B;
constexpr std::uint8_t kNegative = 0x1B;
constexpr std::uint8_t kString = 0x2B;

std::uint8_t low_byte(int value) {
  return static_cast<std::uint8_t>(value & 0xFF);
}
std::uint8_t high_byte(int value) {
  return static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

}  // namespace

std::uint16_t checksum(std::span<const std::uint8_t> bytes) {
  unsigned sum = 0;
  std::size_t i = 0;
  for (; i + 1 < bytes.size(); i += 2) sum = (sum + ((bytes[i] << 8u) | bytes[i + 1])) & 0xFFFFu;
  if (i < bytes.size()) sum ^= bytes[i];
  return static_cast<std::uint16_t>(sum);
}

Bytes framed(const Packet& packet) {
  assert(packet.body.size() <= kMaxBody);
  Bytes bytes;
  bytes.reserve(packet.body.size() + 6);
  for (const std::size_t byte :
       {std::size_t{kHeader0}, std::size_t{kHeader1}, packet.body.size() + kMinCount, std::size_t{packet.number}}) {
    bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  bytes.insert(bytes.end(), packet.body.begin(), packet.body.end());
  const int sum = checksum(std::span{bytes}.subspan(3));
  bytes.push_back(high_byte(sum));
  bytes.push_back(low_byte(sum));
  return bytes;
}

Bytes command(Command command) {
  return framed({static_cast<std::uint8_t>(command), {}});
}

Bytes command(Command command, int argument) {
  const int magnitude = std::min(std::abs(std::max(argument, -32767)), 32767);
  return framed({static_cast<std::uint8_t>(command),
                 {argument < 0 ? kNegative : kPositive, low_byte(magnitude), high_byte(magnitude)}});
}

Bytes packed_command(Command command, std::uint8_t high, std::uint8_t low) {
  return framed({static_cast<std::uint8_t>(command), {kPositive, low, high}});
}

int HostCommand::integer_or(int otherwise) const {
  const int* integer = std::get_if<int>(&argument);
  return integer ? *integer : otherwise;
}

std::uint16_t HostCommand::packed_bytes() const {
  return static_cast<std::uint16_t>(integer_or(0) & 0xFFFF);
}

std::optional<HostCommand> decode_command(const Packet& packet) {
  const Bytes& body = packet.body;
  if (body.empty()) return HostCommand{packet.number, {}};
  if (body[0] == kString) {
    if (body.size() < 2 || body.size() < 2u + body[1]) return std::nullopt;
    return HostCommand{packet.number, std::string{body.begin() + 2, body.begin() + 2 + body[1]}};
  }
  if ((body[0] != kPositive && body[0] != kNegative) || body.size() < 3) return std::nullopt;
  const int magnitude = body[1] | (body[2] << 8);
  return HostCommand{packet.number, body[0] == kPositive ? magnitude : -magnitude};
}

Packet encode_identity(const Identity& identity) {
  Packet packet{packet_type::kSync2, {}};
  for (const std::string* text : {&identity.name, &identity.robot_class, &identity.subclass}) {
    packet.body.insert(packet.body.end(), text->begin(), text->end());
    packet.body.push_back(0);
  }
  return packet;
}

std::optional<Identity> decode_identity(const Packet& packet) {
  if (packet.number != packet_type::kSync2) return std::nullopt;
  std::string texts[3];
  auto begin = packet.body.begin();
  for (std::string& text : texts) {
    const auto end = std::find(begin, packet.body.end(), 0);
    text.assign(begin, end);
    begin = end == packet.body.end() ? end : end + 1;
  }
  if (texts[2].empty()) return std::nullopt;
  return Identity{texts[0], texts[1], texts[2]};
}

void PacketReceiver::push(std::span<const std::uint8_t> bytes, Time now) {
  if (bytes.empty()) return;
  if (now - last_byte_ > kPatience) settled_ = buffer_.size();
  last_byte_ = now;
  for (const std::uint8_t byte : bytes) buffer_.push_back({byte, now});
}

std::optional<Packet> PacketReceiver::next() {
  while (!buffer_.empty()) {
    const bool settled = settled_ > 0;
    if (buffer_[0].byte != kHeader0 || (buffer_.size() > 1 && buffer_[1].byte != kHeader1)) {
      ++skipped_bytes_;
      drop(1);
      continue;
    }
    const std::size_t available = settled ? settled_ : buffer_.size();
    const std::size_t count = buffer_.size() > 2 ? buffer_[2].byte : kMinCount;
    if (count < kMinCount || count > kMaxCount) {
      skipped_bytes_ += 2;
      drop(2);
      continue;
    }
    if (available < 3 || available < count + 3) {
      if (!settled) return std::nullopt;  // its rest may still come
      const std::size_t header = std::min<std::size_t>(2, available);
      skipped_bytes_ += header;
      drop(header);
      continue;
    }
    Packet packet{buffer_[3].byte, {}, buffer_[0].at};
    Bytes summed;
    for (std::size_t i = 3; i < count + 1; ++i) summed.push_back(buffer_[i].byte);
    const int sent_sum = (buffer_[count + 1].byte << 8) | buffer_[count + 2].byte;
    if (checksum(summed) != sent_sum) {
      ++bad_checksums_;
      skipped_bytes_ += 2;
      drop(2);
      continue;
    }
    packet.body.assign(summed.begin() + 1, summed.end());
    drop(count + 3);
    return packet;
  }
  return std::nullopt;
}

void PacketReceiver::clear() {
  buffer_.clear();
  settled_ = 0;
}

void PacketReceiver::drop(std::size_t count) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(count));
  settled_ -= std::min(settled_, count);
}

}  // namespace tandem::pioneer
