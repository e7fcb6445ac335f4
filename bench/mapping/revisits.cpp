#include "bench/mapping/revisits.hpp"

#include <algorithm>
#include <limits>

#include "services/localization/core/trajectory_errors.hpp"

namespace tandem::bench {

std::vector<Revisit> revisits_of(std::span<const TimedPose> truth, const RevisitOptions& options) {
  std::vector<Revisit> revisits;
  std::vector<double> way_m(truth.size(), 0.0);
  double next_m = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    way_m[i] = way_m[i - 1] + (truth[i].map_from_base.position() - truth[i - 1].map_from_base.position()).norm();
    if (way_m[i] < next_m) continue;
    double nearest_m = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t k = 0; k < i && way_m[k] <= way_m[i] - options.least_way_m; ++k) {
      const double distance_m = (truth[i].map_from_base.position() - truth[k].map_from_base.position()).norm();
      if (distance_m >= nearest_m) continue;
      nearest_m = distance_m;
      nearest = k;
    }
    if (nearest_m > options.near_m) continue;
    revisits.push_back({truth[nearest], truth[i]});
    next_m = way_m[i] + options.every_m;
  }
  return revisits;
}

std::vector<double> revisit_errors_m(std::span<const Revisit> revisits, std::span<const TimedPose> estimate) {
  std::vector<double> errors;
  for (const Revisit& revisit : revisits) {
    const auto earlier = pose_at(estimate, revisit.earlier.time);
    const auto later = pose_at(estimate, revisit.later.time);
    if (!earlier || !later) continue;
    const Pose2 motion = inverse(revisit.earlier.map_from_base) * revisit.later.map_from_base;
    errors.push_back((inverse(motion) * (inverse(*earlier) * *later)).position().norm());
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

}  // namespace tandem::bench
