#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/recorder/core/carmen_log.hpp"
#include "services/recorder/core/mcap_writer.hpp"

namespace tandem::recorder {

/// Writes `events` as topics `odometry` and `scan` of the robot `robot`.
///
/// Stamps are the log's seconds from Unix 0 on: t = 12.5 s has stamp 12 500 000 000 ns. The laser is at the robot's
/// origin. A recording's log time never goes back, so it stands still where the log's times do (stamps are kept).
void write_carmen(const std::vector<carmen::Event>& events, const std::string& robot, mcap::Writer& writer);

}  // namespace tandem::recorder
