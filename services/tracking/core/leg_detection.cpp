#include "services/tracking/core/leg_detection.hpp"

#include <algorithm>
#include <cmath>

namespace tandem::tracking {
namespace {

struct Return {
  std::size_t beam = 0;
  double range_m = 0.0;
  Eigen::Vector2d point_in_map{0.0, 0.0};
};

using Cluster = std::vector<Return>;

std::vector<Cluster> clusters_of(const TrackingConfig& config, const LaserScan& scan, const Pose2& at_start,
                                 const Pose2& at_end) {
  std::vector<Cluster> clusters;
  const double beams = std::max<double>(1.0, static_cast<double>(scan.ranges_m.size()) - 1.0);
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    const double range = scan.ranges_m[i];
    if (!(range >= scan.range_min_m && range < scan.range_max_m)) continue;
    const double bearing = scan.angle_min_rad + static_cast<double>(i) * scan.angle_increment_rad;
    const Pose2 map_from_laser = interpolate(at_start, at_end, static_cast<double>(i) / beams);
    const Return hit{i, range, map_from_laser * Eigen::Vector2d{range * std::cos(bearing), range * std::sin(bearing)}};
    // Along a surface seen at right angles neighbouring returns are this far apart; slanted ones a little more.
    const double gap = config.cluster_gap_m + range * std::abs(scan.angle_increment_rad);
    const bool joins = !clusters.empty() && i - clusters.back().back().beam <= 2 &&
                       (clusters.back().back().point_in_map - hit.point_in_map).norm() < gap;
    if (!joins) clusters.emplace_back();
    clusters.back().push_back(hit);
  }
  return clusters;
}

bool explained_by(const DistanceField& map, double margin_m, const Cluster& cluster) {
  const auto on_wall = std::count_if(cluster.begin(), cluster.end(),
                                     [&](const Return& hit) { return map.distance_m(hit.point_in_map) < margin_m; });
  return 2 * on_wall >= static_cast<std::ptrdiff_t>(cluster.size());
}

/// True if what is seen beside the cluster, on the beam next to each of its ends, lies behind it.
bool stands_in_front(const LaserScan& scan, const Cluster& cluster) {
  const auto behind = [&](std::size_t beam, double range_m) {
    const double range = scan.ranges_m[beam];
    return !(range >= scan.range_min_m && range < scan.range_max_m) || range > range_m;
  };
  const Return& first = cluster.front();
  const Return& last = cluster.back();
  return (first.beam == 0 || behind(first.beam - 1, first.range_m)) &&
         (last.beam + 1 >= scan.ranges_m.size() || behind(last.beam + 1, last.range_m));
}

}  // namespace

Time LaserScan::end() const {
  return ranges_m.empty() ? stamp : stamp + from_seconds(beam_interval_s * static_cast<double>(ranges_m.size() - 1));
}

std::vector<Leg> find_legs(const TrackingConfig& config, const LaserScan& scan, const Pose2& map_from_laser_at_start,
                           const Pose2& map_from_laser_at_end, const DistanceField* map) {
  constexpr std::size_t kFewest = 3;  // returns that make a leg where no map vouches for the rest
  std::vector<Leg> legs;
  for (const Cluster& cluster : clusters_of(config, scan, map_from_laser_at_start, map_from_laser_at_end)) {
    const double range = cluster[cluster.size() / 2].range_m;
    if (range > config.max_range_m) continue;
    if (map != nullptr ? explained_by(*map, config.map_margin_m, cluster)
                       : cluster.size() < kFewest || !stands_in_front(scan, cluster)) {
      continue;
    }
    // Each return stands for the width of its beam.
    const double beam_width = range * std::abs(scan.angle_increment_rad);
    const double width = (cluster.back().point_in_map - cluster.front().point_in_map).norm() + beam_width;
    if (width < config.min_leg_width_m || width > config.max_body_width_m) continue;

    Eigen::Vector2d centre{0.0, 0.0};
    for (const Return& hit : cluster) centre += hit.point_in_map / static_cast<double>(cluster.size());
    const Eigen::Vector2d away = (centre - map_from_laser_at_start.position()).normalized();
    legs.push_back({centre + config.leg_depth_m * away, width, range, width > config.max_leg_width_m});
  }
  return legs;
}

std::vector<Sighting> pair_legs(const TrackingConfig& config, const std::vector<Leg>& legs) {
  struct Pair {
    std::size_t a;
    std::size_t b;
    double distance_m;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < legs.size(); ++a) {
    for (std::size_t b = a + 1; b < legs.size(); ++b) {
      const double distance = (legs[a].centre_in_map - legs[b].centre_in_map).norm();
      if (!legs[a].body && !legs[b].body && distance <= config.max_stride_m) pairs.push_back({a, b, distance});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& x, const Pair& y) { return x.distance_m < y.distance_m; });

  std::vector<Sighting> sightings;
  std::vector<bool> taken(legs.size(), false);
  for (const Pair& pair : pairs) {
    if (taken[pair.a] || taken[pair.b]) continue;
    taken[pair.a] = taken[pair.b] = true;
    sightings.push_back(
        {0.5 * (legs[pair.a].centre_in_map + legs[pair.b].centre_in_map), config.pair_deviation_m, true});
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (taken[i]) continue;
    const double deviation = legs[i].body ? config.pair_deviation_m : config.single_deviation_m;
    sightings.push_back({legs[i].centre_in_map, deviation, legs[i].body});
  }
  return sightings;
}

}  // namespace tandem::tracking
