#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "services/recorder/core/carmen_log.hpp"

namespace tandem {

/// The odometry and scans of a log of plain lines, in its order:
///
///  - `# SCAN_GEOMETRY angle_min A angle_increment I n N range_min R range_max R ...`, before the first scan
///  - `SCAN t r1..rN`: a range that is no number, or outside the limits, is no return
///  - `ODOM t x y theta v w`: pose [m, rad], forward speed [m/s], turn rate [rad/s]
///
/// Other `#` lines and lines of another program's poses (`AMCL`, `PERSON`, `LEG`) are skipped. Throws carmen::LogError,
/// with `file_name` and the line, for any other line, a count of ranges that is not N, and a log without scans.
[[nodiscard]] std::vector<carmen::Event> parse_text_log(std::string_view text, const std::string& file_name,
                                                        const Pose2& base_from_laser);

}  // namespace tandem
