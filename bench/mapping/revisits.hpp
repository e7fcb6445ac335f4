#pragma once

#include <span>
#include <vector>

#include "services/localization/core/trajectory_file.hpp"

namespace tandem::bench {

/// A place to which the robot came back, by the reference.
struct Revisit {
  TimedPose earlier;
  TimedPose later;
};

/// When two poses of a reference are a revisit.
struct RevisitOptions {
  double near_m = 3.0;        ///< The two are this close ...
  double least_way_m = 50.0;  ///< ... with at least this way in between.
  double every_m = 5.0;       ///< One is taken on each such way.
};

/// The revisits of a way: each with the nearest of the poses long before.
[[nodiscard]] std::vector<Revisit> revisits_of(std::span<const TimedPose> truth, const RevisitOptions& options);

/// How far off the estimated motion from the earlier to the later pose of each revisit is [m], the smallest first;
/// revisits at whose times nothing was estimated are left out. `estimate` is ordered by time.
[[nodiscard]] std::vector<double> revisit_errors_m(std::span<const Revisit> revisits,
                                                   std::span<const TimedPose> estimate);

}  // namespace tandem::bench
