#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/recorder/core/clock_line.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::recorder {

/// A recording that is merged with others.
struct MergedRecording {
  mcap::Reader* reader = nullptr;
  std::string host;  ///< whose it is; its attachments are put under this name
  /// How far the first recording's clock is ahead of this one's, over this one's time.
  ClockLine first_clock{0.0};
};

/// How much a merge wrote.
struct MergeCount {
  std::uint64_t written = 0;
  std::uint64_t doubled = 0;  ///< left out: the relay had brought them to another host, and both recorded them
};

/// Writes all of `recordings` into one, in order of log time by the clock of the first.
///
/// Log and publish times are put on that clock; the stamps inside the payloads stay as they are. A payload that is on
/// one topic of several recordings is one message that the relay forwarded, unchanged: it is written once, when it was
/// there first; where it comes k times in one recording it comes k times. Throws McapError where the same topic has two
/// different schemas.
[[nodiscard]] MergeCount merge(const std::vector<MergedRecording>& recordings, mcap::Writer& writer);

}  // namespace tandem::recorder
