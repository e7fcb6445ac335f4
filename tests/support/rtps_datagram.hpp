#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace tandem::test {

/// An RTPS message written by hand, submessage by submessage, in either order of bytes.
class RtpsDatagram {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using Entity = std::array<std::uint8_t, 4>;
  enum class Order { LittleEndian, BigEndian };

  explicit RtpsDatagram(const std::array<std::uint8_t, 12>& participant = {1, 15, 1}, Order order = Order::LittleEndian)
      : little_(order == Order::LittleEndian), bytes_{'R', 'T', 'P', 'S', 2, 3, 1, 15} {
    bytes_.insert(bytes_.end(), participant.begin(), participant.end());
  }

  /// The endpoints of what follows: from this writer, to this reader; zeros are "any reader".
  RtpsDatagram& between(const Entity& writer, const Entity& reader) {
    writer_ = writer;
    reader_ = reader;
    return *this;
  }
  /// A sample; `flags` say what is in `content` (0x04: a payload, 0x02: parameters).
  RtpsDatagram& data(std::int64_t number, const Bytes& content, std::uint8_t flags = 0x04) {
    Bytes body;
    append(body, 0, 2);
    append(body, 16, 2);  // octets to the content
    append_endpoints(body);
    append_number(body, number);
    body.insert(body.end(), content.begin(), content.end());
    return submessage(0x15, flags, body);
  }
  /// One piece, the `piece`th, of a sample of `whole` bytes in pieces of `size`.
  RtpsDatagram& data_fragment(std::int64_t number, std::uint32_t piece, std::uint16_t size, std::uint32_t whole) {
    Bytes body;
    append(body, 0, 2);
    append(body, 28, 2);
    append_endpoints(body);
    append_number(body, number);
    append(body, piece, 4);
    append(body, 1, 2);
    append(body, size, 2);
    append(body, whole, 4);
    body.resize(body.size() + size);
    return submessage(0x16, 0, body);
  }
  RtpsDatagram& heartbeat(std::int64_t first, std::int64_t last) {
    Bytes body;
    append_endpoints(body);
    append_number(body, first);
    append_number(body, last);
    append(body, 1, 4);  // count
    return submessage(0x07, 0, body);
  }
  /// Of the samples `first` to `last`.
  RtpsDatagram& gap(std::int64_t first, std::int64_t last) {
    Bytes body;
    append_endpoints(body);
    append_number(body, first);
    append_set(body, last + 1, 0);
    return submessage(0x08, 0, body);
  }
  /// Everything before `base` is there; the `bits` from there on are asked for.
  RtpsDatagram& answer(std::int64_t base, std::uint32_t bits) {
    Bytes body;
    append_endpoints(body);
    append_set(body, base, bits);
    append(body, 1, 4);  // count
    return submessage(0x06, 0, body);
  }
  RtpsDatagram& submessage(std::uint8_t id, std::uint8_t flags, const Bytes& body) {
    bytes_.push_back(id);
    bytes_.push_back(static_cast<std::uint8_t>(flags | (little_ ? 1 : 0)));
    append(bytes_, static_cast<std::uint32_t>(body.size()), 2);
    bytes_.insert(bytes_.end(), body.begin(), body.end());
    return *this;
  }

  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  void append(Bytes& to, std::uint32_t value, unsigned size) const {
    for (unsigned i = 0; i < size; ++i) {
      to.push_back(static_cast<std::uint8_t>(value >> 8U * (little_ ? i : size - 1 - i)));
    }
  }
  void append_number(Bytes& to, std::int64_t number) const {
    append(to, static_cast<std::uint32_t>(static_cast<std::uint64_t>(number) >> 32U), 4);
    append(to, static_cast<std::uint32_t>(number), 4);
  }
  void append_set(Bytes& to, std::int64_t base, std::uint32_t bits) const {
    append_number(to, base);
    append(to, bits, 4);
    to.resize(to.size() + (bits + 31) / 32 * 4, 0xff);
  }
  void append_endpoints(Bytes& to) const {
    to.insert(to.end(), reader_.begin(), reader_.end());
    to.insert(to.end(), writer_.begin(), writer_.end());
  }

  bool little_;
  Bytes bytes_;
  Entity writer_{0, 0, 1, 2};
  Entity reader_{};
};

}  // namespace tandem::test
