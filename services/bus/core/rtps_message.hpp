#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "services/bus/core/endpoint_table.hpp"

namespace tandem::bus {

/// Identifies a writer or a reader within its participant: the last bytes of its id, of which the very last is its
/// kind.
using EntityId = std::array<std::uint8_t, 4>;

/// What a submessage of an RTPS message says of the samples of one writer.
struct RtpsSubmessage {
  enum class Kind {
    Sample,     ///< the sample `first`, or a piece of it; `last` is the same
    Available,  ///< a writer has the samples `first` to `last`; nothing if `last` is one less
    Gap,        ///< a writer will never send the samples `first` to `last`
    Answer,     ///< a reader has all samples before `first`, and asks for some up to `last`; `first` is 0 at the start
  };
  Kind kind = Kind::Sample;
  ParticipantId source{};  ///< whose it claims to be
  EntityId reader{};
  EntityId writer{};
  std::int64_t first = 0;
  std::int64_t last = 0;
};

/// What an RTPS message says of samples, in order; nothing if it is no RTPS message, or if lengths, sets or parameters
/// in it do not fit. Payloads, announcements and whatever is encrypted are not looked into.
///
/// DDS Interoperability Wire Protocol 2.3, sections 8.3 and 9.4; lengths are read as Fast DDS 2.9 reads them.
[[nodiscard]] std::optional<std::vector<RtpsSubmessage>> submessages_of(std::span<const std::uint8_t> message);

}  // namespace tandem::bus
