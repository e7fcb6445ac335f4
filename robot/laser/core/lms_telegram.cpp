#include "robot/laser/core/lms_telegram.hpp"

#include <algorithm>

namespace tandem::lms {
namespace {

constexpr std::uint8_t kStart = 0x02;
constexpr std::size_t kHeader = 4;  // start, address, length
constexpr std::size_t kTrailer = 2;

std::uint16_t number_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | (bytes[at + 1] << 8));
}

}  // namespace

std::uint16_t checksum(std::span<const std::uint8_t> bytes) {
  constexpr std::uint16_t kPolynomial = 0x8005;
  std::uint16_t crc = 0;
  std::uint8_t before = 0;
  for (const std::uint8_t byte : bytes) {
    const bool carry = (crc & 0x8000) != 0;
    crc = static_cast<std::uint16_t>(crc << 1);
    if (carry) crc ^= kPolynomial;
    crc ^= static_cast<std::uint16_t>(byte | (before << 8));
    before = byte;
  }
  return crc;
}

std::string bytes_of(std::uint8_t address, std::span<const std::uint8_t> payload) {
  std::vector<std::uint8_t> bytes{kStart, address, static_cast<std::uint8_t>(payload.size() & 0xFF),
                                  static_cast<std::uint8_t>(payload.size() >> 8)};
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  const std::uint16_t crc = checksum(bytes);
  bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
  return {bytes.begin(), bytes.end()};
}

std::vector<Event> TelegramReader::take(std::span<const std::uint8_t> bytes) {
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  std::vector<Event> events;
  std::size_t at = 0;
  for (; at < waiting_.size();) {
    const std::span<const std::uint8_t> left{waiting_.data() + at, waiting_.size() - at};
    if (left[0] != kStart || (left.size() > 1 && left[1] != address_)) {
      if (left[0] == kAcknowledged) events.push_back({Event::Kind::Acknowledged, {}});
      if (left[0] == kRefused) events.push_back({Event::Kind::Refused, {}});
      ++at;
      continue;
    }
    if (left.size() < kHeader) break;
    const std::size_t length = number_at(left, 2);
    const std::size_t body = kHeader + length;
    if (length == 0 || length > kMostPayload) {
      ++damaged_;
      ++at;
      continue;
    }
    if (left.size() < body + kTrailer) break;
    if (number_at(left, body) != checksum(left.first(body))) {
      ++damaged_;
      ++at;
      continue;
    }
    events.push_back({Event::Kind::Telegram, Payload(left.begin() + kHeader, left.begin() + body)});
    at += body + kTrailer;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(at));
  return events;
}

}  // namespace tandem::lms
