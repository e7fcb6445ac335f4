#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "services/common/time.hpp"
#include "services/recorder/core/mcap_reader.hpp"
#include "services/tracking/core/track_score.hpp"
#include "services/tracking/core/tracking_config.hpp"

namespace tandem::cli {

/// A person as somebody marked them in a scan.
struct Annotation {
  Time time{};
  std::string id;
  Eigen::Vector2d position_in_laser{0.0, 0.0};
};

/// The `PERSON t id x y` lines of a text log (x forward, y left of the laser [m]), in the order of their times; all
/// other lines are skipped. Throws std::runtime_error, with `file_name` and the line, for one that is cut short.
[[nodiscard]] std::vector<Annotation> parse_annotations(std::string_view text, const std::string& file_name);

struct TrackingRun {
  tracking::TrackScore people{0.5};  ///< at the annotations; without any, at each scan
  /// The first person annotated, as a teammate who presses *My pose* every ten seconds.
  std::size_t named = 0;
  std::size_t followed = 0;              ///< annotations of whom the teammate was within the gate
  std::size_t to_follow = 0;             ///< annotations of that person
  std::vector<double> teammate_error_m;  ///< at each of them
  std::vector<double> scan_ms;           ///< processor time
};

/// Runs the tracker's core over the scans of a recording, without a map, in the odometry's frame, or in the laser's own
/// where no odometry was recorded. `keep_going` hears the share that is done.
[[nodiscard]] TrackingRun track_offline(mcap::Reader& recording, const tracking::TrackingConfig& config,
                                        const std::vector<Annotation>& truth,
                                        const std::function<bool(double)>& keep_going);

}  // namespace tandem::cli
