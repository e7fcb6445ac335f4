#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "services/localization/core/trajectory_errors.hpp"
#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::cli {

/// A robot is lifted at one time of a recording and put down where it was at another, while its wheels stand still.
struct Kidnapping {
  std::size_t lifted = 0;    ///< message at which the recording is left ...
  std::size_t put_down = 0;  ///< ... and with which it goes on
  Time lifted_at{};          ///< stamp of the first scan that is left out
  Time put_down_at{};        ///< stamp of the first scan at the other place
  friend bool operator==(const Kidnapping&, const Kidnapping&) = default;
};

/// Where to put the robot down that is lifted at `time`: at a scan drawn with `seed`, at least 10 s from `time`, 20 s
/// from the end and, by `truth`, 3 m away. None where there is no such scan, or nothing at `time`.
[[nodiscard]] std::optional<Kidnapping> kidnapping_at(mcap::Reader& recording, Time time,
                                                      std::span<const TimedPose> truth, std::uint64_t seed);

/// How the localizer took it.
struct Recovery {
  std::optional<double> flagged_s;    ///< until the status was not ok; none: never
  std::optional<double> recovered_s;  ///< until it was ok again, and by the truth right; none: never
  std::optional<double> recovered_m;  ///< way driven until then
  std::size_t ok_but_wrong = 0;       ///< poses that were ok and, by the truth, more than 0.5 m or 10 degrees off
};

/// `poses` are those after the robot was put down, `way_m` how far it had driven since then at each. Without `truth`,
/// what is ok again after it was flagged counts as right.
[[nodiscard]] Recovery recovery_of(std::span<const EstimatedPose> poses, std::span<const double> way_m,
                                   Time put_down_at, std::span<const TimedPose> truth, double truth_offset_s);

}  // namespace tandem::cli
