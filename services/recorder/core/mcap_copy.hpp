#pragma once

#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::mcap {

/// Writes everything `reader` can read to `writer`, in order of log time. False once `writer` can take no more.
bool copy(Reader& reader, Writer& writer);

}  // namespace tandem::mcap
