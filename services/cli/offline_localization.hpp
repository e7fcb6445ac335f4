#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "services/cli/kidnapping.hpp"
#include "services/localization/core/input_faults.hpp"
#include "services/localization/core/localization_config.hpp"
#include "services/localization/core/trajectory_errors.hpp"
#include "services/mapping/core/occupancy_grid.hpp"
#include "services/recorder/core/mcap_reader.hpp"

namespace tandem::cli {

/// What `tandem localize` is asked to do with a recording.
struct OfflineOptions {
  LocalizationConfig config;
  std::optional<Kidnapping> kidnapping;
};

struct OfflineResult {
  std::vector<EstimatedPose> poses;   ///< one per scan that was used
  std::vector<double> update_ms;      ///< thread CPU time for each, since the one before
  std::vector<double> way_m;          ///< how far the wheels had driven at each
  std::size_t before_kidnapping = 0;  ///< so many of the poses; with their times of the recording, as all
  InputFaults faults;                 ///< what could not be used as it came
  double map_scale = 1.0;             ///< with InputFault::MapScaleWrong
  std::size_t damaged = 0;            ///< messages that could not be read
};

/// Feeds the recording to the localizer in its order: exactly what tandem-localization does in lockstep replay.
///
/// `keep_going` hears the share done, and ends the run with false.
[[nodiscard]] OfflineResult localize_offline(mcap::Reader& recording, const OccupancyGrid& map,
                                             const OfflineOptions& options,
                                             const std::function<bool(double)>& keep_going);

}  // namespace tandem::cli
