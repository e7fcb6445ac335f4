#include "services/bus/core/rtps_message.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace tandem::bus {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeader = 20;
constexpr std::uint8_t kMajorVersion = 2;
constexpr std::uint32_t kMostInASet = 256;
/// No message of ours is as long: a piece of a longer one would make the reader take memory for all of it.
constexpr std::uint32_t kMostBytesOfASample = 64U << 20;

enum Id : std::uint8_t {
  kPad = 0x01,
  kAckNack = 0x06,
  kHeartbeat = 0x07,
  kGap = 0x08,
  kInfoTimestamp = 0x09,
  kInfoSource = 0x0c,
  kInfoDestination = 0x0e,
  kNackFrag = 0x12,
  kHeartbeatFrag = 0x13,
  kData = 0x15,
  kDataFrag = 0x16,
};

constexpr std::uint8_t kLittleEndian = 0x01;
constexpr std::uint8_t kInlineQos = 0x02;    // of DATA and DATA_FRAG
constexpr std::uint8_t kNoTimestamp = 0x02;  // of INFO_TS
constexpr std::uint8_t kDataAndKey = 0x0c;   // of DATA: it has either
constexpr std::uint16_t kParametersEnd = 0x0001;
constexpr std::uint16_t kKeyHash = 0x0070;
constexpr std::uint16_t kStatus = 0x0071;

/// Reads numbers one after the other; once one does not fit, all that follow are 0 and `fits` is false.
class Reader {
 public:
  Reader(Bytes bytes, bool little_endian) : bytes_(bytes), little_endian_(little_endian) {}

  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

  void skip(std::size_t count) { std::ignore = take(count); }
  std::uint16_t u16() { return static_cast<std::uint16_t>(number(2)); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(number(4)); }
  /// Two numbers of four bytes, the upper first whatever the order of bytes. One that is beyond all reason is as good
  /// as another; so that it can be added to, it is a little less.
  std::int64_t sequence_number() {
    constexpr std::int64_t kMost = INT64_MAX / 2;
    const std::uint64_t high = number(4);
    return std::clamp(static_cast<std::int64_t>(high << 32U | number(4)), -kMost, kMost);
  }
  template <std::size_t N>
  std::array<std::uint8_t, N> array() {
    std::array<std::uint8_t, N> all{};
    const Bytes taken = take(N);
    std::copy(taken.begin(), taken.end(), all.begin());
    return all;
  }

