#include "bench/localization/map_fit.hpp"

#include <map>

#include "services/localization/core/beams.hpp"
#include "services/mapping/core/distance_field.hpp"

namespace tandem::bench {
namespace {

constexpr double kNearM = 0.2;
constexpr double kLongestM = 25.0;

struct Ends {
  std::size_t near = 0;
  std::size_t all = 0;
  [[nodiscard]] double share() const { return all > 0 ? static_cast<double>(near) / static_cast<double>(all) : 0.0; }
};

Ends ends_of(const LaserScan& scan, const Pose2& map_from_base, const DistanceField& distances) {
  Ends ends;
  for (const Eigen::Vector2d& endpoint : selected_endpoints(scan, scan.ranges_m.size(), kLongestM, {})) {
    const Eigen::Vector2d end = map_from_base * endpoint;
    ++ends.all;
    ends.near += distances.contains(end) && distances.nearest(end) <= kNearM ? 1 : 0;
  }
  return ends;
}

}  // namespace

MapFit map_fit_of(const RecordedLog& log, const std::vector<RunStep>& steps) {
  const DistanceField distances{log.map, 1.0};
  std::map<Time, const LaserScan*> scans;
  MapFit fit;
  for (const LogEvent& event : log.events) {
    const auto* scan = std::get_if<LaserScan>(&event);
    if (scan == nullptr) continue;
    scans[scan->time] = scan;
    ++fit.scans;
  }
  if (scans.empty() || steps.empty()) return fit;
  Ends all;
  Ends ok;
  std::size_t ok_count = 0;
  for (const RunStep& step : steps) {
    const Ends ends = ends_of(*scans.at(step.result.time), step.result.map_from_base, distances);
    all.near += ends.near;
    all.all += ends.all;
    fit.update_ms += step.update_ms / static_cast<double>(steps.size());
    if (step.result.status != LocalizationStatus::Ok) continue;
    ok.near += ends.near;
    ok.all += ends.all;
    if (ok_count++ == 0) fit.first_ok_s = to_seconds(step.result.time - scans.begin()->first);
  }
  fit.poses = steps.size();
  fit.ok_share = static_cast<double>(ok_count) / static_cast<double>(fit.scans);
  fit.near_wall = all.share();
  fit.near_wall_ok = ok.share();
  return fit;
}

}  // namespace tandem::bench
