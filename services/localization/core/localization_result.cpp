#include "services/localization/core/localization_result.hpp"

#include <algorithm>

namespace tandem {
namespace {

constexpr double kOneHypothesis = 0.9;  ///< Weight of a group that leaves no doubt.

}  // namespace

std::vector<PoseHypothesis> other_groups(const std::vector<Cluster>& groups) {
  std::vector<PoseHypothesis> others;
  if (groups.empty() || groups.front().weight >= kOneHypothesis) return others;
  for (std::size_t i = 1; i < groups.size(); ++i) others.push_back({groups[i].map_from_base, groups[i].weight});
  return others;
}

std::vector<PoseHypothesis> other_places(const Finding& finding, const Pose2& here) {
  std::vector<PoseHypothesis> others;
  for (const PoseHypothesis& place : finding.places) {
    if (!PlaceFinder::is_same(place.map_from_base, here)) others.push_back(place);
  }
  return others;
}

LocalizationResult result_of(const OdometrySample& odometry, const PoseFit& fit, LocalizationStatus status,
                             const std::vector<PoseHypothesis>& others) {
  LocalizationResult result{.time = odometry.time,
                            .odometry_epoch = odometry.epoch,
                            .map_from_base = fit.pose.map_from_base,
                            .covariance = fit.pose.covariance,
                            .agreement = fit.agreement,
                            .status = status,
                            .hypotheses = {{fit.pose.map_from_base, 1.0}}};
  for (const PoseHypothesis& other : others) {
    result.hypotheses.front().weight -= other.weight;
    result.hypotheses.push_back(other);
  }
  if (!others.empty() && status == LocalizationStatus::Ok) result.status = LocalizationStatus::Uncertain;
  std::stable_sort(result.hypotheses.begin(), result.hypotheses.end(),
                   [](const PoseHypothesis& a, const PoseHypothesis& b) { return a.weight > b.weight; });
  return result;
}

}  // namespace tandem
