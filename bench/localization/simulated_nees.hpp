#pragma once

#include "bench/localization/simulated_drive.hpp"
#include "services/localization/core/localization_config.hpp"

namespace tandem::bench {

/// How wrong the poses of simulated drives are, and how wrong they claim to be.
struct SimulatedErrors {
  std::size_t scans = 0;
  double nees = 0.0;     ///< mean normalised squared error over its expectation, 3: 1 is honest
  double along_m = 0.0;  ///< root mean square errors, seen from the robot ...
  double across_m = 0.0;
  double turn_rad = 0.0;
  double claimed_along_m = 0.0;  ///< ... and the root mean variances that were published
  double claimed_across_m = 0.0;
  double claimed_turn_rad = 0.0;
};

/// Drives with seeds 1, 2, ... `drives`, each from a start that is as wrong as `config` says starts are.
[[nodiscard]] SimulatedErrors simulated_errors(const LocalizationConfig& config, const DriveOptions& options,
                                               std::uint64_t drives);

}  // namespace tandem::bench
