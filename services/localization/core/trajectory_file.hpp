#pragma once

#include <span>
#include <string>
#include <vector>

#include "services/common/pose2.hpp"
#include "services/common/time.hpp"

namespace tandem {

/// A pose and when the robot was there.
struct TimedPose {
  Time time{};
  Pose2 map_from_base;
};

/// "t x y heading\n": seconds with 6 decimals, metres and radians with 9; the same in every locale.
///
/// The one writer of trajectories: offline and live results are compared byte by byte.
[[nodiscard]] std::string trajectory_line(const TimedPose& pose);

/// All lines, for a file.
[[nodiscard]] std::string trajectory_text(std::span<const TimedPose> poses);

/// Reads what trajectory_text wrote, and any file of `t x y heading` lines; `#` begins a comment line.
///
/// Throws std::runtime_error with `file_name` and line if a line is not four finite numbers.
[[nodiscard]] std::vector<TimedPose> parse_trajectory(const std::string& text, const std::string& file_name);

}  // namespace tandem
