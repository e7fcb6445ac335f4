#include "services/simulator/core/laser_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/mapping/core/ray_casting.hpp"

namespace tandem::simulator {

double range_to_disc_m(const Eigen::Vector2d& origin_in_map, double heading_rad, const Disc& disc) {
  const Eigen::Vector2d to_centre = disc.centre_in_map - origin_in_map;
  if (to_centre.norm() <= disc.radius_m) return 0.0;
  const Eigen::Vector2d direction{std::cos(heading_rad), std::sin(heading_rad)};
  const double along = to_centre.dot(direction);
  const double aside = direction.x() * to_centre.y() - direction.y() * to_centre.x();
  if (along <= 0.0 || std::abs(aside) >= disc.radius_m) return std::numeric_limits<double>::infinity();
  return along - std::sqrt(disc.radius_m * disc.radius_m - aside * aside);
}

std::vector<double> cast(std::span<const Beam> beams, const Pose2& map_from_laser_at_start,
                         const Pose2& map_from_laser_at_end, const Place& place, std::span<const Disc> legs,
                         const RangeModel& model, Rng& rng) {
  std::vector<double> ranges_m;
  ranges_m.reserve(beams.size());
  for (const auto& beam : beams) {
    const Pose2 map_from_laser = interpolate(map_from_laser_at_start, map_from_laser_at_end, beam.share_of_turn);
    const Eigen::Vector2d origin = map_from_laser.position();
    const double heading = map_from_laser.heading + beam.angle_rad;
    double range = range_to_obstacle_m(place.map(), origin, heading, model.max_m)
                       .value_or(std::numeric_limits<double>::infinity());
    for (const auto& leg : legs) range = std::min(range, range_to_disc_m(origin, heading, leg));
    const double noise = rng.normal() * model.noise_m;  // drawn for every beam: one hit more must not shift the others
    range += noise;
    ranges_m.push_back(range >= model.min_m && range <= model.max_m ? range : std::numeric_limits<double>::quiet_NaN());
  }
  return ranges_m;
}

}  // namespace tandem::simulator
