#pragma once

#include <cstdint>

#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::mcap {

/// Writes everything `reader` can read to `writer`, in order of log time; of the messages those from `from_time` on.
/// False once `writer` can take no more.
bool copy(Reader& reader, Writer& writer, std::uint64_t from_time = 0);

}  // namespace tandem::mcap