 private:
  Bytes take(std::size_t count) {
    fits_ = fits_ && count <= bytes_.size();
    if (!fits_) return {};
    const Bytes taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  std::uint64_t number(std::size_t size) {
    const Bytes taken = take(size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      value = value << 8U | taken[little_endian_ ? taken.size() - 1 - i : i];
    }
    return value;
  }

  Bytes bytes_;
  bool little_endian_;
  bool fits_ = true;
};

/// A set of numbers from `base` on, as far as its bits go; the base has been read. Its length, or nothing.
std::optional<std::uint32_t> length_of_set(Reader& reader) {
  const std::uint32_t bits = reader.u32();
  if (bits > kMostInASet) return std::nullopt;
  reader.skip((bits + 31U) / 32U * 4U);
  return reader.fits() ? std::optional{bits} : std::nullopt;
}

/// Skips the parameters that stand before a payload. False if they do not fit, or do not end.
bool skip_parameters(Reader& reader) {
  while (reader.left() >= 4) {
    const std::uint16_t id = reader.u16();
    const std::uint16_t length = reader.u16();
    if (id == kParametersEnd) return true;
    if ((id == kKeyHash && length != 16) || (id == kStatus && length != 4) || length > reader.left()) return false;
    reader.skip(length);
  }
  return false;
}

void read_endpoints(Reader& reader, RtpsSubmessage& to) {
  to.reader = reader.array<4>();
  to.writer = reader.array<4>();
}

bool read_sample(Reader& reader, std::uint8_t flags, bool is_fragment, RtpsSubmessage& to) {
  const std::size_t fixed = is_fragment ? 28 : 16;  // from behind the number of octets to the parameters
  reader.skip(2);
  const std::size_t to_parameters = reader.u16();
  const std::size_t left = reader.left();
  read_endpoints(reader, to);
  to.first = to.last = reader.sequence_number();
  if (is_fragment) {
    const std::uint64_t first = reader.u32();
    const std::uint64_t count = reader.u16();
    const std::uint64_t size = reader.u16();
    const std::uint64_t whole = reader.u32();
    if (first == 0 || count == 0 || size == 0 || whole == 0 || whole > kMostBytesOfASample) return false;
    if ((first - 1) * size >= whole || (first + count - 2) * size >= whole) return false;
  } else if ((flags & kDataAndKey) == kDataAndKey) {
    return false;
  }
  if (!reader.fits() || to_parameters < fixed || to_parameters > left) return false;
  reader.skip(to_parameters - fixed);
  return (flags & kInlineQos) == 0 || skip_parameters(reader);
}

bool read_available(Reader& reader, RtpsSubmessage& to) {
  read_endpoints(reader, to);
  to.first = reader.sequence_number();
  to.last = reader.sequence_number();
  reader.skip(4);  // count
  return reader.fits();
}

bool read_gap(Reader& reader, RtpsSubmessage& to) {
  read_endpoints(reader, to);
  to.first = reader.sequence_number();
  to.last = reader.sequence_number() - 1;
  return length_of_set(reader).has_value();
}

bool read_answer(Reader& reader, RtpsSubmessage& to) {
  read_endpoints(reader, to);
  to.first = reader.sequence_number();
  const auto bits = length_of_set(reader);
  to.last = to.first + bits.value_or(0);
  reader.skip(4);  // count
  return bits && reader.fits();
}

/// Pieces of one sample that a reader asks for, or that a writer has.
bool read_pieces(Reader& reader, bool asks, RtpsSubmessage& to) {
  read_endpoints(reader, to);
  to.first = to.last = reader.sequence_number();
  reader.skip(4);  // the first piece of the set, or the last there is
  if (asks && !length_of_set(reader)) return false;
  reader.skip(4);  // count
  return reader.fits();
}

struct Context {
  ParticipantId source{};
  std::vector<RtpsSubmessage> said;
};

/// False if the submessage is malformed.
bool read_submessage(std::uint8_t id, std::uint8_t flags, Bytes body, Context& context) {
  using Kind = RtpsSubmessage::Kind;
  Reader reader{body, (flags & kLittleEndian) != 0};
  RtpsSubmessage submessage;
  submessage.source = context.source;
  const auto say = [&](Kind kind, bool well_formed) {
    submessage.kind = kind;
    if (well_formed) context.said.push_back(submessage);
    return well_formed;
  };
  switch (id) {
    case kData:
    case kDataFrag:
      return say(Kind::Sample, read_sample(reader, flags, id == kDataFrag, submessage));
    case kHeartbeat:
      return say(Kind::Available, read_available(reader, submessage));
    case kGap:
      return say(Kind::Gap, read_gap(reader, submessage));
    case kAckNack:
      return say(Kind::Answer, read_answer(reader, submessage));
    case kNackFrag:
      return say(Kind::Answer, read_pieces(reader, true, submessage));
    case kHeartbeatFrag:
      return say(Kind::Sample, read_pieces(reader, false, submessage));
    case kInfoTimestamp:
      return (flags & kNoTimestamp) != 0 || body.size() >= 8;
    case kInfoDestination:
      return body.size() >= 12;
    case kInfoSource:
      reader.skip(8);  // unused, version, vendor
      context.source = reader.array<12>();
      return reader.fits();
    default:  // encrypted, of another vendor, or of no consequence
      return true;
  }
}

}  // namespace

std::optional<std::vector<RtpsSubmessage>> submessages_of(Bytes message) {
  constexpr std::array<std::uint8_t, 4> kMagic{'R', 'T', 'P', 'S'};
  if (message.size() < kHeader || !std::equal(kMagic.begin(), kMagic.end(), message.begin())) return std::nullopt;
  if (message[4] > kMajorVersion) return std::nullopt;
  Context context;
  std::copy_n(message.begin() + 8, context.source.size(), context.source.begin());
  Bytes rest = message.subspan(kHeader);
  while (!rest.empty()) {
    if (rest.size() < 4) return std::nullopt;
    Reader header{rest, (rest[1] & kLittleEndian) != 0};
    header.skip(2);
    const std::size_t length = header.u16();
    const Bytes body = rest.subspan(4);
    if (length > body.size()) return std::nullopt;
    // The last submessage need not say how long it is; two kinds have nothing to say.
    const bool is_last = length == 0 && rest[0] != kInfoTimestamp && rest[0] != kPad;
    if (!read_submessage(rest[0], rest[1], is_last ? body : body.first(length), context)) return std::nullopt;
    const std::size_t padded = is_last ? body.size() : (length + 3) / 4 * 4;
    rest = body.subspan(std::min(padded, body.size()));
  }
  return std::move(context.said);
}

}  // namespace tandem::bus
