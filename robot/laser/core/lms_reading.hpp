#pragma once

#include "robot/laser/core/laser_session.hpp"
#include "robot/laser/core/lms_message.hpp"

namespace tandem {

/// A scan of an LMS 2xx that is set to `variant` and `format` and sends at `baud_rate`, 0 where the line takes no time.
///
/// Error codes at the top of the range, and what lies beyond `range_max_m`, are NaN. Has no clock: the mark is the end
/// of the sweep, its delay the time on the line. With half and quarter degrees, neighbours are of different turns of
/// the mirror, and a beam's time is that of the mean turn.
[[nodiscard]] DeviceScan device_scan_of(const lms::ScanData& scan, const lms::Variant& variant,
                                        const lms::RangeFormat& format, int baud_rate, double range_max_m);

}  // namespace tandem
