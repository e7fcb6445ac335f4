#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "services/common/pose2.hpp"

/// Logs of laser robots as the community keeps them: CARMEN's text format, and its re-arrangement as odometry and
/// scans.
namespace tandem::carmen {

/// A log that cannot be used; what() begins with file:line.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Odometry {
  double time_s = 0.0;   ///< as in the log
  Pose2 odom_from_base;  ///< by the wheels alone
  Twist2 velocity{};     ///< where the log tells it
};
struct Scan {
  double time_s = 0.0;
  double angle_min_rad = 0.0;  ///< of the first beam, to the right of the robot; counter-clockwise positive
  double angle_increment_rad = 0.0;
  std::vector<float> ranges_m{};  ///< NaN: no return
  double range_min_m = 0.0;
  double range_max_m = 80.0;  ///< of the SICK LMS scanners in CARMEN logs
  Pose2 base_from_laser{};
};
using Event = std::variant<Odometry, Scan>;

/// The odometry and scans in `text`, in the log's order; before each scan stands an odometry of the same time.
///
/// Two formats, line by line, each may be mixed with `#` comments:
///  - `ODOM x y theta … ipc_time host log_time` and `FLASER n r1..rn x y theta x y theta ipc_time host log_time`. In a
///    corrected log the pose on a FLASER line is a mapper's, and the ODOM line of time 0 after it repeats that pose:
///    the wheel odometry that follows is re-based on it. So the odometry given here is the chain of the relative
///    motions between ODOM lines.
///  - `O t x y theta` and `S t x y theta n r1..rn`: raw odometry already.
///
/// An odometry more than 2 s older than what stands before it is left out: some logs have such lines, whose time was
/// never set, where the odometry was re-based.
///
/// Beams: 180 or 181 one degree apart, 360 or 361 half a degree, from -90 degrees. Throws LogError, with `file_name`
/// and the line, for a line that is not one of these, and for a log without scans.
[[nodiscard]] std::vector<Event> parse_log(std::string_view text, const std::string& file_name);

/// The text of `file`, unpacked if it is gzip. Throws LogError when it cannot be read or is cut short.
[[nodiscard]] std::string read_log_file(const std::string& file);

}  // namespace tandem::carmen
