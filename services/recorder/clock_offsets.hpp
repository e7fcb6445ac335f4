#pragma once

#include <optional>
#include <string>

#include "services/recorder/core/clock_line.hpp"
#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::recorder {

/// The host that made a recording; empty if it does not say.
[[nodiscard]] std::string host_of(mcap::Reader& reader);

/// How far the clock of the host `first` is ahead of that of `other`'s host, over the time of `other`, as the relays of
/// both measured it (link_status); zero for two parts of one host's recording, none where neither has measured it.
[[nodiscard]] std::optional<ClockLine> clock_ahead(mcap::Reader& first, mcap::Reader& other);

}  // namespace tandem::recorder
